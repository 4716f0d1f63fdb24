/// Rays through the ray backend against a bare Embree loop on the same rays, side by side.
#include <benchmark/benchmark.h>

#include <array>
#include <limits>
#include <vector>

#include "bench/micro/bare_embree.h"
#include "bench/micro/interleaved.h"
#include "bench/micro/many_triangles.h"
#include "common/ray/ray_stream.h"
#include "tests/support/scene_builder.h"

namespace gibench::micro {
namespace {

constexpr std::size_t ray_count = 1U << 19;
constexpr std::size_t batch = 256;  // rays handed to the backend at once

/// A scene with its rays: made once, at the first benchmark that asks for it.
struct Arena {
  World world;
  BareEmbree bare;
  std::vector<Ray> rays, short_rays;  ///< to the closest hit; as far as a tenth of the room: about half are stopped

  explicit Arena(Scene scene)
      : world(std::move(scene)),
        bare(world.scene()),
        rays(incoherent_rays(world, ray_count, 1, std::numeric_limits<float>::infinity())),
        short_rays(incoherent_rays(world, ray_count, 2, 0.3F)) {}
};

const Arena& arena(bool many) {
  static const Arena spheres(bumpy_spheres()), box(test::box_scene());
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

using Measured = std::uint64_t (*)(const World&, std::span<const Ray>);
using Bare = std::uint64_t (BareEmbree::*)(std::span<const Ray>) const;

void measure(benchmark::State& state, Measured measured, Bare bare, bool occlusion, bool many, int threads) {
  const Arena& in = arena(many);
  race(
      state, "backend_over_bare", [&](std::span<const Ray> rays) { return measured(in.world, rays); },
      [&](std::span<const Ray> rays) { return (in.bare.*bare)(rays); }, occlusion ? in.short_rays : in.rays, threads);
}

/// Bare packets against the bare loop: what packets themselves are worth on these rays.
void measure_packets(benchmark::State& state, Bare packets, Bare bare, bool occlusion, bool many, int threads) {
  const Arena& in = arena(many);
  race(
      state, "packets_over_bare", [&](std::span<const Ray> rays) { return (in.bare.*packets)(rays); },
      [&](std::span<const Ray> rays) { return (in.bare.*bare)(rays); }, occlusion ? in.short_rays : in.rays, threads);
}

void add(const std::string& name, const std::function<void(benchmark::State&)>& body) {
  benchmark::RegisterBenchmark(name.c_str(), body)->UseManualTime()->Unit(benchmark::kMillisecond);
}

const bool registered = [] {
  for (const bool many : {true, false})
    for (const int threads : {1, 2}) {
      const std::string in = std::string(many ? "/spheres" : "/box") + "/threads:" + std::to_string(threads);
      const auto versus_bare = [&](const std::string& name, Measured measured, Bare bare, bool occlusion) {
        add(name + in, [=](benchmark::State& state) { measure(state, measured, bare, occlusion, many, threads); });
      };
      versus_bare("closest_hit", hits_one_by_one, &BareEmbree::closest_hits, false);
      versus_bare("closest_hits_batched", hits_batched, &BareEmbree::closest_hits, false);
      versus_bare("occluded", occlusions_one_by_one, &BareEmbree::occlusions, true);
      versus_bare("occlusions_batched", occlusions_batched, &BareEmbree::occlusions, true);
      const auto packets = [&](const std::string& name, Bare measured, Bare bare, bool occlusion) {
        add(name + in, [=](benchmark::State& state) { measure_packets(state, measured, bare, occlusion, many, threads); });
      };
      packets("bare_closest_hits_8", &BareEmbree::closest_hits_in_packets<8>, &BareEmbree::closest_hits, false);
      packets("bare_closest_hits_16", &BareEmbree::closest_hits_in_packets<16>, &BareEmbree::closest_hits, false);
      packets("bare_occlusions_8", &BareEmbree::occlusions_in_packets<8>, &BareEmbree::occlusions, true);
      packets("bare_occlusions_16", &BareEmbree::occlusions_in_packets<16>, &BareEmbree::occlusions, true);
    }
  return true;
}();

}  // namespace
}  // namespace gibench::micro
