#include "methods/pathtracer/shade_job.h"

#include <algorithm>
#include <array>
#include <limits>

#include "common/core/random.h"

namespace gibench::pathtracer {

namespace {

constexpr std::uint64_t paths_stage = 0x7061746873ULL;
constexpr std::uint64_t unit_paths = 2048;                    // of one value, traced by one thread in a row
constexpr std::uint64_t tile_paths = std::uint64_t{1} << 20;  // about so many between two tellings of the progress
constexpr std::uint64_t most_tile_values = 4096;

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
      units_per_value_((settings.samples + unit_paths - 1) / unit_paths) {
  const bool total = !answer.total_variance.empty();
  bounds_.direct = total || !answer.direct.empty() || !answer.direct_variance.empty();
  bounds_.indirect = !plan.skips_indirect() && (total || !answer.indirect.empty() || !answer.indirect_variance.empty());
  bounds_.most_reflections = plan.max_bounces.value_or(std::numeric_limits<int>::max() - 1);
}

void ShadeJob::run() {
  const std::uint64_t values = request_.samples.size();
  const std::uint64_t per_tile = std::clamp(tile_paths / settings_.samples, std::uint64_t{1}, most_tile_values);
  for (std::uint64_t first = 0; first < values && !task_.cancelled(); first += per_tile) {
    run_tile(first, std::min(per_tile, values - first));
    task_.progress("shade", static_cast<double>(std::min(values, first + per_tile)) / static_cast<double>(values));
  }
  task_.count("paths", values * settings_.samples);
}

void ShadeJob::run_tile(std::uint64_t first_value, std::uint64_t values) {
  const std::uint64_t units = values * units_per_value_, replicates = settings_.replicates;
  sums_.assign(units * replicates, ReplicateSum());
  const std::uint64_t chunk_units = std::max<std::uint64_t>(1, unit_paths / settings_.samples);
  task_.parallel_chunks(units, chunk_units, [&](const ChunkRange& range) {
    RayStream rays = task_.rays(scene_.world);
    PathBatch batch(scene_, lights_, rules_, settings_, bounds_, rays);
    for (std::uint64_t unit = range.begin; unit < range.end; ++unit)
      trace_unit(first_value + unit / units_per_value_, unit % units_per_value_, batch, &sums_[unit * replicates]);
  });
  if (task_.cancelled()) return;
  std::vector<ReplicateSum> of_value(replicates);
  for (std::uint64_t value = 0; value < values; ++value)
    write(first_value + value, &sums_[value * units_per_value_ * replicates], of_value);
}

void ShadeJob::trace_unit(std::uint64_t value, std::uint64_t unit, PathBatch& batch, ReplicateSum* sums) const {
  const bool radiance = request_.quantity == Quantity::radiance;
  const AskedSurface asked(scene_, lights_, request_.quantity, request_.samples[value],
                           radiance ? request_.toward_viewer[value] : Vec3(0.0F));
  const std::uint64_t value_key = mix_keys(task_.seed(), paths_stage, value);
  const std::uint64_t end = std::min(settings_.samples, (unit + 1) * unit_paths);
  std::array<PathRandom, PathBatch::capacity> random;
  std::array<PathLight, PathBatch::capacity> light;
  for (std::uint64_t begin = unit * unit_paths; begin < end && !task_.cancelled(); begin += PathBatch::capacity) {
    const std::uint64_t count = std::min<std::uint64_t>(PathBatch::capacity, end - begin);
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint64_t path = settings_.first_sample + begin + i;
      random[i] =
          PathRandom(mix_keys(value_key, path % settings_.replicates), static_cast<std::uint32_t>(path / settings_.replicates));
    }
    if (request_.quantity == Quantity::accessibility) batch.trace_openness(asked, {random.data(), count}, {light.data(), count});
    else batch.trace(asked, {random.data(), count}, {light.data(), count});
    for (std::uint64_t i = 0; i < count; ++i) {
      ReplicateSum& sum = sums[(settings_.first_sample + begin + i) % settings_.replicates];
      sum.direct += RgbDouble(light[i].direct);
      sum.indirect += RgbDouble(light[i].indirect);
      ++sum.paths;
    }
  }
}

void ShadeJob::write(std::uint64_t value, const ReplicateSum* sums, std::vector<ReplicateSum>& replicates) const {
  std::fill(replicates.begin(), replicates.end(), ReplicateSum());
  for (std::uint64_t unit = 0; unit < units_per_value_; ++unit)
    for (std::size_t r = 0; r < replicates.size(); ++r) replicates[r].add(sums[unit * replicates.size() + r]);
  ValueEstimate result = estimate(replicates);
  const AskedSurface asked(scene_, lights_, request_.quantity, request_.samples[value],
                           request_.quantity == Quantity::radiance ? request_.toward_viewer[value] : Vec3(0.0F));
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
