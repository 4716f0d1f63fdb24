#include "common/geometry/mesh_topology.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "common/core/random.h"

namespace gibench::test {
namespace {

Face triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { return {{a, b, c, c}}; }

std::vector<std::uint32_t> unwelded(std::size_t count) {
  std::vector<std::uint32_t> weld(count);
  std::iota(weld.begin(), weld.end(), 0U);
  return weld;
}

/// The faces of a cube with corner i at ((i & 1), (i & 2) / 2, (i & 4) / 4), fronts outward.
std::vector<Face> cube_faces() {
  return {{{0, 2, 3, 1}}, {{4, 5, 7, 6}}, {{0, 1, 5, 4}}, {{2, 6, 7, 3}}, {{0, 4, 6, 2}}, {{1, 3, 7, 5}}};
}

TEST(MeshTopology, CubeIsClosed) {
  const MeshTopology cube = mesh_topology(cube_faces(), unwelded(8));
  EXPECT_EQ(cube.edges, 12U);
  EXPECT_EQ(cube.boundary_edges, 0U);
  EXPECT_EQ(cube.non_manifold_edges, 0U);
  EXPECT_EQ(cube.components, 1U);
  EXPECT_TRUE(cube.closed);
  EXPECT_TRUE(cube.oriented());
}

TEST(MeshTopology, OpenCubeHasABoundary) {
  std::vector<Face> faces = cube_faces();
  faces.pop_back();
  const MeshTopology open = mesh_topology(faces, unwelded(8));
  EXPECT_EQ(open.boundary_edges, 4U);
  EXPECT_FALSE(open.closed);
}

TEST(MeshTopology, OneFaceTurnedRoundIsFlipped) {
  std::vector<Face> faces = cube_faces();
  std::swap(faces[0].corners[1], faces[0].corners[3]);
  const MeshTopology turned = mesh_topology(faces, unwelded(8));
  EXPECT_EQ(turned.flipped_edges, 4U);
  EXPECT_TRUE(turned.closed);
  EXPECT_FALSE(turned.oriented());
}

TEST(MeshTopology, FanOfThreeIsNonManifold) {
  const MeshTopology fan = mesh_topology(std::vector{triangle(0, 1, 2), triangle(0, 1, 3), triangle(0, 1, 4)}, unwelded(5));
  EXPECT_EQ(fan.edges, 7U);
  EXPECT_EQ(fan.non_manifold_edges, 1U);
  EXPECT_EQ(fan.boundary_edges, 6U);
  EXPECT_EQ(fan.components, 1U);
}

TEST(MeshTopology, ComponentsAreJoinedByEdgesNotByCorners) {
  const std::vector<Face> bow{triangle(0, 1, 2), triangle(0, 3, 4)};  // share a corner
  EXPECT_EQ(mesh_topology(bow, unwelded(5)).components, 2U);
  std::vector<std::uint32_t> weld = unwelded(5);
  weld[3] = 1;
  EXPECT_EQ(mesh_topology(bow, weld).components, 1U);
}

TEST(MeshTopology, DegenerateFacesHaveNoEdges) {
  const std::vector<Face> faces{triangle(0, 1, 1), triangle(2, 2, 2), {{0, 1, 0, 1}}, {{0, 0, 1, 2}}, {{0, 1, 2, 0}}};
  const MeshTopology topology = mesh_topology(faces, unwelded(3));
  // The third runs to and fro; the last two are the triangle (0, 1, 2).
  EXPECT_EQ(topology.edges, 3U);
  EXPECT_EQ(mesh_topology({}, {}).components, 0U);
  EXPECT_FALSE(mesh_topology({}, {}).closed);
}

TEST(MeshTopology, WeldJoinsWhatRoundingParts) {
  const float ulp = std::nextafter(1.0F, 2.0F) - 1.0F;
  const std::vector<Vec3> vertices{{1, 0, 0}, {1 + ulp, ulp, 0}, {1 + 16 * ulp, 0, 0}, {-1, 0, 0}, {-1, -0.0F, 0}};
  const auto weld = weld_vertices(vertices, weld_tolerance(vertices));
  EXPECT_EQ(weld[0], weld[1]);
  EXPECT_NE(weld[0], weld[2]);
  EXPECT_EQ(weld[3], weld[4]);
  const auto exact = weld_vertices(vertices, 0.0F);
  EXPECT_NE(exact[0], exact[1]);
  EXPECT_EQ(exact[3], exact[4]);
}

TEST(MeshTopology, WeldAgreesWithAllPairs) {
  std::vector<Vec3> vertices;
  RandomStream random(1, 2, 3);
  for (int i = 0; i < 600; ++i) vertices.emplace_back(random.next_float(), random.next_float(), random.next_float());
  for (int i = 0; i < 300; ++i) vertices.push_back(vertices[static_cast<std::size_t>(7 * i % 600)] + Vec3(0x1p-22F));
  const float tolerance = weld_tolerance(vertices);
  const auto weld = weld_vertices(vertices, tolerance);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_EQ(weld[i] == weld[j], max_abs(vertices[i] - vertices[j]) <= tolerance) << i << " " << j;
}

TEST(MeshTopology, NeighboursAcrossManifoldEdges) {
  const auto pairs = neighbouring_faces(cube_faces(), unwelded(8));
  EXPECT_EQ(pairs.size(), 12U);
  for (const FacePair& pair : pairs)
    EXPECT_NE(pair.first / 2, pair.second / 2);  // opposite faces stand beside each other in the list
}

}  // namespace
}  // namespace gibench::test
