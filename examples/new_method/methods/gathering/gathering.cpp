#include "methods/gathering/gathering.h"

#include <memory>
#include <optional>
#include <vector>

#include "common/core/random.h"
#include "common/core/sampling.h"
#include "common/geometry/surface_sampling.h"
#include "methods/gathering/settings.h"

namespace gibench {

namespace gathering {

namespace {

constexpr std::size_t chunk_size = 16;
constexpr int light_samples = 4, most_bounces = 64;
/// Random numbers are keyed by (seed, stage, index).
constexpr std::uint64_t light_stage = 1, gather_stage = 2;

/// Indirect irradiance of diffuse surfaces: the last reflection before a sample is gathered over its hemisphere, those
/// before are one mean value for the whole scene (README.md).
class Gathering final : public TransportMethod {
 public:
  explicit Gathering(const Settings& settings) : settings_(settings) {}

  Capabilities capabilities() const noexcept override {
    Capabilities can;
    can.effects = {Effect::diffuse_indirect, Effect::environment, Effect::occlusion, Effect::two_sided, Effect::colour};
    can.quantities = {Quantity::irradiance};  // the session derives radiosity and radiance
    can.direct = false;                       // the session's evaluator adds it
    can.relights = true;
    return can;
  }

  std::size_t bytes() const override { return points_.size() * sizeof(SurfaceSample); }

  void prepare(const World& world, const EffectPlan& plan, Task& task, StageReport&) override {
    world_ = &world;
    max_bounces_ = plan.max_bounces.value_or(most_bounces);
    points_ = area_uniform_samples(world, static_cast<std::size_t>(settings_.points), task.seed());
    mean_albedo_ = Rgb();
    for (const SurfaceSample& point : points_) mean_albedo_ += albedo(point) / static_cast<float>(points_.size());
  }

  void light(const PlannedLights& lights, Task& task, StageReport&) override {
    direct_ = &lights.direct;
    std::vector<Rgb> reflected(points_.size());
    task.parallel_chunks(points_.size(), chunk_size, [&](const ChunkRange& range) {
      RayStream rays = task.rays(*world_);
      for (std::size_t i = range.begin; i < range.end; ++i)
        reflected[i] =
            albedo(points_[i]) * direct_->irradiance(points_[i], mix_keys(task.seed(), light_stage, i), light_samples, rays);
    });
    Rgb bounce;  // a mean over the scene: of light reflected once, twice, …
    for (const Rgb& value : reflected) bounce += value / static_cast<float>(reflected.size());
    ambient_ = Rgb();
    for (int reflections = 1; reflections < max_bounces_; ++reflections, bounce *= mean_albedo_) ambient_ += bounce;
  }

  void shade(const ShadeRequest& request, const ShadeAnswer& answer, Task& task, StageReport&) const override {
    task.parallel_chunks(answer.indirect.size(), chunk_size, [&](const ChunkRange& range) {
      RayStream rays = task.rays(*world_);
      for (std::size_t i = range.begin; i < range.end; ++i)
        answer.indirect[i] = gathered(request.samples[i], mix_keys(task.seed(), gather_stage, i), rays);
    });
  }

 private:
  Rgb albedo(const SurfaceSample& sample) const { return world_->scene().material_of_object(sample.object).diffuse; }

  /// π times the mean of ρ E / π over directions with density cos θ / π, E the light that reaches the surface met.
  Rgb gathered(const SurfaceSample& sample, std::uint64_t key, RayStream& rays) const {
    if (!sample.lit_side || max_bounces_ == 0) return {};
    const Frame frame(sample.normal);
    RandomStream random(key, 0, 0);
    Rgb sum;
    for (int ray = 0; ray < settings_.rays; ++ray) {
      const Vec2 square{random.next_float(), random.next_float()};
      const Vec3 direction = frame.to_world(cosine_hemisphere(square));
      const std::uint64_t light_key = random.next_bits();
      const Hit hit = rays.closest_hit({world_->ray_origin(sample), 0.0F, direction});
      if (!hit) continue;
      const SurfaceSample met = world_->sample_of_hit(hit, direction);
      if (met.lit_side) sum += albedo(met) * (direct_->irradiance(met, light_key, 1, rays) + ambient_);
    }
    return sum / static_cast<float>(settings_.rays);
  }

  Settings settings_;
  const World* world_ = nullptr;
  const DirectLight* direct_ = nullptr;  ///< of the last light()
  int max_bounces_ = 0;
  std::vector<SurfaceSample> points_;
  Rgb mean_albedo_, ambient_;
};

}  // namespace

}  // namespace gathering

MethodEntry gathering_entry() {
  MethodEntry entry;
  entry.name = "gathering";
  entry.summary = "final gathering over one mean value for the whole scene: an example of a method";
  entry.source = "Cohen, Chen, Wallace, Greenberg 1988 (the ambient term); Reichert 1992 (final gathering)";
  entry.light_paths = "C.{0,1}[LOB]|CDD+[LOB]";
  entry.schema = gathering::settings_schema();
  entry.make = [](const Parameters& parameters) -> std::unique_ptr<TransportMethod> {
    return std::make_unique<gathering::Gathering>(gathering::settings_from(parameters));
  };
  entry.quick = {{"rays", "4"}, {"points", "128"}};
  return entry;
}

}  // namespace gibench
