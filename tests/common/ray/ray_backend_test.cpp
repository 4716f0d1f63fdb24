#include "common/ray/ray_backend.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#ifndef GIBENCH_STD_THREADS
#include <tbb/global_control.h>
#endif

#include <cmath>
#include <vector>

#include "common/core/error.h"
#include "common/core/random.h"
#include "common/ray/ray_stream.h"
#include "common/scene/tessellate.h"
#include "tests/support/check_failed.h"
#include "tests/support/scene_builder.h"

namespace gibench {
namespace {

/// The closest hit by trying every triangle in double precision (Möller and Trumbore 1997), and how far the
/// decision was from going the other way.
struct BruteForceHit {
  std::uint32_t triangle = Hit::none;
  double distance = INFINITY;
  double margin = INFINITY;  ///< smallest |barycentric coordinate| of a near miss or hit, or gap between two hits
};

BruteForceHit brute_force(const Scene& scene, const Ray& ray) {
  BruteForceHit best;
  const Vec3d origin(ray.origin), direction(ray.direction);
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
    const auto& corners = scene.triangles[t].corners;
    const Vec3d a(scene.vertices[corners[0]]);
    const Vec3d first = Vec3d(scene.vertices[corners[1]]) - a, second = Vec3d(scene.vertices[corners[2]]) - a;
    const Vec3d p = glm::cross(direction, second);
    const double determinant = glm::dot(first, p);
    if (determinant == 0.0) continue;
    const Vec3d to_origin = origin - a;
    const double u = glm::dot(to_origin, p) / determinant;
    const Vec3d q = glm::cross(to_origin, first);
    const double v = glm::dot(direction, q) / determinant, distance = glm::dot(second, q) / determinant;
    if (!(distance > 0.0)) continue;
    const double inside = std::min({u, v, 1.0 - u - v});
    if (distance < best.distance || inside < 0.0) best.margin = std::min(best.margin, std::abs(inside));
    if (inside < 0.0) continue;
    if (best.triangle != Hit::none) best.margin = std::min(best.margin, std::abs(distance - best.distance));
    if (distance < best.distance) best.triangle = t, best.distance = distance;
  }
  return best;
}

std::vector<Ray> random_rays(std::size_t count, float extent, std::uint64_t seed) {
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < count; ++i) {
    RandomStream random(seed, 1, i);
    const auto number = [&] { return random.next_float() - 0.5F; };
    Ray ray;
    ray.origin = {extent * number(), extent * number(), extent * number()};
    ray.direction = {number(), number(), number()};
    rays.push_back(ray);
  }
  return rays;
}

Ray downward(float x, float z) {
  Ray ray;
  ray.origin = {x, 0.9F, z};
  ray.direction = {0.0F, -2.0F, 0.0F};
  return ray;
}

TEST(RayBackend, FindsTheTriangleThatBruteForceFinds) {
  const Scene scene = test::random_triangles(1500, 1.0F, 0.25F, 3);
  const RayBackend backend(scene, 1);
  int hits = 0, misses = 0, close_calls = 0;
  for (const Ray& ray : random_rays(4000, 1.2F, 4)) {
    const BruteForceHit expected = brute_force(scene, ray);
    if (expected.margin < 1e-5) {  // within rounding of an edge or of two surfaces
      ++close_calls;
      continue;
    }
    const Hit hit = backend.closest_hit(ray);
    ASSERT_EQ(hit.triangle, expected.triangle);
    if (!hit) {
      ++misses;
      continue;
    }
    ++hits;
    EXPECT_NEAR(hit.distance, expected.distance, 1e-5 * (1.0 + expected.distance));
  }
  EXPECT_GT(hits, 2000);
  EXPECT_GT(misses, 100);
  EXPECT_LT(close_calls, 400);
}

