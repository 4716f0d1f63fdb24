#include "common/ray/ray_backend.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "common/core/random.h"
#include "common/ray/embree/embree_backend.h"
#include "common/ray/ray_stream.h"
#include "common/ray/world.h"
#include "common/scene/made_scenes.h"
#include "common/scene/tessellate.h"
#include "tests/common/ray/brute_force.h"
#include "tests/support/check_failed.h"

namespace gibench {
namespace {

/// A backend by its name; what the interface promises holds for each.
struct NamedBackend {
  std::string name;
  MakeRayBackend make;

  std::unique_ptr<const RayBackend> over(const Scene& scene) const { return make(scene.vertices, scene.triangles, 1); }
};
std::ostream& operator<<(std::ostream& out, const NamedBackend& backend) { return out << backend.name; }

std::vector<NamedBackend> every_backend() {
  return {{"embree", make_embree_backend}, {"brute_force", test::make_brute_force_backend}};
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

class RayBackends : public testing::TestWithParam<NamedBackend> {};

TEST_P(RayBackends, FindTheTriangleThatBruteForceFinds) {
  const Scene scene = made::random_triangles(1500, 1.0F, 0.25F, 3);
  const auto backend = GetParam().over(scene);
  int hits = 0, misses = 0, close_calls = 0;
  for (const Ray& ray : random_rays(4000, 1.2F, 4)) {
    const test::BruteForceHit expected = test::brute_force(scene.vertices, scene.triangles, ray);
    if (expected.margin < 1e-5) {  // within rounding of an edge or of two surfaces
      ++close_calls;
      continue;
    }
    const Hit hit = backend->closest_hit(ray);
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

TEST_P(RayBackends, BarycentricsAndDistanceDescribeTheSamePoint) {
  const Scene scene = made::random_triangles(500, 1.0F, 0.5F, 5);
  const auto backend = GetParam().over(scene);
  int hits = 0;
  for (const Ray& ray : random_rays(2000, 1.0F, 6)) {
    const Hit hit = backend->closest_hit(ray);
    if (!hit) continue;
    ++hits;
    const auto& [a, b, c] = scene.triangles[hit.triangle].corners;
    const Vec3 on_triangle = (1.0F - hit.u - hit.v) * scene.vertices[a] + hit.u * scene.vertices[b] + hit.v * scene.vertices[c];
    EXPECT_LT(glm::distance(on_triangle, ray.origin + hit.distance * ray.direction), 2e-5F);
  }
  EXPECT_GT(hits, 1000);
}

TEST_P(RayBackends, OcclusionAgreesWithTheClosestHit) {
  const Scene scene = made::random_triangles(1500, 1.0F, 0.25F, 7);
  const auto backend = GetParam().over(scene);
  int blocked = 0;
  for (Ray ray : random_rays(4000, 1.2F, 8)) {
    const Hit hit = backend->closest_hit(ray);
    EXPECT_EQ(backend->occluded(ray), static_cast<bool>(hit));
    if (!hit) continue;
    ++blocked;
    ray.t_max = hit.distance * 1.001F;
    EXPECT_TRUE(backend->occluded(ray));
    ray.t_max = hit.distance * 0.999F;
    EXPECT_FALSE(backend->occluded(ray)) << "nothing lies nearer than the closest hit";
    EXPECT_FALSE(backend->closest_hit(ray));
  }
  EXPECT_GT(blocked, 2000);
}

/// Any length: whole packets, a part of one, one ray, none.
class RayBatches : public testing::TestWithParam<std::tuple<NamedBackend, std::size_t>> {
 protected:
  static std::unique_ptr<const RayBackend> over(const Scene& scene) { return std::get<0>(GetParam()).over(scene); }
  static std::size_t length() { return std::get<1>(GetParam()); }
};

TEST_P(RayBatches, EqualOneByOne) {
  const Scene scene = made::random_triangles(1500, 1.0F, 0.25F, 9);
  const auto backend = over(scene);
  std::vector<Ray> rays = random_rays(length(), 1.2F, 10);
  for (std::size_t i = 0; i < rays.size(); i += 3) rays[i].t_min = 0.5F, rays[i].t_max = 1.5F;
  std::vector<Hit> hits(rays.size());
  std::vector<std::uint8_t> occluded(rays.size(), 7);
  backend->closest_hits(rays, hits);
  backend->occlusions(rays, occluded);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Hit single = backend->closest_hit(rays[i]);
    ASSERT_EQ(hits[i].triangle, single.triangle) << "ray " << i;
    EXPECT_NEAR(hits[i].distance, single.distance, 2e-6F * (1.0F + single.distance));
    EXPECT_NEAR(hits[i].u, single.u, 2e-4F);
    EXPECT_NEAR(hits[i].v, single.v, 2e-4F);
    EXPECT_EQ(occluded[i], backend->occluded(rays[i]) ? 1 : 0) << "ray " << i;
  }
}

TEST_P(RayBatches, FansEqualOneByOne) {
  const Scene scene = made::random_triangles(1500, 1.0F, 0.25F, 9);
  const auto backend = over(scene);
  const Vec3 origin(0.1F, -0.05F, 0.2F);
  std::vector<float> x, y, z;
  for (const Ray& ray : random_rays(length(), 1.2F, 11))
    x.push_back(ray.direction.x), y.push_back(ray.direction.y), z.push_back(ray.direction.z);
  std::vector<std::uint32_t> triangle(x.size());
  std::vector<float> u(x.size()), v(x.size());
  backend->closest_hits({origin, x, y, z}, {triangle, u, v});
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Hit single = backend->closest_hit({origin, 0.0F, {x[i], y[i], z[i]}});
    ASSERT_EQ(triangle[i], single.triangle) << "ray " << i;
    if (!single) continue;
    EXPECT_NEAR(u[i], single.u, 2e-4F);
    EXPECT_NEAR(v[i], single.v, 2e-4F);
  }
}

INSTANTIATE_TEST_SUITE_P(Lengths, RayBatches,
                         testing::Combine(testing::ValuesIn(every_backend()),
                                          testing::Values(0, 1, 7, 8, 16, 17, 63, 64, 65, 1000)));

TEST_P(RayBackends, DirectionsNeedNotBeUnit) {
  const auto backend = GetParam().over(made::box_scene());
  const Hit hit = backend->closest_hit(downward(0.5F, 0.1F));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit.distance, 0.45F, 1e-6F);
}

TEST_P(RayBackends, AnEmptySceneHitsNothing) {
  Scene scene;
  tessellate(scene);
  const auto backend = GetParam().over(scene);
  EXPECT_FALSE(backend->closest_hit(downward(0.0F, 0.0F)));
  EXPECT_FALSE(backend->occluded(downward(0.0F, 0.0F)));
  const std::vector<Ray> rays(20, downward(0.0F, 0.0F));
  std::vector<Hit> hits(20, Hit{3, 0.1F, 0.1F, 1.0F});
  std::vector<std::uint8_t> occluded(20, 1);
  backend->closest_hits(rays, hits);
  backend->occlusions(rays, occluded);
  for (std::size_t i = 0; i < rays.size(); ++i) EXPECT_TRUE(!hits[i] && occluded[i] == 0);
}

TEST_P(RayBackends, DegenerateTrianglesAreLivedWith) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  const Vec3 a(0.2F, 0.5F, 0.2F), b(0.8F, 0.5F, 0.8F);
  builder.object("point", white, {a}, {{0, 0, 0, 0}})
      .object("line", white, {a, b, 0.5F * (a + b)}, {{0, 1, 2, 2}})
      .quad("floor", white, {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}});
  const Scene scene = builder.build("degenerate");
  const auto backend = GetParam().over(scene);
  for (int i = 1; i < 20; ++i) {
    const Hit hit = backend->closest_hit(downward(0.05F * static_cast<float>(i), 0.31F));
    ASSERT_TRUE(hit);
    EXPECT_EQ(scene.objects[scene.triangle_object[hit.triangle]].name, "floor");
    EXPECT_TRUE(std::isfinite(hit.u) && std::isfinite(hit.v) && std::isfinite(hit.distance));
  }
}

