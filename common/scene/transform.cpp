#include "common/scene/transform.h"

#include <cmath>
#include <glm/matrix.hpp>
#include <utility>

namespace gibench {

namespace {

/// (cos, sin) of an angle; exact for multiples of 90°, so that a turned box stays a box.
std::pair<double, double> cosine_and_sine(double degrees) {
  const double turn = std::remainder(degrees, 360.0);
  if (turn == 0.0) return {1.0, 0.0};
  if (turn == 90.0) return {0.0, 1.0};
  if (turn == -90.0) return {0.0, -1.0};
  if (std::fabs(turn) == 180.0) return {-1.0, 0.0};
  const double angle = turn * pi_double / 180.0;
  return {std::cos(angle), std::sin(angle)};
}

/// Right-handed rotation about a coordinate axis (0: x, 1: y, 2: z). GLM matrices are indexed [column][row].
glm::dmat3 rotation(int axis, double degrees) {
  const auto [c, s] = cosine_and_sine(degrees);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  glm::dmat3 matrix(1.0);
  matrix[u][u] = c, matrix[u][v] = s;
  matrix[v][u] = -s, matrix[v][v] = c;
  return matrix;
}

}  // namespace

bool Transform::mirrors() const { return glm::determinant(linear) < 0.0; }

Transform make_transform(const Vec3d& scale, const Vec3d& rotate_degrees, const Vec3d& translate) {
  glm::dmat3 scaling(0.0);
  for (int i = 0; i < 3; ++i) scaling[i][i] = scale[i];
  return {rotation(2, rotate_degrees.z) * rotation(1, rotate_degrees.y) * rotation(0, rotate_degrees.x) * scaling, translate};
}

void transform_geometry(const Transform& transform, ObjectGeometry& geometry) {
  for (Vec3d& v : geometry.vertices) v = transform.apply(v);
  if (!transform.mirrors()) return;
  for (Face& face : geometry.faces) {
    auto& [a, b, c, d] = face.corners;
    if (face.is_quad()) std::swap(b, d);
    else std::swap(a, b);
  }
}

}  // namespace gibench
