#include "common/geometry/sampling_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "common/core/random.h"
#include "common/core/sampling.h"
#include "common/scene/made_scenes.h"

namespace gibench::test {
namespace {

constexpr float rounding = 1e-5F;

World room(bool two_sided = false) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.7F));
  builder.room("room", white, Vec3(0.0F), Vec3(1.0F, 2.0F, 3.0F));
  builder.quad("plate", white, {{{0.2F, 1.0F, 0.2F}, {0.2F, 1.0F, 0.8F}, {0.8F, 1.0F, 0.8F}, {0.8F, 1.0F, 0.2F}}}, two_sided);
  return World(builder.build("room"));
}

/// A slanting quad that is not planar, an isosceles sliver, a fan around a corner, and faces without area.
World oddments() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.7F));
  builder.object("bent", white, {{0, 0, 0}, {2, 0, 0}, {2, 0.5F, 2}, {0, 0, 2}}, {{0, 3, 2, 1}});
  builder.object("sliver", white, {{0, 1, 0}, {5, 1, 0}, {5, 1, 0.01F}}, {{0, 2, 1, 1}});
  builder.object("fan", white, {{0, 2, 0}, {1, 2, 0}, {0.3F, 2, 0.9F}, {-0.8F, 2.4F, 0.5F}, {-0.5F, 2, -0.7F}},
                 {{0, 2, 1, 1}, {0, 3, 2, 2}, {0, 4, 3, 3}});
  builder.object("nothing", white, {{0, 3, 0}, {1, 3, 0}, {2, 3, 0}}, {{0, 1, 2, 2}, {0, 0, 1, 1}});
  builder.object("three at an edge", white, {{0, 4, 0}, {1, 4, 0}, {0, 4, 1}, {0, 5, 0}, {0, 3, 0}},
                 {{0, 2, 1, 1}, {0, 1, 3, 3}, {0, 1, 4, 4}});
  return World(builder.build("oddments"));
}

/// A triangle that welding its vertices would leave without area.
World thin_sliver() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.7F));
  builder.object("thinner than welding", white, {{0, 6, 0}, {1, 6, 0}, {2, 6, 0}, {1, 6, 2e-6F}}, {{0, 3, 2, 2}, {0, 1, 2, 2}});
  return World(builder.build("thin sliver"));
}

/// A sphere of latitude and longitude quads with poles of triangles, fronts outward.
World sphere(int rows, int columns) {
  std::vector<Vec3> vertices{{0, 1, 0}, {0, -1, 0}};
  const auto at = [&](int row, int column) { return static_cast<std::uint32_t>(2 + (row - 1) * columns + column % columns); };
  for (int row = 1; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const float theta = pi * static_cast<float>(row) / static_cast<float>(rows);
      const float phi = 2.0F * pi * static_cast<float>(column) / static_cast<float>(columns);
      vertices.emplace_back(std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi));
    }
  std::vector<std::array<std::uint32_t, 4>> faces;
  for (int column = 0; column < columns; ++column) {
    faces.push_back({0, at(1, column), at(1, column + 1), at(1, column + 1)});
    faces.push_back({1, at(rows - 1, column + 1), at(rows - 1, column), at(rows - 1, column)});
    for (int row = 1; row + 1 < rows; ++row)
      faces.push_back({at(row, column), at(row + 1, column), at(row + 1, column + 1), at(row, column + 1)});
  }
  made::SceneBuilder builder;
  builder.object("sphere", builder.diffuse("white", Rgb(0.7F)), vertices, faces);
  return World(builder.build("sphere"));
}

double area_of(const SamplingMesh& mesh, bool fronts) {
  double sum = 0.0;
  for (const MeshVertex& vertex : mesh.vertices())
    if (vertex.front == fronts) sum += static_cast<double>(vertex.area);
  return sum;
}

float longest_edge(const SamplingMesh& mesh) {
  float longest = 0.0F;
  for (const MeshFace& face : mesh.faces())
    for (std::size_t i = 0; i < 4; ++i)
      longest = std::max(
          longest, glm::length(mesh.vertices()[face.corners[i]].position - mesh.vertices()[face.corners[(i + 1) % 4]].position));
  return longest;
}

/// The mesh point's place in space.
Vec3 position(const SamplingMesh& mesh, const MeshPoint& point) {
  Vec3 sum(0.0F);
  for (std::size_t i = 0; i < 3; ++i)
    sum += point.weights[i] * mesh.vertices()[mesh.triangles()[point.triangle].corners[i]].position;
  return sum;
}

