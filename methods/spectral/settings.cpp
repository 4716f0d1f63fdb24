#include "methods/spectral/settings.h"

#include "common/method/parameter_table.h"

namespace gibench::spectral {

namespace {

const ParameterTable<Settings>& table() {
  static const ParameterTable<Settings> made{
      parameter(
          "vertices", &Settings::vertices, 0, 4e6,
          "vertices wanted in the sampling mesh: large faces are cut, and what is finer comes together in clusters; 0: 8000, "
          "or 16 000 where the scene has more than 32 000 triangles"),
      parameter(
          "nodes", &Settings::nodes, {{"clusters", NodeKind::clusters}, {"vertices", NodeKind::vertices}},
          "a mesh of many more vertices is held in clusters of them, small loose pieces are joined; or every vertex and every "
          "piece by itself (the paper)"),
      parameter("crease_degrees", &Settings::crease_degrees, 0.0, 180.0,
                "largest angle between faces that share a vertex, degrees"),
      parameter("part_vertices", &Settings::part_vertices, 0, 1e6, "vertices of a submesh, about; 0: 1000, or 500 clusters"),
      parameter("basis_functions", &Settings::basis_functions, 0, 65528,
                "basis functions of the whole scene, about; at most one for every vertex; 0: 1024, or more for many clusters"),
      parameter("laplacian", &Settings::laplacian, {{"cotan", Laplacian::cotan}, {"graph", Laplacian::graph}},
                "weights by cotangents and areas, or the paper's 1 and -1/valence"),
      parameter("mode", &Settings::mode, {{"bounces", Mode::bounces}, {"fixed_albedo", Mode::fixed_albedo}},
                "one bounce in the matrix, albedos free; or all bounces in it (T*), albedos as prepared"),
      parameter("rays", &Settings::rays, 0, 1 << 20, "rays of a vertex; 0: 1024, or 2048 of a cluster"),
      parameter(
          "compression", &Settings::compression, {{"judged", Compression::judged}, {"rounding", Compression::rounding}},
          "16 bits a coefficient: truncated as far as compression_error lets it, or what rounds to zero dropped (the paper)"),
      parameter("compression_error", &Settings::compression_error, -1.0, 1.0,
                "share of the indirect light that quantisation and truncation may add; 0: 32 bits, nothing dropped; -1: 0.01, or "
                "0.02 of clusters"),
      parameter("bounces", &Settings::bounces, 1, 100000, "most bounces that are computed"),
      parameter("residual", &Settings::residual, 1e-9, 1.0,
                "the bounces end when those left out hold less, share of the solution"),
      parameter("direct", &Settings::direct, {{"shared", DirectAnswer::shared}, {"basis", DirectAnswer::basis}},
                "direct light is answered by the shared evaluator, or as the basis holds it"),
      parameter("direct_points", &Settings::direct_points, 1, 4096,
                "points of a mesh triangle at which its direct light is taken"),
      parameter("direct_samples", &Settings::direct_samples, 1, 65536, "light samples at such a point"),
  };
  return made;
}

}  // namespace

ParameterSchema settings_schema() { return table().schema(); }

std::vector<Preset> presets() {
  return {{"paper",
           "the text's algorithm and constants: plain graph Laplacian, 16 bits that round small values away, 128 x 128 rays",
           {{"laplacian", "graph"},
            {"vertices", "30000"},
            {"nodes", "vertices"},
            {"part_vertices", "1000"},
            {"basis_functions", "1024"},
            {"rays", "16384"},
            {"compression", "rounding"}}}};
}

Settings settings_from(const Parameters& parameters) { return table().read(parameters); }

}  // namespace gibench::spectral
