#include "methods/pathtracer/pathtracer.h"

#include <algorithm>
#include <vector>

#include "common/core/random.h"
#include "methods/pathtracer/path_estimator.h"
#include "methods/pathtracer/replicate_sums.h"
#include "methods/pathtracer/settings.h"

namespace gibench {

namespace {

using pathtracer::PathEstimator;
using pathtracer::PathLight;
using pathtracer::ReplicateSums;
using pathtracer::Settings;

constexpr std::size_t values_per_chunk = 16;
constexpr std::uint64_t path_stage = 0x70617468ULL;

class PathTracer final : public TransportMethod {
 public:
  explicit PathTracer(const Settings& settings) : settings_(settings) {}

  Capabilities capabilities() const noexcept override {
    Capabilities can;
    can.effects.insert(all_effects().begin(), all_effects().end());
    can.quantities = {Quantity::radiance, Quantity::irradiance, Quantity::radiosity, Quantity::accessibility};
    can.variance = std::min(settings_.replicates, settings_.samples) >= 2;
    can.relights = true;
    return can;
  }

 private:
  void do_prepare(Task&, StageReport&) override {}

  void do_light(const Lighting&, Task&, StageReport&) override {
    estimator_ = std::make_unique<PathEstimator>(world(), direct_light().lights(), plan().max_bounces, settings_.roulette_bounce);
  }

  void do_shade(const ShadeRequest& request, const ShadeAnswer& answer, Task& task, StageReport&) const override {
    const std::size_t count = request.samples.size();
    const std::size_t round = std::max<std::size_t>(values_per_chunk, count / 64);  // values between two progress reports
    for (std::size_t first = 0; first < count && !task.cancelled(); first += round) {
      const std::size_t values = std::min(round, count - first);
      task.parallel_chunks(values, values_per_chunk, [&](const ChunkRange& range) {
        RayStream rays = task.rays(world());
        for (std::size_t i = first + range.begin; i < first + range.end && !task.cancelled(); ++i)
          estimate(request, i, mix_keys(task.seed(), path_stage, i), rays).write(answer, i);
      });
      task.progress("tracing paths", static_cast<double>(first + values) / static_cast<double>(count));
    }
    task.count("paths", count * settings_.samples);
  }

  /// All paths of one value: path i belongs to replicate i mod R and is that sequence's point i / R.
  ReplicateSums estimate(const ShadeRequest& request, std::size_t value, std::uint64_t key, RayStream& rays) const {
    ReplicateSums sums(std::min(settings_.replicates, settings_.samples));
    for (std::uint64_t i = settings_.first_sample; i < settings_.first_sample + settings_.samples; ++i) {
      const std::uint64_t replicate = i % settings_.replicates;
      SobolSampler random(mix_keys(key, replicate), static_cast<std::uint32_t>(i / settings_.replicates));
      sums.add(replicate % sums.count(), one_path(request, value, random, rays));
    }
    return sums;
  }

  PathLight one_path(const ShadeRequest& request, std::size_t value, SobolSampler& random, RayStream& rays) const {
    const SurfaceSample& at = request.samples[value];
    switch (request.quantity) {
      case Quantity::radiance: return estimator_->radiance(at, request.toward_viewer[value], random, rays);
      case Quantity::irradiance: return estimator_->irradiance(at, random, rays);
      case Quantity::radiosity: return estimator_->radiosity(at, random, rays);
      case Quantity::accessibility: return {Rgb(estimator_->accessibility(at, random, rays)), Rgb()};
    }
    return {};
  }

  Settings settings_;
  std::unique_ptr<PathEstimator> estimator_;
};

}  // namespace

MethodEntry pathtracer_entry() {
  return {"pathtracer",
          "unbiased path tracing with next-event estimation: the reference",
          "Kajiya 1986; Veach 1997",
          "C.*[LOB]",
          Settings::schema(),
          [](const Parameters& parameters) -> std::unique_ptr<TransportMethod> {
            return std::make_unique<PathTracer>(Settings::from(parameters));
          }};
}

}  // namespace gibench
