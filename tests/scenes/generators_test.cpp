/// The procedural meshes are closed, two-manifold, face outwards and have no degenerate face.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "common/core/error.h"
#include "scenes/generators/colonnade.h"
#include "scenes/generators/column.h"
#include "scenes/generators/figure.h"
#include "tests/scenes/mesh_facts.h"
#include "tests/support/check_failed.h"

namespace gibench::generators {
namespace {

void expect_closed(const Mesh& mesh, double least_volume, double most_volume) {
  const MeshFacts facts = facts_of(mesh);
  EXPECT_EQ(facts.unmatched_edges, 0U);
  EXPECT_EQ(facts.degenerate_faces, 0U);
  EXPECT_GT(facts.volume, least_volume);
  EXPECT_LT(facts.volume, most_volume);
}

TEST(Generators, ABlockHasItsVolume) { expect_closed(block({1, 2, 3}, {2, 4, 6}), 5.999999, 6.000001); }

TEST(Generators, ASphereGridIsClosedAndHasNearlyItsVolume) {
  const Mesh sphere = closed_grid(60, 90, [](double row, double angle) {
    const double latitude = pi_double * (row - 0.5);
    return Vec3d(std::cos(latitude) * std::cos(angle), std::sin(latitude), -std::cos(latitude) * std::sin(angle));
  });
  const double exact = 4.0 / 3.0 * pi_double;
  expect_closed(sphere, 0.99 * exact, exact);
  EXPECT_EQ(sphere.triangle_count(), 90U * 2U + 58U * 90U * 2U);
}

TEST(Generators, AnArchIsClosedAndHasNearlyItsVolume) {
  const double exact = 0.5 * pi_double * (4.0 - 1.0) * 0.5;
  expect_closed(arch(1.0, 2.0, 0.5, 64), 0.995 * exact, exact);
}

TEST(Generators, AFrameFacesUpAndOutwards) {
  const Mesh level = frame({1, 0, 2}, {3, 0, 5}), upright = frame({1, 2, 1}, {1, 0, 1});
  double area = 0.0;
  for (const Mesh& mesh : {level, upright})
    for (const auto& [a, b, c, d] : mesh.faces) {
      const Vec3d area_vector = 0.5 * glm::cross(mesh.vertices[c] - mesh.vertices[a], mesh.vertices[d] - mesh.vertices[b]);
      const Vec3d middle = 0.25 * (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c] + mesh.vertices[d]);
      EXPECT_GT(glm::dot(area_vector, mesh.vertices[a].y == mesh.vertices[c].y ? Vec3d(0, 1, 0) : middle * Vec3d(1, 0, 1)), 0.0);
      area += glm::length(area_vector);
    }
  EXPECT_DOUBLE_EQ(area, (6.0 * 10.0 - 2.0 * 4.0) + 4.0 * 4.0);
}

TEST(Generators, AColumnIsClosedAndAsTallAsAsked) {
  const ColumnShape shape;
  const Mesh mesh = column(shape);
  const double full_shaft = pi_double * shape.lower_radius * shape.lower_radius * shape.height;
  expect_closed(mesh, 0.6 * full_shaft, 1.2 * full_shaft);
  double low = 1e9, high = -1e9;
  for (const Vec3d& vertex : mesh.vertices) low = std::min(low, vertex.y), high = std::max(high, vertex.y);
  EXPECT_DOUBLE_EQ(low, 0.0);
  EXPECT_DOUBLE_EQ(high, shape.height);
}

TEST(Generators, FiguresAreClosedAndDiffer) {
  const Mesh first = figure(1), again = figure(1), second = figure(2);
  expect_closed(first, 0.1, 0.5);
  expect_closed(second, 0.1, 0.5);
  EXPECT_EQ(first.vertices, again.vertices) << "the same seed gives the same figure";
  ASSERT_EQ(first.vertices.size(), second.vertices.size());
  EXPECT_NE(first.vertices, second.vertices);
}

TEST(Generators, TheColonnadeHasAtLeastAHundredThousandTriangles) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "gibench-colonnade";
  EXPECT_GE(write_colonnade(folder), 100'000U);
  EXPECT_TRUE(std::filesystem::exists(folder / "colonnade.scene.json"));
  std::filesystem::remove_all(folder);
}

TEST(Generators, AFolderThatCannotBeWrittenIsAnInputError) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "gibench-not-a-folder";
  std::ofstream(file) << "a file";
  EXPECT_THROW(write_colonnade(file), InputError);
  std::filesystem::remove(file);
}

TEST(Generators, AGridNeedsRowsAndColumns) {
  EXPECT_THAT([&] { closed_grid(1, 8, [](double, double) { return Vec3d(0.0); }); },
              test::fails_check("two rows and three columns"));
}

}  // namespace
}  // namespace gibench::generators