TEST_P(RayBackends, RefuseAnswersOfAnotherLength) {
  const auto backend = GetParam().over(made::box_scene());
  const std::vector<Ray> rays(3);
  std::vector<Hit> hits(2);
  std::vector<std::uint8_t> occluded(4);
  EXPECT_THAT([&] { backend->closest_hits(rays, hits); }, test::fails_check("one hit for each ray"));
  EXPECT_THAT([&] { backend->occlusions(rays, occluded); }, test::fails_check("one answer for each ray"));
}

TEST_P(RayBackends, AreCountedByTheStreamRayByRay) {
  const auto backend = GetParam().over(made::box_scene());
  RayCounts counts;
  std::vector<Ray> rays(37, downward(0.5F, 0.1F));
  std::vector<Hit> hits(rays.size());
  std::vector<std::uint8_t> occluded(rays.size());
  {
    RayStream stream(*backend, counts);
    stream.closest_hit(rays[0]);
    stream.closest_hits(rays, hits);
    stream.occluded(rays[0]);
    stream.occluded(rays[0]);
    stream.occlusions(rays, occluded);
    EXPECT_EQ(counts.closest_hit.load(), 0U);
  }
  {
    RayStream another(*backend, counts), third(*backend, counts);
    another.closest_hit(rays[0]);
  }
  EXPECT_EQ(counts.closest_hit.load(), 1U + 37U + 1U);
  EXPECT_EQ(counts.occlusion.load(), 2U + 37U);
}

