/// Disc elements: links per second, what elements and links take in memory, and how the costs grow with the number of elements.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bench/micro/cpu_clock.h"
#include "bench/micro/peak_memory.h"
#include "common/scene/made_scenes.h"
#include "methods/antiradiance/accessibility.h"
#include "methods/antiradiance/discretisation.h"
#include "methods/antiradiance/refinement.h"

namespace gibench::micro {
namespace {

using namespace antiradiance;

/// Without closing rays all surfaces are in one space, as the box's are anyway.
Settings settings_for(std::int64_t elements, bool closing_rays = true) {
  std::vector<std::pair<std::string, std::string>> values{{"elements", std::to_string(elements)}};
  if (!closing_rays) values.emplace_back("closure_rays", "0");
  return settings_from(Parameters(settings_schema(), values));
}

Task task_with(int threads) { return Task({.seed = 1, .threads = threads, .cancel = {}, .on_progress = {}}); }

double wall_seconds() { return seconds_on(CLOCK_MONOTONIC); }

/// The same work on one thread and on two, in turn, by the clock on the wall.
class Scaling {
 public:
  template <class Work>
  void run(const Work& work) {
    if (!warm_) {  // whose memory is new even to the machine that a virtual one runs on
      Task task = task_with(2);
      work(task);
      warm_ = true;
    }
    for (const int threads : {1, 2}) {
      Task task = task_with(threads);
      const double wall = wall_seconds(), cpu = process_seconds();
      work(task);
      const auto at = static_cast<std::size_t>(threads - 1);
      wall_[at] += wall_seconds() - wall, cpu_[at] += process_seconds() - cpu;
    }
  }
  /// `amount`: of all work on one thread.
  void report(benchmark::State& state, const std::string& what, double amount) const {
    state.counters[what + "_per_second_1_thread"] = amount / wall_[0];
    state.counters[what + "_per_second_2_threads"] = amount / wall_[1];
    state.counters[what + "_per_second_per_core"] = amount / wall_[1] / 2.0;
    state.counters[what + "_per_cpu_second"] = amount / cpu_[1];
    state.counters["scaling"] = wall_[0] / wall_[1];
  }

