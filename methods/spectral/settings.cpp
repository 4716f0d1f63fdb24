#include "methods/spectral/settings.h"

namespace gibench::spectral {

namespace {

using Choices = std::vector<std::string>;

ParameterSpec whole(const char* name, std::int64_t value, double least, double most, const char* meaning) {
  return {name, value, least, most, {}, meaning};
}
ParameterSpec real(const char* name, double value, double least, double most, const char* meaning) {
  return {name, value, least, most, {}, meaning};
}
ParameterSpec choice(const char* name, Choices choices, const char* meaning) {
  return {name, choices.front(), 0.0, 0.0, choices, meaning};
}

}  // namespace

ParameterSchema settings_schema() {
  return {
      whole("vertices", 8000, 1, 4e6, "vertices wanted in the sampling mesh: large faces are cut; a finer scene keeps its own"),
      real("crease_degrees", 40.0, 0.0, 180.0, "largest angle between faces that share a vertex, degrees"),
      whole("part_vertices", 1000, 1, 1e6, "vertices of a submesh, about"),
      whole("basis_functions", 1024, 1, 65528, "basis functions of the whole scene, about; at most one for every vertex"),
      choice("laplacian", {"cotan", "graph"}, "weights by cotangents and areas, or the paper's 1 and -1/valence"),
      choice("mode", {"bounces", "fixed_albedo"},
             "one bounce in the matrix, albedos free; or all bounces in it (T*), albedos as prepared"),
      whole("rays", 1024, 1, 1 << 20, "rays of a vertex"),
      real("compression_error", 0.01, 0.0, 1.0,
           "share of the indirect light that 16-bit quantisation and truncation may add; 0: 32 bits, nothing dropped"),
      whole("bounces", 1000, 1, 100000, "most bounces that are computed"),
      real("residual", 1e-3, 1e-9, 1.0, "the bounces end when those left out hold less, share of the solution"),
      choice("direct", {"shared", "basis"}, "direct light is answered by the shared evaluator, or as the basis holds it"),
      whole("direct_points", 4, 1, 4096, "points of a mesh triangle at which its direct light is taken"),
      whole("direct_samples", 1, 1, 65536, "light samples at such a point"),
  };
}

Settings settings_from(const Parameters& parameters) {
  const auto whole_of = [&](const char* name) { return static_cast<int>(parameters.whole(name)); };
  Settings settings;
  settings.vertices = whole_of("vertices");
  settings.crease_degrees = parameters.real("crease_degrees");
  settings.part_vertices = whole_of("part_vertices");
  settings.basis_functions = whole_of("basis_functions");
  settings.laplacian = parameters.text("laplacian") == "cotan" ? Laplacian::cotan : Laplacian::graph;
  settings.mode = parameters.text("mode") == "bounces" ? Mode::bounces : Mode::fixed_albedo;
  settings.rays = whole_of("rays");
  settings.compression_error = parameters.real("compression_error");
  settings.bounces = whole_of("bounces");
  settings.residual = parameters.real("residual");
  settings.direct = parameters.text("direct") == "shared" ? DirectAnswer::shared : DirectAnswer::basis;
  settings.direct_points = whole_of("direct_points");
  settings.direct_samples = whole_of("direct_samples");
  return settings;
}

}  // namespace gibench::spectral