/// Every point of every scene triangle with area lies on the mesh where it lies in space, on its own object and side.
void expect_points_found(const World& world, const SamplingMesh& mesh) {
  RandomStream random(1, 2, 3);
  for (std::uint32_t t = 0; t < world.scene().triangles.size(); ++t)
    for (const bool front : {true, false}) {
      const Object& object = world.scene().objects[world.scene().triangle_object[t]];
      ASSERT_EQ(mesh.covers(t, front), world.area(t) > 0.0F && (front || object.two_sided)) << "triangle " << t;
      if (!mesh.covers(t, front)) continue;
      for (int i = 0; i < 200; ++i) {
        const Vec2 at = uniform_triangle({random.next_float(), random.next_float()});
        const MeshPoint point = mesh.locate(t, at, front);
        EXPECT_LT(glm::length(position(mesh, point) - world.position(t, at)), rounding * world.diagonal());
        for (const float weight : point.weights) EXPECT_GE(weight, 0.0F);
        EXPECT_NEAR(point.weights[0] + point.weights[1] + point.weights[2], 1.0F, 1e-6F);
        const MeshVertex& corner = mesh.vertices()[mesh.triangles()[point.triangle].corners[0]];
        EXPECT_EQ(corner.object, world.scene().triangle_object[t]);
        EXPECT_EQ(corner.front, front);
      }
    }
}

/// No point of the mesh lies inside an edge of another face of its object: that would be a crack.
void expect_no_cracks(const SamplingMesh& mesh) {
  for (const MeshFace& face : mesh.faces())
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 a = mesh.vertices()[face.corners[i]].position, b = mesh.vertices()[face.corners[(i + 1) % 4]].position;
      const float length = glm::length(b - a);
      if (!(length > 0.0F)) continue;
      for (const MeshVertex& vertex : mesh.vertices()) {
        if (vertex.object != mesh.vertices()[face.corners[0]].object) continue;
        const float along = glm::dot(vertex.position - a, b - a) / (length * length);
        const bool inside = along > 1e-3F && along < 1.0F - 1e-3F;
        EXPECT_FALSE(inside && glm::length(vertex.position - glm::mix(a, b, along)) < 1e-4F * length);
      }
    }
}

TEST(SamplingMesh, AreasAddUpToTheScenes) {
  for (const World& world : {room(), room(true), oddments(), sphere(8, 12), thin_sliver()})
    for (const double edge : {std::numeric_limits<double>::infinity(), 0.31, 0.07})
      for (const bool keep_quads : {false, true}) {
        const SamplingMesh mesh(world, {edge, 40.0F, keep_quads});
        EXPECT_NEAR(area_of(mesh, true), world.total_area(), 1e-6 * world.total_area());
        for (const MeshVertex& vertex : mesh.vertices()) EXPECT_GT(vertex.area, 0.0F);
      }
}

TEST(SamplingMesh, BacksOfTwoSidedObjectsAreASheetOfTheirOwn) {
  const World world = room(true);
  const SamplingMesh mesh(world, {0.2});
  EXPECT_NEAR(area_of(mesh, false), 0.36, 1e-6);
  for (const MeshVertex& vertex : mesh.vertices())
    if (vertex.object == 1) {
      EXPECT_EQ(vertex.normal, Vec3(0.0F, vertex.front ? 1.0F : -1.0F, 0.0F));
    }
}

TEST(SamplingMesh, NoEdgeIsLongerThanAskedFor) {
  for (const World& world : {room(), oddments(), sphere(8, 12)})
    for (const double edge : {0.5, 0.13})
      for (const bool keep_quads : {false, true}) {
        const float longest = longest_edge(SamplingMesh(world, {edge, 40.0F, keep_quads}));
        // Halved quads have diagonals.
        EXPECT_LE(longest, (keep_quads ? 1.001F : 1.45F) * static_cast<float>(edge));
      }
}

TEST(SamplingMesh, PointsOfTheSceneAreFound) {
  for (const World& world : {room(), room(true), oddments(), sphere(8, 12), thin_sliver()})
    for (const double edge : {std::numeric_limits<double>::infinity(), 0.31, 0.07})
      for (const bool keep_quads : {false, true}) expect_points_found(world, SamplingMesh(world, {edge, 40.0F, keep_quads}));
}

TEST(SamplingMesh, SharedEdgesAreCutAlike) {
  for (const World& world : {room(), oddments(), sphere(5, 7)})
    for (const bool keep_quads : {false, true}) expect_no_cracks(SamplingMesh(world, {0.23, 40.0F, keep_quads}));
}