TEST(RayBackend, BarycentricsAndDistanceDescribeTheSamePoint) {
  const Scene scene = test::random_triangles(500, 1.0F, 0.5F, 5);
  const RayBackend backend(scene, 1);
  int hits = 0;
  for (const Ray& ray : random_rays(2000, 1.0F, 6)) {
    const Hit hit = backend.closest_hit(ray);
    if (!hit) continue;
    ++hits;
    const auto& [a, b, c] = scene.triangles[hit.triangle].corners;
    const Vec3 on_triangle = (1.0F - hit.u - hit.v) * scene.vertices[a] + hit.u * scene.vertices[b] + hit.v * scene.vertices[c];
    EXPECT_LT(glm::distance(on_triangle, ray.origin + hit.distance * ray.direction), 2e-5F);
  }
  EXPECT_GT(hits, 1000);
}

TEST(RayBackend, OcclusionAgreesWithTheClosestHit) {
  const Scene scene = test::random_triangles(1500, 1.0F, 0.25F, 7);
  const RayBackend backend(scene, 1);
  int blocked = 0;
  for (Ray ray : random_rays(4000, 1.2F, 8)) {
    const Hit hit = backend.closest_hit(ray);
    EXPECT_EQ(backend.occluded(ray), static_cast<bool>(hit));
    if (!hit) continue;
    ++blocked;
    ray.t_max = hit.distance * 1.001F;
    EXPECT_TRUE(backend.occluded(ray));
    ray.t_max = hit.distance * 0.999F;
    EXPECT_FALSE(backend.occluded(ray)) << "nothing lies nearer than the closest hit";
    EXPECT_FALSE(backend.closest_hit(ray));
  }
  EXPECT_GT(blocked, 2000);
}

/// Any length: whole packets, a part of one, one ray, none.
class RayBatches : public testing::TestWithParam<std::size_t> {};

TEST_P(RayBatches, EqualOneByOne) {
  const Scene scene = test::random_triangles(1500, 1.0F, 0.25F, 9);
  const RayBackend backend(scene, 1);
  std::vector<Ray> rays = random_rays(GetParam(), 1.2F, 10);
  for (std::size_t i = 0; i < rays.size(); i += 3) rays[i].t_min = 0.5F, rays[i].t_max = 1.5F;
  std::vector<Hit> hits(rays.size());
  std::vector<std::uint8_t> occluded(rays.size(), 7);
  backend.closest_hits(rays, hits);
  backend.occlusions(rays, occluded);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Hit single = backend.closest_hit(rays[i]);
    ASSERT_EQ(hits[i].triangle, single.triangle) << "ray " << i;
    EXPECT_NEAR(hits[i].distance, single.distance, 2e-6F * (1.0F + single.distance));
    EXPECT_NEAR(hits[i].u, single.u, 2e-4F);
    EXPECT_NEAR(hits[i].v, single.v, 2e-4F);
    EXPECT_EQ(occluded[i], backend.occluded(rays[i]) ? 1 : 0) << "ray " << i;
  }
}

TEST_P(RayBatches, FansEqualOneByOne) {
  const Scene scene = test::random_triangles(1500, 1.0F, 0.25F, 9);
  const RayBackend backend(scene, 1);
  const Vec3 origin(0.1F, -0.05F, 0.2F);
  std::vector<float> x, y, z;
  for (const Ray& ray : random_rays(GetParam(), 1.2F, 11))
    x.push_back(ray.direction.x), y.push_back(ray.direction.y), z.push_back(ray.direction.z);
  std::vector<std::uint32_t> triangle(x.size());
  std::vector<float> u(x.size()), v(x.size());
  backend.closest_hits({origin, x, y, z}, {triangle, u, v});
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Hit single = backend.closest_hit({origin, 0.0F, {x[i], y[i], z[i]}});
    ASSERT_EQ(triangle[i], single.triangle) << "ray " << i;
    if (!single) continue;
    EXPECT_NEAR(u[i], single.u, 2e-4F);
    EXPECT_NEAR(v[i], single.v, 2e-4F);
  }
}

INSTANTIATE_TEST_SUITE_P(Lengths, RayBatches, testing::Values(0, 1, 7, 8, 16, 17, 63, 64, 65, 1000));

TEST(RayBackend, DirectionsNeedNotBeUnit) {
  const RayBackend backend(test::box_scene(), 1);
  const Hit hit = backend.closest_hit(downward(0.5F, 0.1F));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit.distance, 0.45F, 1e-6F);
}

