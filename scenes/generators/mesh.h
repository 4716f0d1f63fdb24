/// Closed meshes of the procedural scenes. Metres, y up, faces counter-clockwise seen from outside.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "common/core/vec.h"

namespace gibench::generators {

/// Quads, or triangles that repeat their third corner.
struct Mesh {
  std::vector<Vec3d> vertices;
  std::vector<std::array<std::uint32_t, 4>> faces;

  std::size_t triangle_count() const;
  /// Takes in another mesh as it is; closed parts stay closed.
  void append(const Mesh& other);
};

/// A sphere-like surface: rings of `columns` points between two poles. `point(row, angle)` gives the position for
/// row in [0, 1] from the bottom pole (0) to the top one (1) and the angle in radians, counter-clockwise seen
/// from above; at the poles the angle must not matter. Needs two rows of faces and three columns at least.
Mesh closed_grid(int rows, int columns, const std::function<Vec3d(double row, double angle)>& point);

/// An axis-parallel block.
Mesh block(const Vec3d& low, const Vec3d& high);

/// The four quads between two rectangles about the y axis, at heights inner.y and outer.y, facing up where they are
/// level and outwards where they are upright: corners (±inner.x, ±inner.z) and (±outer.x, ±outer.z). An open surface.
Mesh frame(const Vec3d& inner, const Vec3d& outer);

/// A semicircular arch about the z axis through the origin: a half ring between two radii, from z = -depth/2 to
/// depth/2, its two feet on y = 0.
Mesh arch(double inner_radius, double outer_radius, double depth, int segments);

/// Binary PLY. Throws InputError where it cannot be written.
void write_ply(const Mesh& mesh, const std::filesystem::path& file);

}  // namespace gibench::generators
