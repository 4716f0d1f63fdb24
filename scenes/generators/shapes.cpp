#include "scenes/generators/shapes.h"

#include <algorithm>
#include <cmath>

#include "common/core/error.h"

namespace gibench::generators {

namespace {

Vec3d turned(const Vec3d& point, const Vec3d& degrees) {
  Vec3d p = point;
  for (int axis = 0; axis < 3; ++axis) {
    const double angle = degrees[axis] * pi_double / 180.0, c = std::cos(angle), s = std::sin(angle);
    const int first = (axis + 1) % 3, second = (axis + 2) % 3;
    const double a = p[first], b = p[second];
    p[first] = c * a - s * b;
    p[second] = s * a + c * b;
  }
  return p;
}

double signed_power(double x, double exponent) { return std::copysign(std::pow(std::abs(x), exponent), x); }

/// Any direction across `ahead`, as near to `wanted` as there is.
Vec3d across(const Vec3d& ahead, const Vec3d& wanted) {
  const Vec3d rest = wanted - glm::dot(wanted, ahead) * ahead;
  if (glm::length(rest) > 1e-3) return glm::normalize(rest);
  return across(ahead, std::abs(ahead.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 0, 1));
}

}  // namespace

Mesh placed(Mesh mesh, const Vec3d& translate, const Vec3d& rotate_degrees) {
  for (Vec3d& vertex : mesh.vertices) vertex = turned(vertex, rotate_degrees) + translate;
  return mesh;
}

Mesh lathe(const std::vector<ProfilePoint>& profile, int columns) {
  const int rows = static_cast<int>(profile.size()) - 1;
  return closed_grid(rows, columns, [&](double row, double angle) {
    const auto index = static_cast<std::size_t>(std::lround(row * rows));
    const ProfilePoint& point = profile[index];
    const double radius = index == 0 || index + 1 == profile.size() ? 0.0 : point.radius;
    return Vec3d(radius * std::cos(angle), point.y, -radius * std::sin(angle));
  });
}

Mesh pipe(const std::vector<Vec3d>& points, int columns, const std::function<double(double)>& radius) {
  GIBENCH_CHECK(points.size() >= 2, "a pipe runs through two points at least");
  std::vector<Vec3d> ahead(points.size()), side(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    ahead[i] = glm::normalize(points[std::min(i + 1, points.size() - 1)] - points[i == 0 ? 0 : i - 1]);
    side[i] = across(ahead[i], i == 0 ? Vec3d(1, 0, 0) : side[i - 1]);
  }
  const int rows = static_cast<int>(points.size()) + 1;
  return closed_grid(rows, columns, [&](double row, double angle) {
    const long index = std::lround(row * rows);
    if (index == 0) return points.front();
    if (index == rows) return points.back();
    const auto i = static_cast<std::size_t>(index - 1);
    const double size = radius(static_cast<double>(i) / static_cast<double>(points.size() - 1));
    return points[i] + size * (std::cos(angle) * side[i] - std::sin(angle) * glm::cross(side[i], ahead[i]));
  });
}

Mesh pipe(const std::vector<Vec3d>& points, int columns, double radius) {
  return pipe(points, columns, [radius](double) { return radius; });
}

Mesh cushion(const Vec3d& half_size, double exponent, int rows, int columns) {
  return closed_grid(rows, columns, [&](double row, double angle) {
    const double latitude = pi_double * (row - 0.5), ring = signed_power(std::max(0.0, std::cos(latitude)), exponent);
    return half_size * Vec3d(ring * signed_power(std::cos(angle), exponent), signed_power(std::sin(latitude), exponent),
                             -ring * signed_power(std::sin(angle), exponent));
  });
}

Mesh sheet(int rows, int columns, const std::function<Vec3d(double, double)>& point) {
  GIBENCH_CHECK(rows >= 1 && columns >= 1, "a sheet has a row and a column at least");
  Mesh mesh;
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column)
      mesh.vertices.push_back(point(static_cast<double>(column) / columns, static_cast<double>(row) / rows));
  const auto at = [&](int row, int column) { return static_cast<std::uint32_t>(row * (columns + 1) + column); };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      mesh.faces.push_back({at(row, column), at(row, column + 1), at(row + 1, column + 1), at(row + 1, column)});
  return mesh;
}

double between(RandomStream& random, double low, double high) { return low + (high - low) * random.next_double(); }

}  // namespace gibench::generators
