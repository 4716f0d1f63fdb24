#include "tests/contract/ambient_method.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "common/core/random.h"
#include "common/geometry/surface_sampling.h"

namespace gibench::contract {

namespace {

constexpr std::size_t point_count = 512, chunk_size = 16;
constexpr int light_samples = 16;
constexpr std::uint64_t light_stage = 1;

/// The irradiance of a room in which every point sees the same: the mean direct irradiance E over the surfaces and
/// their mean albedo ρ give E (ρ + ρ² + … + ρᵇ) for at most b bounces.
class AmbientMethod : public TransportMethod {
 public:
  explicit AmbientMethod(Defect defect) : defect_(defect) {}

  Capabilities capabilities() const noexcept override {
    Capabilities can;
    can.effects = {Effect::direct, Effect::diffuse_indirect, Effect::environment, Effect::occlusion};
    can.quantities = {Quantity::radiance, Quantity::irradiance};
    if (is(Defect::answers_radiance_alone)) can.quantities = {Quantity::radiance};
    if (answers_irradiance_alone()) can.quantities = {Quantity::irradiance};
    if (is(Defect::claims_unseen_lobes)) can.effects.insert(Effect::glossy_final_bounce);
    // As its own direct light the plan never spares it a call.
    can.direct = is(Defect::works_for_nothing) || is(Defect::answers_parts_otherwise);
    can.variance = is(Defect::claims_negative_variance) || is(Defect::knows_variance_by_halves) || is(Defect::is_a_little_off);
    can.relights = true;
    return can;
  }

  std::optional<std::string> refusal(const Scene& scene) const override {
    if (defect_ == Defect::refuses_plain_scenes) return "there are surfaces in this scene";
    if (defect_ == Defect::refuses_by_turns && (asked_++ % 2) == 0) return "not this time";
    for (const Material& material : scene.materials)
      if (material.bsdf != Bsdf::diffuse) return defect_ == Defect::refuses_with_a_code ? "E17" : "a material is not diffuse";
    return std::nullopt;
  }

  std::string light_paths(const EffectPlan& plan, const BounceRange& range) const override {
    return is(Defect::misnames_its_paths) ? "C.*[LOB]" : light_paths_of(plan, true, range);
  }

  void prepare(const World& world, const EffectPlan& plan, Task& task, StageReport&) override {
    world_ = &world;
    max_bounces_ = plan.max_bounces;
    if (is(Defect::keeps_what_was_cancelled) && task.cancelled()) stained_ = true;
    points_ = area_uniform_samples(world, point_count, task.seed());
    albedo_ = Rgb();
    for (const SurfaceSample& point : points_)
      albedo_ += world.scene().material_of_object(point.object).diffuse / static_cast<float>(points_.size());
    if (is(Defect::reflects_off_black))
      for (int channel = 0; channel < 3; ++channel) albedo_[channel] = std::max(albedo_[channel], 0.01F);
    if (is(Defect::looks_for_what_hides) || is(Defect::works_for_nothing)) {
      RayStream rays = task.rays(world);
      for (const SurfaceSample& point : points_) rays.occluded({world.ray_origin(point), 0.0F, point.normal});
    }
    task.progress("points", 1.0);
  }

  void light(const PlannedLights& lights, Task& task, StageReport&) override {
    if (is(Defect::sees_one_kind_of_light)) partial_light_ = seen_part(lights.lighting);
    const DirectLight& direct = partial_light_ ? *partial_light_ : lights.direct;
    std::vector<Rgb> found(points_.size());
    const auto body = [&](const ChunkRange& range) {
      RayStream rays = task.rays(world());
      for (std::size_t i = range.begin; i < range.end; ++i)
        found[i] = direct.irradiance(points_[i], mix_keys(task.seed(), light_stage, i), light_samples, rays);
    };
    task.progress("lights", 0.0);
    if (is(Defect::works_on_when_cancelled)) parallel_chunks(task.threads(), found.size(), chunk_size, body);
    else task.parallel_chunks(found.size(), chunk_size, body);
    Rgb mean;
    for (const Rgb& value : found) mean += value / static_cast<float>(found.size());
    if (is(Defect::piles_up_relit_light)) ambient_ += mean * bounced();
    else ambient_ = mean * bounced();
    if (is(Defect::adds_a_constant) && !is_black(mean)) ambient_ += Rgb(0.01F);
    if (is(Defect::drops_dim_light) && luminance(mean) < 1e-3F) ambient_ = Rgb();
    if (is(Defect::glows_without_light) && is_black(mean)) ambient_ = Rgb(1e-6F);
    if (is(Defect::knows_the_metre)) ambient_ *= 1.0F + 0.1F * world().diagonal();
    if (is(Defect::counts_its_threads)) ambient_ *= 1.0F + 1e-6F * static_cast<float>(task.threads());
    if (is(Defect::draws_unkeyed_numbers)) ambient_ *= 1.0F + 1e-6F * static_cast<float>(unkeyed_++);
    if (stained_) ambient_ *= 1.01F;
  }

