/// Rays through the ray backend against a bare Embree loop on the same rays, side by side.
#include <benchmark/benchmark.h>

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bench/micro/bare_embree.h"
#include "bench/micro/interleaved.h"
#include "bench/micro/many_triangles.h"
#include "common/ray/ray_stream.h"
#include "common/scene/made_scenes.h"

namespace gibench::micro {
namespace {

constexpr std::size_t batch = 256;    // rays handed to the backend at once, and rays of a gather
constexpr float short_length = 0.3F;  // of occlusion rays: about half of them are stopped

/// A scene with its rays.
struct Arena {
  World world;
  BareEmbree bare;
  std::vector<Ray> rays, short_rays, gathers, short_gathers;

  explicit Arena(Scene scene)
      : world(std::move(scene)),
        bare(world.scene()),
        rays(cosine_rays(world, {})),
        short_rays(cosine_rays(world, {.length = short_length, .seed = 2})),
        gathers(cosine_rays(world, {.rays_per_point = batch, .seed = 3})),
        short_gathers(cosine_rays(world, {.rays_per_point = batch, .length = short_length, .seed = 4})) {}
};

/// Made once, at the first benchmark that asks for it.
const Arena& arena(bool many) {
  static const Arena spheres(bumpy_spheres()), box(made::box_scene());
  return many ? spheres : box;
}

RayCounts& counts() {
  static RayCounts all;
  return all;
}

std::uint64_t hits_one_by_one(const World& world, std::span<const Ray> rays) {
  RayStream stream(world.rays(), counts());
  std::uint64_t sum = 0;
  for (const Ray& ray : rays)
    if (const Hit hit = stream.closest_hit(ray)) sum += hit.triangle + 1U;
  return sum;
}

std::uint64_t hits_batched(const World& world, std::span<const Ray> rays) {
  RayStream stream(world.rays(), counts());
  std::array<Hit, batch> hits;
  std::uint64_t sum = 0;
  for (std::size_t first = 0; first < rays.size(); first += batch) {
    stream.closest_hits(rays.subspan(first, batch), hits);
    for (const Hit& hit : hits)
      if (hit) sum += hit.triangle + 1U;
  }
  return sum;
}

std::uint64_t occlusions_one_by_one(const World& world, std::span<const Ray> rays) {
  RayStream stream(world.rays(), counts());
  std::uint64_t sum = 0;
  for (const Ray& ray : rays) sum += stream.occluded(ray) ? 1U : 0U;
  return sum;
}

std::uint64_t occlusions_batched(const World& world, std::span<const Ray> rays) {
  RayStream stream(world.rays(), counts());
  std::array<std::uint8_t, batch> occluded;
  std::uint64_t sum = 0;
  for (std::size_t first = 0; first < rays.size(); first += batch) {
    stream.occlusions(rays.subspan(first, batch), occluded);
    for (const std::uint8_t one : occluded) sum += one;
  }
  return sum;
}

/// One line of the table.
struct Case {
  std::string name;
  std::string ratio;  ///< name of the counter
  std::function<std::uint64_t(const Arena&, std::span<const Ray>)> measured;
  std::uint64_t (BareEmbree::*bare)(std::span<const Ray>) const;
  std::vector<Ray> Arena::*rays;
};

std::vector<Case> cases() {
  const auto backend = [](std::uint64_t (*trace)(const World&, std::span<const Ray>)) {
    return [=](const Arena& in, std::span<const Ray> rays) { return trace(in.world, rays); };
  };
  const auto packets = [](std::uint64_t (BareEmbree::*trace)(std::span<const Ray>) const) {
    return [=](const Arena& in, std::span<const Ray> rays) { return (in.bare.*trace)(rays); };
  };
  const auto hits = &BareEmbree::closest_hits, occlusions = &BareEmbree::occlusions;
  const std::string ratio = "backend_over_bare", bare_ratio = "packets_over_bare";
  std::vector<Case> all;
  for (const bool gather : {false, true}) {
    const std::string suffix = gather ? "_gather" : "";
    const auto rays = gather ? &Arena::gathers : &Arena::rays;
    const auto short_rays = gather ? &Arena::short_gathers : &Arena::short_rays;
    all.push_back({"closest_hit" + suffix, ratio, backend(hits_one_by_one), hits, rays});
    all.push_back({"closest_hits_batched" + suffix, ratio, backend(hits_batched), hits, rays});
    all.push_back({"occluded" + suffix, ratio, backend(occlusions_one_by_one), occlusions, short_rays});
    all.push_back({"occlusions_batched" + suffix, ratio, backend(occlusions_batched), occlusions, short_rays});
    all.push_back({"bare_closest_hits_8" + suffix, bare_ratio, packets(&BareEmbree::closest_hits_in_packets<8>), hits, rays});
    all.push_back({"bare_closest_hits_16" + suffix, bare_ratio, packets(&BareEmbree::closest_hits_in_packets<16>), hits, rays});
    all.push_back(
        {"bare_occlusions_8" + suffix, bare_ratio, packets(&BareEmbree::occlusions_in_packets<8>), occlusions, short_rays});
    all.push_back(
        {"bare_occlusions_16" + suffix, bare_ratio, packets(&BareEmbree::occlusions_in_packets<16>), occlusions, short_rays});
  }
  return all;
}

void measure(benchmark::State& state, const Case& one, bool many, int threads) {
  const Arena& in = arena(many);
  race(
      state, one.ratio.c_str(), [&](std::span<const Ray> rays) { return one.measured(in, rays); },
      [&](std::span<const Ray> rays) { return (in.bare.*one.bare)(rays); }, in.*one.rays, threads);
}

const bool registered = [] {
  for (const bool many : {true, false})
    for (const int threads : {1, 2})
      for (const Case& one : cases()) {
        const std::string name = one.name + (many ? "/spheres" : "/box") + "/threads:" + std::to_string(threads);
        benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { measure(state, one, many, threads); })
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond);
      }
  return true;
}();

}  // namespace
}  // namespace gibench::micro