TEST(RayBackend, AnEmptySceneHitsNothing) {
  Scene scene;
  tessellate(scene);
  const RayBackend backend(scene, 1);
  EXPECT_FALSE(backend.closest_hit(downward(0.0F, 0.0F)));
  EXPECT_FALSE(backend.occluded(downward(0.0F, 0.0F)));
  const std::vector<Ray> rays(20, downward(0.0F, 0.0F));
  std::vector<Hit> hits(20, Hit{3, 0.1F, 0.1F, 1.0F});
  std::vector<std::uint8_t> occluded(20, 1);
  backend.closest_hits(rays, hits);
  backend.occlusions(rays, occluded);
  for (std::size_t i = 0; i < rays.size(); ++i) EXPECT_TRUE(!hits[i] && occluded[i] == 0);
}

TEST(RayBackend, DegenerateTrianglesAreLivedWith) {
  test::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  const Vec3 a(0.2F, 0.5F, 0.2F), b(0.8F, 0.5F, 0.8F);
  builder.object("point", white, {a}, {{0, 0, 0, 0}})
      .object("line", white, {a, b, 0.5F * (a + b)}, {{0, 1, 2, 2}})
      .quad("floor", white, {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}});
  const Scene scene = builder.build("degenerate");
  const RayBackend backend(scene, 1);
  for (int i = 1; i < 20; ++i) {
    const Hit hit = backend.closest_hit(downward(0.05F * static_cast<float>(i), 0.31F));
    ASSERT_TRUE(hit);
    EXPECT_EQ(scene.objects[scene.triangle_object[hit.triangle]].name, "floor");
    EXPECT_TRUE(std::isfinite(hit.u) && std::isfinite(hit.v) && std::isfinite(hit.distance));
  }
}

TEST(RayBackend, RefusesAnswersOfAnotherLength) {
  const RayBackend backend(test::box_scene(), 1);
  const std::vector<Ray> rays(3);
  std::vector<Hit> hits(2);
  std::vector<std::uint8_t> occluded(4);
  EXPECT_THAT([&] { backend.closest_hits(rays, hits); }, test::fails_check("one hit for each ray"));
  EXPECT_THAT([&] { backend.occlusions(rays, occluded); }, test::fails_check("one answer for each ray"));
}

TEST(RayBackend, TellsTheBytesOfItsHierarchy) {
  const RayBackend small(test::random_triangles(100, 1.0F, 0.1F, 1), 1);
  const RayBackend large(test::random_triangles(20000, 1.0F, 0.1F, 1), 1);
  EXPECT_GT(small.bytes(), 100U * sizeof(Triangle));
  EXPECT_GT(large.bytes(), 20000U * sizeof(Triangle));
  EXPECT_GT(large.bytes(), small.bytes());
}

#ifndef GIBENCH_STD_THREADS
TEST(RayBackend, ItsThreadsAreItsOwn) {
  using tbb::global_control;
  const auto allowed = [] { return global_control::active_value(global_control::max_allowed_parallelism); };
  const std::size_t before = allowed();
  const RayBackend backend(test::random_triangles(5000, 1.0F, 0.1F, 1), 1);
  EXPECT_EQ(allowed(), before) << "building with one thread must not hold back the process";
}
#endif

TEST(RayStream, CountsEveryRayOnceItEnds) {
  const RayBackend backend(test::box_scene(), 1);
  RayCounts counts;
  std::vector<Ray> rays(37, downward(0.5F, 0.1F));
  std::vector<Hit> hits(rays.size());
  std::vector<std::uint8_t> occluded(rays.size());
  {
    RayStream stream(backend, counts);
    stream.closest_hit(rays[0]);
    stream.closest_hits(rays, hits);
    stream.occluded(rays[0]);
    stream.occluded(rays[0]);
    stream.occlusions(rays, occluded);
    EXPECT_EQ(counts.closest_hit.load(), 0U);
  }
  {
    RayStream another(backend, counts), third(backend, counts);
    another.closest_hit(rays[0]);
  }
  EXPECT_EQ(counts.closest_hit.load(), 1U + 37U + 1U);
  EXPECT_EQ(counts.occlusion.load(), 2U + 37U);
}

}  // namespace
}  // namespace gibench
