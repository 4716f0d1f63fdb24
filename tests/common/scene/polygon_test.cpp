#include "common/scene/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace gibench::test {
namespace {

/// A polygon in the plane z = 0, and its signed area by the shoelace formula.
struct Polygon {
  std::string name;
  std::vector<Vec3d> corners;
  double area() const {
    double doubled = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) doubled += glm::cross(corners[i], corners[(i + 1) % corners.size()]).z;
    return 0.5 * doubled;
  }
};

std::vector<Polygon> simple_polygons() {
  std::vector<Polygon> polygons{
      {"L", {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}},
      {"U", {{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}},
      {"straight corners", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}}},
      {"window", {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}}},
  };
  Polygon star{"star", {}}, spiral{"spiral", {}};
  for (int i = 0; i < 40; ++i) {
    const double angle = 2.0 * pi_double * i / 40.0, radius = i % 2 == 0 ? 1.0 : 0.2;
    star.corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  for (const double width : {1.0, 0.8})
    for (int i = 0; i < 60; ++i) {
      const double along = width == 1.0 ? i : 59 - i;
      const double angle = 0.3 * along, radius = width * (1.0 + 0.1 * along);
      spiral.corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
  polygons.push_back(star);
  polygons.push_back(spiral);
  return polygons;
}

/// Every triangle turns with the polygon and the areas add up: then they cover it without overlap.
void expect_covered(const std::string& name, const std::vector<Vec3d>& corners, const Vec3d& normal, double area) {
  double sum = 0.0;
  const auto triangles = triangulate_polygon(corners);
  EXPECT_EQ(triangles.size(), corners.size() - 2) << name;
  for (const auto& [a, b, c] : triangles) {
    const double part = 0.5 * glm::dot(normal, glm::cross(corners[b] - corners[a], corners[c] - corners[a]));
    EXPECT_GE(part, -1e-12) << name;
    sum += part;
  }
  EXPECT_NEAR(sum, std::fabs(area), 1e-9) << name;
}

TEST(Polygon, ConcavePolygonsAreCovered) {
  for (const Polygon& polygon : simple_polygons())
    for (std::size_t first = 0; first < polygon.corners.size(); ++first) {  // whichever corner comes first
      std::vector<Vec3d> turned(polygon.corners.begin() + static_cast<std::ptrdiff_t>(first), polygon.corners.end());
      turned.insert(turned.end(), polygon.corners.begin(), polygon.corners.begin() + static_cast<std::ptrdiff_t>(first));
      expect_covered(polygon.name, turned, {0, 0, polygon.area() > 0.0 ? 1 : -1}, polygon.area());
    }
}

TEST(Polygon, AnyPlaneAndEitherOrientation) {
  const Polygon window = simple_polygons()[3];
  for (const int direction : {1, -1})
    for (const int axis : {0, 1, 2}) {
      std::vector<Vec3d> turned;
      for (const Vec3d& p : window.corners) {
        Vec3d q(0.0);
        q[(axis + 1) % 3] = p.x, q[(axis + 2) % 3] = p.y;
        turned.push_back(q);
      }
      if (direction < 0) turned = {turned.rbegin(), turned.rend()};
      Vec3d normal(0.0);
      normal[axis] = direction;
      expect_covered("window", turned, normal, 12.0);
    }
}

TEST(Polygon, CrossedAndDegeneratePolygonsEnd) {
  EXPECT_EQ(triangulate_polygon(std::vector<Vec3d>(7, Vec3d(1.0))).size(), 5U);
  EXPECT_EQ(triangulate_polygon(std::vector<Vec3d>{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 2, 0}}).size(), 3U);
  const double nan = std::nan("");
  EXPECT_EQ(triangulate_polygon(std::vector<Vec3d>{{0, 0, 0}, {1, nan, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 2, 0}}).size(), 3U);
}

TEST(Polygon, TenThousandCornersThatCrossEnd) {
  std::vector<Vec3d> corners;  // the cube of their number would take hours
  for (int i = 0; i < 10000; ++i) corners.emplace_back((7919 * i) % 9973, (104729 * (i % 8191)) % 8191, 0.0);
  EXPECT_EQ(triangulate_polygon(corners).size(), corners.size() - 2);
}

}  // namespace
}  // namespace gibench::test
