#include "methods/pathtracer/shade_job.h"

#include <algorithm>
#include <limits>

#include "common/core/random.h"

namespace gibench::pathtracer {

namespace {

constexpr std::uint64_t paths_stage = 0x7061746873ULL;
constexpr std::uint64_t units_a_round = 512;  // about a million paths between two reports of progress
constexpr std::uint64_t most_units_a_chunk = 8, least_chunks = 64;

std::uint64_t divided_up(std::uint64_t a, std::uint64_t b) { return (a + b - 1) / b; }

}  // namespace

ShadeJob::ShadeJob(const PathScene& scene, const SceneLights& lights, const PathRules& rules, const Settings& settings,
                   const EffectPlan& plan, const ShadeRequest& request, const ShadeAnswer& answer, Task& task)
    : scene_(scene),
      lights_(lights),
      rules_(rules),
      settings_(settings),
      request_(request),
      answer_(answer),
      task_(task),
      values_(request.samples.size()),
      units_per_value_(divided_up(settings.samples, PathBatch::capacity)),
      values_per_unit_(std::max<std::uint64_t>(1, PathBatch::capacity / settings.samples)),
      paths_per_unit_(divided_up(settings.samples, units_per_value_)),
      units_(cuts_values() ? values_ * units_per_value_ : divided_up(values_, values_per_unit_)),
      replicates_(std::min<std::uint64_t>(settings.replicates, settings.samples)),
      joined_(replicates_) {
  const bool total = !answer.total_variance.empty();
  bounds_.direct = total || !answer.direct.empty() || !answer.direct_variance.empty();
  bounds_.indirect = !plan.skips_indirect() && (total || !answer.indirect.empty() || !answer.indirect_variance.empty());
  bounds_.most_reflections = plan.max_bounces.value_or(std::numeric_limits<int>::max() - 1);
}

ShadeJob::Unit ShadeJob::unit(std::uint64_t number) const {
  if (cuts_values()) {
    const std::uint64_t first_path = number % units_per_value_ * paths_per_unit_;
    return {number / units_per_value_, 1, first_path, std::min(paths_per_unit_, settings_.samples - first_path)};
  }
  const std::uint64_t first_value = number * values_per_unit_;
  return {first_value, std::min(values_per_unit_, values_ - first_value), 0, settings_.samples};
}

void ShadeJob::run() {
  for (std::uint64_t first = 0; first < units_ && !task_.cancelled(); first += units_a_round) {
    const std::uint64_t end = std::min(units_, first + units_a_round);
    run_round(first, end - first);
    task_.progress("shade", static_cast<double>(end) / static_cast<double>(units_));
  }
  task_.count("paths", values_ * settings_.samples);
}

void ShadeJob::run_round(std::uint64_t first_unit, std::uint64_t units) {
  if (cuts_values()) unit_sums_.assign(units * replicates_, ReplicateSum());
  const std::uint64_t chunk_units = std::clamp<std::uint64_t>(units / least_chunks, 1, most_units_a_chunk);
  task_.parallel_chunks(units, chunk_units, [&](const ChunkRange& range) {
    RayStream rays = task_.rays(scene_.world);
    PathBatch batch(scene_, lights_, rules_, settings_, bounds_, rays);
    Workspace work;
    for (std::uint64_t i = range.begin; i < range.end && !task_.cancelled(); ++i) {
      const Unit traced = unit(first_unit + i);
      trace(traced, batch, work);
      if (cuts_values()) {
        add_up(traced, work.light, std::span(unit_sums_).subspan(i * replicates_, replicates_));
        continue;
      }
      work.sums.assign(traced.values * replicates_, ReplicateSum());
      add_up(traced, work.light, work.sums);
      for (std::uint64_t value = 0; value < traced.values; ++value)
        write(traced.first_value + value, work.asked[value], std::span(work.sums).subspan(value * replicates_, replicates_));
    }
  });
  if (cuts_values() && !task_.cancelled()) join(first_unit, units);
}

/// Traces the unit's paths, value by value.
void ShadeJob::trace(const Unit& unit, PathBatch& batch, Workspace& work) const {
  work.asked.clear();
  work.starts.clear();
  for (std::uint64_t i = 0; i < unit.values; ++i) work.asked.push_back(asked_at(unit.first_value + i));
  for (std::uint64_t i = 0; i < unit.values; ++i) {
    const std::uint64_t value_key = mix_keys(task_.seed(), paths_stage, unit.first_value + i);
    const std::uint64_t first = settings_.first_sample + unit.first_path;
    std::uint64_t replicate = first % settings_.replicates, index = first / settings_.replicates;
    for (std::uint64_t path = 0; path < unit.paths; ++path) {
      work.starts.push_back({&work.asked[i], {mix_keys(value_key, replicate), static_cast<std::uint32_t>(index)}});
      if (++replicate == settings_.replicates) replicate = 0, ++index;
    }
  }
  work.light.resize(work.starts.size());
  if (request_.quantity == Quantity::accessibility) batch.trace_openness(work.starts, work.light);
  else batch.trace(work.starts, work.light);
}

/// Adds the light of a unit's paths to the sums of its values' replicates.
void ShadeJob::add_up(const Unit& unit, std::span<const PathLight> light, std::span<ReplicateSum> sums) const {
  for (std::uint64_t value = 0; value < unit.values; ++value) {
    const std::span<ReplicateSum> of_value = sums.subspan(value * replicates_, replicates_);
    const std::span<const PathLight> of_paths = light.subspan(value * unit.paths, unit.paths);
    std::size_t replicate = (settings_.first_sample + unit.first_path) % replicates_;
    for (const PathLight& path : of_paths) {
      ReplicateSum& sum = of_value[replicate];
      sum.direct += RgbDouble(path.direct);
      sum.indirect += RgbDouble(path.indirect);
      ++sum.paths;
      if (++replicate == replicates_) replicate = 0;
    }
  }
}

/// Adds the sums of units to those of their values, in order; a value is written with its last unit.
void ShadeJob::join(std::uint64_t first_unit, std::uint64_t units) {
  for (std::uint64_t i = 0; i < units; ++i) {
    const std::uint64_t number = first_unit + i, value = number / units_per_value_;
    for (std::size_t r = 0; r < replicates_; ++r) joined_[r].add(unit_sums_[i * replicates_ + r]);
    if ((number + 1) % units_per_value_ != 0) continue;
    write(value, asked_at(value), joined_);
    joined_.assign(replicates_, ReplicateSum());
  }
}

AskedSurface ShadeJob::asked_at(std::uint64_t value) const {
  return {scene_, lights_, request_.quantity, request_.samples[value],
          request_.quantity == Quantity::radiance ? request_.toward_viewer[value] : Vec3(0.0F)};
}

void ShadeJob::write(std::uint64_t value, const AskedSurface& asked, std::span<const ReplicateSum> replicates) const {
  ValueEstimate result = estimate(replicates);
  if (asked.lit && rules_.accepts(PathAutomaton::start, PathEvent::emitter)) result.direct += RgbDouble(asked.emitted);
  const auto put = [&](std::span<Rgb> values, const RgbDouble& one) {
    if (!values.empty()) values[value] = Rgb(one);
  };
  put(answer_.direct, result.direct);
  put(answer_.indirect, result.indirect);
  put(answer_.direct_variance, result.direct_variance);
  put(answer_.indirect_variance, result.indirect_variance);
  put(answer_.total_variance, result.total_variance);
}

}  // namespace gibench::pathtracer