INSTANTIATE_TEST_SUITE_P(Every, RayBackends, testing::ValuesIn(every_backend()));

/// Two backends behind one interface: whatever stands on a world need not know which it has.
class TwoBackends : public testing::TestWithParam<std::uint64_t> {};

TEST_P(TwoBackends, AnswerTheSameOnRandomScenes) {
  const std::uint64_t seed = GetParam();
  const float size = 0.1F + 0.1F * static_cast<float>(seed);
  const World embree(made::random_triangles(300 * seed, 1.0F, size, seed), 1);
  const World other(embree.scene(), 1, test::make_brute_force_backend);
  std::vector<Ray> rays = random_rays(1000, 1.2F, seed);
  for (std::size_t i = 0; i < rays.size(); i += 2) rays[i].t_min = 0.1F, rays[i].t_max = 0.9F;
  std::vector<Hit> hits(rays.size()), other_hits(rays.size());
  std::vector<std::uint8_t> occluded(rays.size()), other_occluded(rays.size());
  embree.rays().closest_hits(rays, hits);
  other.rays().closest_hits(rays, other_hits);
  embree.rays().occlusions(rays, occluded);
  other.rays().occlusions(rays, other_occluded);
  int met = 0, close_calls = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Scene& scene = embree.scene();
    if (test::brute_force(scene.vertices, scene.triangles, rays[i]).margin < 1e-5) {
      ++close_calls;
      continue;
    }
    ASSERT_EQ(hits[i].triangle, other_hits[i].triangle) << "ray " << i;
    EXPECT_EQ(occluded[i], other_occluded[i]) << "ray " << i;
    if (!hits[i]) continue;
    ++met;
    EXPECT_NEAR(hits[i].distance, other_hits[i].distance, 1e-5F * (1.0F + hits[i].distance));
    const SurfaceSample sample = embree.sample_of_hit(hits[i], rays[i].direction);
    const SurfaceSample other_sample = other.sample_of_hit(other_hits[i], rays[i].direction);
    EXPECT_LT(glm::distance(sample.position, other_sample.position), 2e-5F);
    EXPECT_EQ(sample.normal, other_sample.normal);
  }
  EXPECT_GT(met, 100);
  EXPECT_LT(close_calls, 100);
}

INSTANTIATE_TEST_SUITE_P(Seeds, TwoBackends, testing::Values(1, 2, 3, 4, 5));

}  // namespace
}  // namespace gibench
