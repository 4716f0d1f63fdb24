#include "common/geometry/geometry_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "common/scene/made_scenes.h"

namespace gibench::test {
namespace {

using Faces = std::vector<std::array<std::uint32_t, 4>>;

/// A closed mesh of latitude-longitude quads and polar triangles, fronts outward; `radius` of (latitude, longitude).
template <class Radius>
Scene ball(std::uint32_t rings, std::uint32_t sectors, const Radius& radius) {
  std::vector<Vec3> vertices{{0, 0, radius(0.0, 0.0)}};
  Faces faces;
  for (std::uint32_t r = 1; r < rings; ++r)
    for (std::uint32_t s = 0; s < sectors; ++s) {
      const double theta = pi_double * r / rings, phi = 2.0 * pi_double * s / sectors;
      const double distance = radius(theta, phi);
      vertices.emplace_back(distance * std::sin(theta) * std::cos(phi), distance * std::sin(theta) * std::sin(phi),
                            distance * std::cos(theta));
    }
  const auto last = static_cast<std::uint32_t>(vertices.size());
  vertices.emplace_back(0, 0, -radius(pi_double, 0.0));
  const auto at = [&](std::uint32_t r, std::uint32_t s) { return 1 + (r - 1) * sectors + s % sectors; };
  for (std::uint32_t s = 0; s < sectors; ++s) {
    faces.push_back({0, at(1, s), at(1, s + 1), at(1, s + 1)});
    faces.push_back({last, at(rings - 1, s + 1), at(rings - 1, s), at(rings - 1, s)});
    for (std::uint32_t r = 1; r + 1 < rings; ++r) {
      faces.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1), at(r + 1, s + 1)});
      faces.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1), at(r, s + 1)});
    }
  }
  made::SceneBuilder builder;
  builder.object("ball", builder.diffuse("white", Rgb(0.5F)), vertices, faces);
  return builder.build("ball");
}

/// A prism of height 1 over a polygon in the plane z = 0, fronts outward; bottom and top are given as faces.
Scene prism(const std::vector<Vec2>& outline, const Faces& bottom_up) {
  const auto count = static_cast<std::uint32_t>(outline.size());
  std::vector<Vec3> vertices;
  for (const float z : {0.0F, 1.0F})
    for (const Vec2& p : outline) vertices.emplace_back(p.x, p.y, z);
  Faces faces;
  for (const auto& [a, b, c, d] : bottom_up) {
    faces.push_back({a + count, b + count, c + count, d + count});
    faces.push_back(c == d ? std::array{c, b, a, a} : std::array{d, c, b, a});
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    faces.push_back({i, next, next + count, i + count});
  }
  made::SceneBuilder builder;
  builder.object("prism", builder.diffuse("white", Rgb(0.5F)), vertices, faces);
  return builder.build("prism");
}

TEST(GeometryReport, RoomOfSixQuads) {
  made::SceneBuilder builder;
  builder.room("room", builder.diffuse("white", Rgb(0.5F)), {0, 0, 0}, {1, 2, 3});
  const GeometryReport report = report_geometry(builder.build("room"));
  EXPECT_EQ(report.faces, 6U);
  EXPECT_EQ(report.quads, 6U);
  EXPECT_EQ(report.triangles, 0U);
  EXPECT_EQ(report.degenerate_faces, 0U);
  EXPECT_EQ(report.boundary_edges, 0U);
  EXPECT_EQ(report.components, 1U);
  EXPECT_TRUE(report.closed);
  EXPECT_TRUE(report.oriented);
  EXPECT_TRUE(report.convex);
  EXPECT_NEAR(report.area, 2.0 * (2.0 + 3.0 + 6.0), 1e-5);
  EXPECT_NEAR(report.volume, -6.0, 1e-5);  // fronts inward
}

TEST(GeometryReport, SeparateQuadsOfOneBoxAreClosed) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  const Vec3 a(0.1F, 0.2F, 0.3F), b(1.1F, 1.2F, 1.3F);
  builder.quad("x0", white, {Vec3(a.x, a.y, a.z), {a.x, a.y, b.z}, {a.x, b.y, b.z}, {a.x, b.y, a.z}});
  builder.quad("x1", white, {Vec3(b.x, a.y, a.z), {b.x, b.y, a.z}, {b.x, b.y, b.z}, {b.x, a.y, b.z}});
  builder.quad("y0", white, {Vec3(a.x, a.y, a.z), {b.x, a.y, a.z}, {b.x, a.y, b.z}, {a.x, a.y, b.z}});
  builder.quad("y1", white, {Vec3(a.x, b.y, a.z), {a.x, b.y, b.z}, {b.x, b.y, b.z}, {b.x, b.y, a.z}});
  builder.quad("z0", white, {Vec3(a.x, a.y, a.z), {a.x, b.y, a.z}, {b.x, b.y, a.z}, {b.x, a.y, a.z}});
  builder.quad("z1", white, {Vec3(a.x, a.y, b.z), {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}});
  const Scene scene = builder.build("box");
  const GeometryReport report = report_geometry(scene);
  EXPECT_TRUE(report.closed);
  EXPECT_TRUE(report.convex);
  EXPECT_EQ(report.duplicate_vertices, 0U);  // of different objects
  EXPECT_NEAR(report.volume, 1.0, 1e-5);
  const auto objects = report_objects(scene);
  ASSERT_EQ(objects.size(), 6U);
  EXPECT_EQ(objects[2].name, "y0");
  EXPECT_EQ(objects[2].boundary_edges, 4U);
  EXPECT_FALSE(objects[2].closed);
  EXPECT_FALSE(objects[2].convex);
  EXPECT_NEAR(objects[2].area, 1.0, 1e-5);
}