TEST(SamplingMesh, BoxCornerHasThreeNormalsAndASmoothSphereOne) {
  const World box = room();
  const SamplingMesh mesh(box, {0.5});
  std::set<std::array<float, 3>> normals;
  for (const MeshVertex& vertex : mesh.vertices())
    if (glm::length(vertex.position - box.bounds_min()) < 1e-6F)
      normals.insert({vertex.normal.x, vertex.normal.y, vertex.normal.z});
  EXPECT_EQ(normals, (std::set<std::array<float, 3>>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));

  const World round = sphere(8, 12);
  const SamplingMesh smooth(round, {.crease_degrees = 60.0F}), faceted(round, {.crease_degrees = 5.0F});
  EXPECT_EQ(smooth.vertices().size(), 2U + 7U * 12U);
  for (const MeshVertex& vertex : smooth.vertices()) EXPECT_GT(glm::dot(vertex.normal, glm::normalize(vertex.position)), 0.99F);
  EXPECT_EQ(faceted.vertices().size(), 2U * 12U * 3U + 6U * 12U * 4U);
}

TEST(SamplingMesh, QuadsOfAGridStayQuads) {
  const SamplingMesh quads(room(), {0.5, 40.0F, true}), triangles(room(), {0.5, 40.0F, false});
  const std::size_t faces = 2 * (2 * 4 + 4 * 6 + 2 * 6) + 4;
  EXPECT_EQ(quads.faces().size(), faces);
  EXPECT_TRUE(std::all_of(quads.faces().begin(), quads.faces().end(), [](const MeshFace& face) { return face.is_quad(); }));
  EXPECT_EQ(triangles.faces().size(), 2U * faces);
  EXPECT_EQ(quads.triangles().size(), 2U * faces);
  EXPECT_EQ(quads.vertices().size(), triangles.vertices().size());
}

TEST(SamplingMesh, NonManifoldFacesStandAlone) {
  const World world = oddments();
  const SamplingMesh mesh(world);
  EXPECT_EQ(mesh.refused_faces(), 1U);
}

TEST(SamplingMesh, SitesLieInsideFacesAroundTheirVertex) {
  for (const World& world : {room(true), oddments(), sphere(8, 12)}) {
    const SamplingMesh mesh(world, {0.3});
    for (std::uint32_t v = 0; v < mesh.vertices().size(); ++v) {
      const MeshVertex& vertex = mesh.vertices()[v];
      float shares = 0.0F;
      ASSERT_FALSE(mesh.sites(v).empty());
      for (const VertexSite& site : mesh.sites(v)) {
        shares += site.share;
        const SurfaceSample sample = mesh.sample(world, v, site);
        EXPECT_TRUE(sample.lit_side);
        EXPECT_EQ(sample.object, vertex.object);
        EXPECT_LT(glm::length(sample.position - vertex.position), 0.3F / 16.0F);
        EXPECT_GT(glm::dot(sample.normal, vertex.normal), 0.0F);
        const MeshPoint point = mesh.locate(site.scene_triangle, site.barycentrics, vertex.front);
        const auto& corners = mesh.triangles()[point.triangle].corners;
        EXPECT_NE(std::find(corners.begin(), corners.end(), v), corners.end());
        EXPECT_GT(*std::min_element(point.weights.begin(), point.weights.end()), 0.0F);
      }
      EXPECT_NEAR(shares, 1.0F, 1e-5F);
    }
  }
}

TEST(SamplingMesh, FlatVertexHasOneSite) {
  const World world = room();
  const SamplingMesh mesh(world, {0.25});
  for (std::uint32_t v = 0; v < mesh.vertices().size(); ++v) EXPECT_EQ(mesh.sites(v).size(), 1U);
}

TEST(SamplingMesh, EdgeLengthGivesAboutTheVerticesAskedFor) {
  const World world = room();
  const SamplingMesh mesh(world, {edge_length_for(world, 3000)});
  EXPECT_GT(mesh.vertices().size(), 2700U);
  EXPECT_LT(mesh.vertices().size(), 4200U);
}

TEST(SamplingMesh, SceneWithoutAreaIsEmpty) {
  made::SceneBuilder builder;
  builder.object("nothing", builder.diffuse("white", Rgb(0.7F)), {{0, 3, 0}, {1, 3, 0}, {2, 3, 0}}, {{0, 1, 2, 2}});
  const World world(builder.build("nothing"));
  const SamplingMesh mesh(world);
  EXPECT_TRUE(mesh.vertices().empty());
  EXPECT_FALSE(mesh.covers(0, true));
}

}  // namespace
}  // namespace gibench::test
