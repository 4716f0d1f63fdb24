/// What the settings leave open, by what the scene needs.
#include "methods/spectral/needs.h"

#include <gtest/gtest.h>

#include "rooms.h"

namespace gibench::test {
namespace {

using namespace spectral;

/// So many vertices of a mesh to a node.
Nodes nodes_of(const SamplingMesh& mesh, std::uint32_t vertices_a_node) {
  std::vector<std::uint32_t> node_of_vertex(mesh.vertices().size());
  for (std::uint32_t v = 0; v < node_of_vertex.size(); ++v) node_of_vertex[v] = v / vertices_a_node;
  return {mesh, std::move(node_of_vertex), [](std::uint32_t, const VertexSite&) { return true; }};
}

TEST(SpectralNeeds, WhatIsSetStands) {
  Settings settings = spectral_settings(
      {{"vertices", "700"}, {"basis_functions", "33"}, {"part_vertices", "44"}, {"rays", "55"}, {"compression_error", "0"}});
  const World world(closed_room(), 1);
  settle_vertices(1'000'000, settings);
  settle_basis(nodes_of(SamplingMesh(world, {0.1}), 2), settings);
  EXPECT_EQ(settings.vertices, 700);
  EXPECT_EQ(settings.basis_functions, 33);
  EXPECT_EQ(settings.part_vertices, 44);
  EXPECT_EQ(settings.rays, 55);
  EXPECT_EQ(settings.compression_error, 0.0);
}

TEST(SpectralNeeds, SimpleScenesHaveOneSize) {
  const World world(closed_room(), 1);
  Settings settings = spectral_settings({});
  settle_vertices(world.scene().triangles.size(), settings);
  settle_basis(nodes_of(SamplingMesh(world, {0.01}), 1), settings);
  EXPECT_EQ(settings.vertices, 8000);
  EXPECT_EQ(settings.basis_functions, 1024);
  EXPECT_EQ(settings.part_vertices, 1000);
  EXPECT_EQ(settings.rays, 1024);
  EXPECT_EQ(settings.compression_error, 0.01);
}

TEST(SpectralNeeds, FineScenesHaveMoreFunctionsTheMoreNodes) {
  const World world(closed_room(), 1);
  const Nodes nodes = nodes_of(SamplingMesh(world, {0.015}), 2);
  ASSERT_GT(nodes.size(), 10'000U);
  Settings settings = spectral_settings({}), folded = spectral_settings({{"mode", "fixed_albedo"}}),
           vertices = spectral_settings({{"nodes", "vertices"}});
  for (Settings* each : {&settings, &folded, &vertices}) settle_vertices(100'000, *each), settle_basis(nodes, *each);
  EXPECT_EQ(settings.vertices, 16000);
  EXPECT_EQ(vertices.vertices, 8000);
  EXPECT_GT(settings.basis_functions, static_cast<int>(nodes.size()) / 6);
  EXPECT_LE(settings.basis_functions, static_cast<int>(nodes.size()) / 5);
  EXPECT_EQ(folded.basis_functions, 1024);
  EXPECT_EQ(settings.part_vertices, 500);
  EXPECT_EQ(settings.rays, 2048);
}

}  // namespace
}  // namespace gibench::test