 private:
  bool warm_ = false;
  std::array<double, 2> wall_{}, cpu_{};
};

/// Creation by the oracle: links are counted after it, with the form factors it finds, in rows by receiver. What form factors of
/// near pairs, rays or direction masks cost is not in it (see whole_linking).
void links(benchmark::State& state, Facing facing) {
  Task task = task_with(2);
  const World world(made::box_scene());
  const Discretisation parts(world, settings_for(16384), task);
  Scaling scaling;
  double made = 0.0, pairs = 0.0;
  for (auto _ : state)
    scaling.run([&](Task& on) {
      RefinementCounts counts;
      made = static_cast<double>(make_links(parts.hierarchy, {facing, 0.01F}, on, counts).size());
      pairs = static_cast<double>(counts.pairs);
    });
  scaling.report(state, "links", made * static_cast<double>(state.iterations()));
  state.counters["links"] = made;
  state.counters["pairs_per_link"] = pairs / made;
}
BENCHMARK_CAPTURE(links, fronts, Facing::fronts)->Iterations(5)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(links, both_sides, Facing::both)->Iterations(5)->UseRealTime()->Unit(benchmark::kMillisecond);

/// All there is to the links of a mode: the oracle, near pairs' form factors, and the mode's own (nothing; sixteen directions of
/// near pairs, and masks).
void whole_linking(benchmark::State& state, Visibility visibility) {
  Task task = task_with(2);
  const World world(made::box_scene());
  const Settings settings = settings_for(4096);
  const Discretisation parts(world, settings, task);
  Scaling scaling;
  double made = 0.0;
  for (auto _ : state)
    scaling.run(
        [&](Task& on) { made += static_cast<double>(make_linking(world, parts, settings, visibility, {}, on).links.size()); });
  scaling.report(state, "links", made / 2.0);
  state.counters["links"] = made / 2.0 / static_cast<double>(state.iterations());
}
BENCHMARK_CAPTURE(whole_linking, unoccluded, Visibility::none_needed)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_linking, antiradiance, Visibility::antiradiance)->UseRealTime()->Unit(benchmark::kMillisecond);

/// Resident memory at its highest above what there was before, by part: elements with all that belongs to them; links by the
/// oracle, with the blocks they are first kept in; the links of antiradiance, with masks and all copies on the way.
void memory(benchmark::State& state) {
  for (auto _ : state) {
    Task task = task_with(2);
    const World world(made::box_scene());
    const Settings settings = settings_for(16384);
    const PeakMemory at_start;
    const Discretisation parts(world, settings, task);
    const auto elements = static_cast<double>(parts.elements.size());
    state.counters["bytes_per_element"] = static_cast<double>(parts.bytes()) / elements;
    state.counters["peak_bytes_per_element"] = at_start.growth() / elements;
    {
      const PeakMemory before;
      RefinementCounts counts;
      const LinkTable table = make_links(parts.hierarchy, {Facing::both, 0.009F}, task, counts);
      const auto made = static_cast<double>(table.size());
      state.counters["oracle_links"] = made;
      state.counters["bytes_per_link"] = static_cast<double>(table.bytes()) / made;
      state.counters["peak_bytes_per_link"] = before.growth() / made;
    }
    const PeakMemory before;
    const Linking linking = make_linking(world, parts, settings, Visibility::antiradiance, {}, task);
    const auto made = static_cast<double>(linking.links.size());
    state.counters["masked_links"] = made;
    state.counters["bytes_per_masked_link"] = static_cast<double>(linking.bytes()) / made;
    state.counters["peak_bytes_per_masked_link"] = before.growth() / made;
    state.counters["peak_megabytes_of_10_million"] = 10.0 * before.growth() / made;
  }
}
BENCHMARK(memory)->Iterations(1)->Unit(benchmark::kMillisecond);

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

/// The default's passes, two of which go over all elements, with 1 k to `range(0)` k elements, four times as many each:
/// `exponent_of_seconds` and `exponent_of_blockers` are fitted to all sizes; n log n alone would give about 1.1.
void accessibility(benchmark::State& state) {
  const World world(made::box_scene());
  for (auto _ : state) {
    std::vector<double> sizes, seconds, blockers;
    for (std::int64_t elements = 1024; elements <= state.range(0) * 1024; elements *= 4) {
      Task task = task_with(2);
      const Discretisation parts(world, settings_for(elements, false), task);
      Accessibility passes(parts.elements, parts.hierarchy, 0.02F);
      const double start = process_seconds();
      passes.compute(3, task);
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

/// The hierarchy alone at 64 k elements on one and two threads.
void hierarchy(benchmark::State& state) {
  Task task = task_with(2);
  const World world(made::box_scene());
  const Discretisation parts(world, settings_for(65536, false), task);
  Scaling scaling;
  for (auto _ : state) scaling.run([&](Task& on) { benchmark::DoNotOptimize(Hierarchy(parts.elements, {}, on).size()); });
  scaling.report(state, "elements", static_cast<double>(parts.elements.size()) * static_cast<double>(state.iterations()));
}
BENCHMARK(hierarchy)->UseRealTime()->Unit(benchmark::kMillisecond);

/// Tiles on a floor and a ceiling, of `objects` objects: what the number of objects costs with the same 4 k elements.
void objects(benchmark::State& state) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  const auto count = static_cast<int>(state.range(0));
  const float size = 32.0F / static_cast<float>(count);
  for (int i = 0; i < count; ++i) {
    const float x = size * static_cast<float>(i / 2), y = i % 2 == 0 ? 0.0F : 4.0F, w = 0.95F * size;
    const std::array<Vec3, 4> tile{Vec3(x, y, 0.0F), Vec3(x, y, 8.0F), Vec3(x + w, y, 8.0F), Vec3(x + w, y, 0.0F)};
    builder.quad("tile " + std::to_string(i), white, i % 2 == 0 ? tile : std::array{tile[0], tile[3], tile[2], tile[1]});
  }
  const World world(builder.build("tiles"));
  Task task = task_with(2);
  const Discretisation parts(world, settings_for(4096, false), task);
  for (auto _ : state) {
    RefinementCounts counts;
    const double start = process_seconds();
    const LinkTable table = make_links(parts.hierarchy, {Facing::both, 0.01F}, task, counts);
    const double linked = process_seconds();
    Accessibility accessibility(parts.elements, parts.hierarchy, 0.02F, 8);
    accessibility.compute(3, task);
    state.counters["cpu_seconds_links"] = linked - start;
    state.counters["cpu_seconds_accessibility"] = process_seconds() - linked;
    state.counters["pairs_a_link"] = static_cast<double>(counts.pairs) / static_cast<double>(table.size());
    state.counters["elements"] = static_cast<double>(parts.hierarchy.leaf_count());
    state.counters["blockers_an_element"] =
        static_cast<double>(accessibility.evaluations()) / static_cast<double>(parts.hierarchy.leaf_count());
  }
}
BENCHMARK(objects)->Arg(10)->Arg(100)->Arg(1000)->ArgName("objects")->Iterations(1)->Unit(benchmark::kMillisecond);

/// Everything before the links, from 4 k to 256 k elements: CPU seconds of the whole discretisation with its rays, and of the
/// hierarchy; both should grow as n log n.
void discretisation(benchmark::State& state) {
  const World world(made::box_scene());
  for (auto _ : state) {
    std::vector<double> sizes, whole, tree;
    for (std::int64_t elements = 4096; elements <= 262144; elements *= 4) {
      Task task = task_with(2);
      const double start = process_seconds();
      const Discretisation parts(world, settings_for(elements), task);
      whole.push_back(process_seconds() - start);
      const double before = process_seconds();
      benchmark::DoNotOptimize(Hierarchy(parts.elements, {}, task).size());
      tree.push_back(process_seconds() - before);
      sizes.push_back(static_cast<double>(parts.hierarchy.leaf_count()));
      state.counters["cpu_seconds_" + std::to_string(elements / 1024) + "k"] = whole.back();
    }
    state.counters["exponent_of_discretisation"] = exponent(sizes, whole);
    state.counters["exponent_of_hierarchy"] = exponent(sizes, tree);
  }
}
BENCHMARK(discretisation)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gibench::micro