  void edit(const SceneEdit& edit, const World& after, const EffectPlan& plan, const PlannedLights& lights, Task& task,
            StageReport& report) override {
    if (!is(Defect::overlooks_edits)) TransportMethod::edit(edit, after, plan, lights, task, report);
    else world_ = &after;
  }

  void shade(const ShadeRequest& request, const ShadeAnswer& answer, Task&, StageReport&) const override {
    for (std::size_t i = 0; i < answer.indirect.size(); ++i) answer.indirect[i] = value(request, i);
    if (is(Defect::answers_parts_otherwise) && answer.direct.empty())
      for (Rgb& one : answer.indirect) one *= 1.01F;
    std::fill(answer.direct.begin(), answer.direct.end(), Rgb());
    for (std::span<Rgb> variance : {answer.direct_variance, answer.indirect_variance, answer.total_variance})
      for (Rgb& one : variance) one = Rgb(is(Defect::claims_negative_variance) ? -1.0F : 0.0F);
    if (is(Defect::knows_variance_by_halves) && answer.direct_variance.empty())
      std::fill(answer.total_variance.begin(), answer.total_variance.end(), Rgb(std::numeric_limits<float>::quiet_NaN()));
    if (is(Defect::leaves_a_gap) && !answer.indirect.empty())
      answer.indirect.back() = Rgb(std::numeric_limits<float>::quiet_NaN());
  }

 private:
  bool is(Defect defect) const { return defect_ == defect; }
  bool answers_irradiance_alone() const { return is(Defect::answers_irradiance_alone) || is(Defect::claims_unseen_lobes); }
  const World& world() const { return *world_; }

  /// Emission alone where there is any.
  std::unique_ptr<DirectLight> seen_part(Lighting lighting) const {
    for (const Rgb& emission : lighting.emission)
      if (!is_black(emission)) lighting.lights.clear();
    return std::make_unique<DirectLight>(world(), lighting);
  }

  /// ρ + ρ² + … for each channel, as many terms as the plan allows.
  Rgb bounced() const {
    Rgb sum, power(1.0F);
    const int most = is(Defect::ignores_the_bound) ? 64 : max_bounces_.value_or(64);
    for (int bounce = 0; bounce < most; ++bounce) sum += power *= albedo_;
    return is(Defect::dims_with_bounces) && most > 1 ? 0.5F * albedo_ : sum;
  }

  Rgb value(const ShadeRequest& request, std::size_t i) const {
    const SurfaceSample& sample = request.samples[i];
    if (!sample.lit_side && !is(Defect::lights_the_backs)) return Rgb();
    const Material& material = world().scene().material_of_object(sample.object);
    Rgb light = ambient_;
    if (request.quantity == Quantity::radiance) light *= material.diffuse / pi;
    if (is(Defect::knows_the_vertical)) light *= 1.0F + 0.1F * sample.normal.y;
    if (is(Defect::is_a_little_off)) light *= 1.0F + 0.01F * sample.normal.y;
    if (is(Defect::goes_below_zero) && i == 0) light *= -1.0F;
    if (is(Defect::writes_not_a_number)) light *= material.diffuse.r / material.diffuse.r;
    return light;
  }

  Defect defect_;
  const World* world_ = nullptr;
  std::optional<int> max_bounces_;
  std::vector<SurfaceSample> points_;
  std::unique_ptr<DirectLight> partial_light_;
  Rgb albedo_, ambient_;
  bool stained_ = false;
  mutable int asked_ = 0;
  int unkeyed_ = 0;
};

ParameterSchema schema() {
  return {{"points", std::int64_t{16}, 1, 64, {}, "points of the scene, a count"},
          {"reach", 0.5, 0.0, 1.0, {}, "share of the diagonal"},
          {"lively", true, 0, 0, {}, "whether it is"},
          {"shape", std::string("round"), 0, 0, {"round", "square"}, "of a point"}};
}

template <std::size_t defect>
std::unique_ptr<TransportMethod> make(const Parameters&) {
  return std::make_unique<AmbientMethod>(static_cast<Defect>(defect));
}

/// One maker for every defect: an entry holds a plain function.
template <std::size_t... defects>
constexpr auto makers(std::index_sequence<defects...>) {
  return std::array{&make<defects>...};
}

}  // namespace

MethodEntry ambient_method(Defect defect) {
  constexpr auto all = makers(std::make_index_sequence<static_cast<std::size_t>(Defect::answers_irradiance_alone) + 1>());
  return {"ambient", "one mean value for the whole scene", "the geometric series", "C(<RD>|L)",
          schema(),  all[static_cast<std::size_t>(defect)]};
}

}  // namespace gibench::contract
