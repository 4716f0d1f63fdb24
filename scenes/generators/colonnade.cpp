#include "scenes/generators/colonnade.h"

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "scenes/generators/column.h"
#include "scenes/generators/figure.h"
#include "scenes/generators/scene_writer.h"

namespace gibench::generators {

namespace {

using Json = nlohmann::ordered_json;

// Metres.
constexpr int columns_per_row = 7, figures = 5;
constexpr double spacing = 2.4, row_distance = 4.8, arch_depth = 0.62;
constexpr double length = spacing * (columns_per_row - 1), step_height = 0.17, pedestal_height = 0.9;

/// A platform of three steps without hidden faces: upright risers, level treads and the floor.
Mesh terrace() {
  const double half_length = 0.5 * length + 1.0, half_width = 0.5 * row_distance + 1.0, tread = 0.35;
  const auto corner = [&](int steps_down, int treads_out) {
    return Vec3d(half_length + tread * treads_out, -step_height * steps_down, half_width + tread * treads_out);
  };
  Mesh mesh;
  for (const auto& [x, z] : {std::pair{1, 1}, {1, -1}, {-1, -1}, {-1, 1}}) mesh.vertices.push_back(corner(0, 0) * Vec3d(x, 1, z));
  mesh.faces.push_back({0, 1, 2, 3});
  for (int step = 0; step < 3; ++step) {
    mesh.append(frame(corner(step, step), corner(step + 1, step)));
    if (step < 2) mesh.append(frame(corner(step + 1, step), corner(step + 1, step + 1)));
  }
  return mesh;
}

/// The terrace on its ground, rows of columns, arches and the beams over them.
void build_hall(SceneWriter& writer, const ColumnShape& shape) {
  const double half_length = 0.5 * length, half_width = 0.5 * row_distance;
  writer.model("terrace", terrace());
  const Vec3d foot(half_length + 1.7, -3.0 * step_height, half_width + 1.7);
  writer.model("ground", frame(foot, foot + Vec3d(4.0, 0.0, 4.0)));
  writer.model("column", column(shape));
  const double inner = 0.5 * spacing - 0.42, outer = 0.5 * spacing - 0.01;
  writer.model("arch", arch(inner, outer, arch_depth, 48));
  writer.model("beam", block({-half_length - 0.6, 0.0, -0.36}, {half_length + 0.6, 0.5, 0.36}));
  writer.place("ground", "ground", "earth");
  writer.place("terrace", "terrace", "paving");
  for (int side = -1; side <= 1; side += 2) {
    const std::string row = side < 0 ? "north" : "south";
    const double z = side * half_width;
    for (int i = 0; i < columns_per_row; ++i) {
      const double x = -half_length + spacing * i;
      writer.place(row + " column " + std::to_string(i + 1), "column", "marble", {{x, -0.005, z}});
      if (i + 1 < columns_per_row)
        writer.place(row + " arch " + std::to_string(i + 1), "arch", "limestone", {{x + 0.5 * spacing, shape.height - 0.01, z}});
    }
    writer.place(row + " beam", "beam", "limestone", {{0.0, shape.height + outer - 0.02, z}});
  }
}

/// A different figure on each pedestal, in turn on either side of the middle.
void build_figures(SceneWriter& writer) {
  writer.model("pedestal", block({-0.45, -0.005, -0.45}, {0.45, pedestal_height, 0.45}));
  for (int i = 0; i < figures; ++i) {
    const std::string number = std::to_string(i + 1), model = "figure-" + number;
    const double x = -0.5 * length + spacing * (i + 1), z = i % 2 == 0 ? -1.15 : 1.15;
    writer.model(model, figure(static_cast<std::uint64_t>(i) + 1));
    writer.place("pedestal " + number, "pedestal", "limestone", {{x, 0.0, z}});
    writer.place("figure " + number, model, i == 2 ? "bronze" : "marble", {{x, pedestal_height - 0.005, z}, -70.0 + 20.0 * i});
  }
}

Json materials() {
  const auto diffuse = [](double r, double g, double b) { return Json{{"bsdf", "diffuse"}, {"albedo", {r, g, b}}}; };
  return {{"marble", diffuse(0.78, 0.76, 0.72)},
          {"limestone", diffuse(0.66, 0.60, 0.50)},
          {"paving", diffuse(0.55, 0.50, 0.45)},
          {"earth", diffuse(0.25, 0.22, 0.14)},
          {"bronze", diffuse(0.30, 0.20, 0.10)}};
}

}  // namespace

std::size_t write_colonnade(const std::filesystem::path& folder) {
  SceneWriter writer(folder, "colonnade");
  build_hall(writer, ColumnShape{});
  build_figures(writer);
  Json rest{{"description",
             "Two rows of fluted columns joined by arches, draped figures between them, under sun and sky; "
             "made by scenes/generators/."},
            {"materials", materials()}};
  rest["lights"] = {{{"type", "directional"}, {"direction", {0.55, -0.75, -0.5}}, {"irradiance", {9.0, 8.2, 7.0}}},
                    {{"type", "environment"}, {"radiance", {0.45, 0.6, 0.9}}}};
  rest["cameras"] = {{{"name", "main"},
                      {"position", {-8.6, 1.7, 0.5}},
                      {"look_at", {0.0, 2.1, -0.3}},
                      {"vertical_fov_degrees", 55.0},
                      {"resolution", {320, 240}}},
                     {{"name", "figure"},
                      {"position", {1.6, 1.9, 1.2}},
                      {"look_at", {0.0, 1.9, -1.15}},
                      {"vertical_fov_degrees", 45.0},
                      {"resolution", {256, 256}}}};
  rest["exposure"] = {{"value", -1.0}, {"start", -4.0}, {"stop", 3.0}};
  return writer.write(rest);
}

}  // namespace gibench::generators
