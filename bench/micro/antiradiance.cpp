/// Disc elements: links per second, what a link costs in memory, and how accessibility grows with the number of elements.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bench/micro/cpu_clock.h"
#include "methods/antiradiance/accessibility.h"
#include "methods/antiradiance/discretisation.h"
#include "methods/antiradiance/exchange.h"
#include "methods/antiradiance/refinement.h"
#include "tests/support/scene_builder.h"

namespace gibench::micro {
namespace {

using namespace antiradiance;

Settings settings_for(std::int64_t elements) {
  return settings_from(Parameters(settings_schema(), {{"elements", std::to_string(elements)}}));
}

Task task_with(int threads) { return Task({.seed = 1, .threads = threads, .cancel = {}, .on_progress = {}}); }

/// Creation by the oracle, with the factors it finds, in rows by receiver: `links_per_second` by the clock on the wall,
/// `links_per_cpu_second` for one busy thread; `pairs_per_link` looked at; `bytes_per_link` of the table (and 10 with masks).
void links(benchmark::State& state, Facing facing) {
  const auto threads = static_cast<int>(state.range(0));
  Task task = task_with(threads);
  const World world(test::box_scene());
  const Discretisation parts(world, settings_for(16384), task);
  double made = 0.0, pairs = 0.0, cpu = 0.0, bytes = 0.0;
  for (auto _ : state) {
    RefinementCounts counts;
    const double start = process_seconds();
    const LinkTable table = make_links(parts.hierarchy, {facing, 0.01F}, task, counts);
    cpu += process_seconds() - start;
    made += static_cast<double>(table.size());
    pairs += static_cast<double>(counts.pairs);
    bytes = static_cast<double>(table.bytes()) / static_cast<double>(table.size());
  }
  state.counters["links_per_second"] = benchmark::Counter(made, benchmark::Counter::kIsRate);
  state.counters["links_per_cpu_second"] = made / cpu;
  state.counters["pairs_per_link"] = pairs / made;
  state.counters["bytes_per_link"] = bytes;
  state.counters["links"] = made / static_cast<double>(state.iterations());
}
BENCHMARK_CAPTURE(links, fronts, Facing::fronts)
    ->Arg(1)
    ->Arg(2)
    ->ArgName("threads")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(links, both_sides, Facing::both)
    ->Arg(1)
    ->Arg(2)
    ->ArgName("threads")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// Slope of the logarithms, by least squares.
double exponent(const std::vector<double>& sizes, const std::vector<double>& costs) {
  double mean_x = 0.0, mean_y = 0.0, above = 0.0, below = 0.0;
  const auto count = static_cast<double>(sizes.size());
  for (std::size_t i = 0; i < sizes.size(); ++i) mean_x += std::log(sizes[i]) / count, mean_y += std::log(costs[i]) / count;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double x = std::log(sizes[i]) - mean_x;
    above += x * (std::log(costs[i]) - mean_y);
    below += x * x;
  }
  return above / below;
}

/// Two passes over 1 k to `range(0)` k elements, four times as many each: `exponent_of_seconds` and `exponent_of_blockers` are
/// fitted to all sizes; n log n alone would give about 1.1.
void accessibility(benchmark::State& state) {
  const World world(test::box_scene());
  for (auto _ : state) {
    std::vector<double> sizes, seconds, blockers;
    for (std::int64_t elements = 1024; elements <= state.range(0) * 1024; elements *= 4) {
      Task task = task_with(2);
      const Discretisation parts(world, settings_for(elements), task);
      Accessibility passes(parts.elements, parts.hierarchy, 0.02F);
      const double start = process_seconds();
      passes.compute(2, task);
      seconds.push_back(process_seconds() - start);
      sizes.push_back(static_cast<double>(parts.hierarchy.leaf_count()));
      blockers.push_back(static_cast<double>(passes.evaluations()));
      state.counters["cpu_seconds_" + std::to_string(elements / 1024) + "k"] = seconds.back();
    }
    state.counters["exponent_of_seconds"] = exponent(sizes, seconds);
    state.counters["exponent_of_blockers"] = exponent(sizes, blockers);
  }
}
BENCHMARK(accessibility)->Arg(16)->Arg(256)->ArgName("thousands")->Iterations(1)->Unit(benchmark::kMillisecond);

/// The hierarchy alone, in parallel, n log n.
void hierarchy(benchmark::State& state) {
  const auto threads = static_cast<int>(state.range(0));
  Task task = task_with(threads);
  const World world(test::box_scene());
  const Discretisation parts(world, settings_for(65536), task);
  for (auto _ : state) benchmark::DoNotOptimize(Hierarchy(parts.elements, {}, task).size());
  state.counters["elements"] = static_cast<double>(parts.elements.size());
  state.counters["bytes_per_element"] =
      static_cast<double>(parts.elements.bytes() + parts.hierarchy.bytes()) / static_cast<double>(parts.elements.size());
}
BENCHMARK(hierarchy)->Arg(1)->Arg(2)->ArgName("threads")->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gibench::micro