TEST(GeometryReport, OpenBoxIsNeitherClosedNorConvex) {
  made::SceneBuilder builder;
  builder.object("tray", builder.diffuse("white", Rgb(0.5F)),
                 {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                 {{0, 1, 2, 3}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}});
  const GeometryReport report = report_geometry(builder.build("tray"));
  EXPECT_EQ(report.boundary_edges, 4U);
  EXPECT_FALSE(report.closed);
  EXPECT_FALSE(report.convex);
  EXPECT_TRUE(report.oriented);
  EXPECT_EQ(report.volume, 0.0);
}

TEST(GeometryReport, TwoBlocksAreTwoComponents) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.block("a", white, {0, 0, 0}, {1, 1, 1}).block("b", white, {3, 0, 0}, {4, 1, 1});
  const Scene scene = builder.build("two");
  const GeometryReport report = report_geometry(scene);
  EXPECT_EQ(report.components, 2U);
  EXPECT_TRUE(report.closed);
  EXPECT_FALSE(report.convex);
  EXPECT_NEAR(report.volume, 2.0, 1e-5);
  for (const GeometryReport& object : report_objects(scene)) EXPECT_TRUE(object.convex) << object.name;
}

TEST(GeometryReport, LShapedRoomIsNotConvex) {
  const std::vector<Vec2> outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const GeometryReport report = report_geometry(prism(outline, {{0, 1, 2, 3}, {0, 3, 4, 5}}));
  EXPECT_TRUE(report.closed);
  EXPECT_TRUE(report.oriented);
  EXPECT_FALSE(report.convex);
  EXPECT_NEAR(report.area, 3.0 + 3.0 + 8.0, 1e-5);
  EXPECT_NEAR(report.volume, 3.0, 1e-5);
  EXPECT_TRUE(report_geometry(prism({{0, 0}, {2, 0}, {2, 1}, {0, 2}}, {{0, 1, 2, 3}})).convex);
}

TEST(GeometryReport, DegenerateFacesAndDuplicateVerticesAreCounted) {
  made::SceneBuilder builder;
  builder.object("odd", builder.diffuse("white", Rgb(0.5F)), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {1, 0, 0}},
                 {{0, 1, 2, 2}, {0, 1, 1, 1}, {0, 1, 3, 3}, {0, 1, 4, 4}, {0, 0, 1, 2}, {2, 2, 2, 2}});
  const GeometryReport report = report_geometry(builder.build("odd"));
  EXPECT_EQ(report.faces, 6U);
  EXPECT_EQ(report.degenerate_faces, 5U);  // all but the first
  EXPECT_EQ(report.duplicate_vertices, 1U);
  EXPECT_EQ(report.vertices, 5U);
  EXPECT_NEAR(report.area, 1.0, 1e-6);  // the first, and half of the quad
}

TEST(GeometryReport, FanAndFlippedFaces) {
  made::SceneBuilder builder;
  builder.object("fan", builder.diffuse("white", Rgb(0.5F)), {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 1}},
                 {{0, 1, 2, 2}, {0, 1, 3, 3}, {0, 1, 4, 4}, {1, 2, 5, 5}});
  const GeometryReport report = report_geometry(builder.build("fan"));
  EXPECT_EQ(report.non_manifold_edges, 1U);
  EXPECT_EQ(report.flipped_edges, 1U);
  EXPECT_FALSE(report.oriented);
}

TEST(GeometryReport, BallsWithAndWithoutADent) {
  const auto round = [](double, double) { return 1.0; };
  const auto dented = [](double theta, double) { return theta == 0.0 ? 0.9 : 1.0; };
  EXPECT_TRUE(report_geometry(ball(12, 24, round)).convex);
  EXPECT_FALSE(report_geometry(ball(12, 24, dented)).convex);
  // So large that extreme vertices stand for all.
  const Scene large = ball(100, 400, round);
  ASSERT_GT(large.vertices.size() * large.triangles.size(), 100'000'000U);
  const GeometryReport report = report_geometry(large);
  EXPECT_TRUE(report.convex);
  EXPECT_NEAR(report.volume, 4.0 / 3.0 * pi_double, 0.005);
  EXPECT_FALSE(report_geometry(ball(100, 400, dented)).convex);
}

TEST(GeometryReport, BoundsAreInFileCoordinates) {
  made::SceneBuilder builder;
  builder.block("a", builder.diffuse("white", Rgb(0.5F)), {-1, -1, -1}, {1, 1, 1});
  Scene scene = builder.build("far");
  scene.origin = {1e6, 2.0, -3.0};
  const GeometryReport report = report_geometry(scene);
  EXPECT_EQ(report.bounds_min, Vec3d(1e6 - 1.0, 1.0, -4.0));
  EXPECT_EQ(report.bounds_max, Vec3d(1e6 + 1.0, 3.0, -2.0));
  const nlohmann::ordered_json json = to_json(report);
  EXPECT_EQ(json["bounds_min"].get<std::vector<double>>(), (std::vector<double>{1e6 - 1.0, 1.0, -4.0}));
  EXPECT_EQ(json["closed"].get<bool>(), true);
}

TEST(GeometryReport, EmptySceneHasNothing) {
  const GeometryReport report = report_geometry(Scene{});
  EXPECT_EQ(report.faces, 0U);
  EXPECT_FALSE(report.closed);
  EXPECT_FALSE(report.convex);
  EXPECT_EQ(report.area, 0.0);
}

}  // namespace
}  // namespace gibench::test
