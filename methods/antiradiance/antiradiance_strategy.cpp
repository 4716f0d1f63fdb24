#include <optional>
#include <utility>

#include "methods/antiradiance/bin_transport.h"
#include "methods/antiradiance/glossy_sources.h"
#include "methods/antiradiance/linked_strategy.h"

namespace gibench::antiradiance {

namespace {

/// Negative light by direction in place of visibility; lobes as wide as a bin or wider.
class AntiradianceStrategy : public LinkedStrategy {
 public:
  using LinkedStrategy::LinkedStrategy;

  Capabilities capabilities() const override {
    Capabilities can = LinkedStrategy::capabilities();
    can.effects.insert({Effect::glossy_final_bounce, Effect::glossy_chain});
    return can;
  }

  std::optional<std::string> refusal(const Scene& scene) const override {
    for (const Object& object : scene.objects)
      if (std::string why = too_narrow_for_bins(scene.materials[object.material], settings().bins); !why.empty()) return why;
    return std::nullopt;
  }

  std::size_t bytes() const override {
    return LinkedStrategy::bytes() + static_cast<std::size_t>(by_direction_.size()) * sizeof(float);
  }

 private:
  static bool has_lobes(const EffectPlan& plan) {
    return plan.simulates(Effect::glossy_chain) || plan.simulates(Effect::glossy_final_bounce);
  }

  /// Where nothing hides anything no directions are kept, unless lobes need them.
  Visibility visibility(const EffectPlan& plan, bool hides) const override {
    return hides || has_lobes(plan) ? Visibility::antiradiance : Visibility::none_needed;
  }

  void clear_all() override { glossy_.reset(); }
  void clear_light() override { by_direction_.resize(0); }

  Interreflection solve(const World& world, const EffectPlan& plan, const PlannedLights& lights,
                        std::span<const std::uint32_t> materials, Surfaces& surfaces, std::span<const Rgb> direct,
                        Task& task) override {
    if (has_lobes(plan) && linking().bins) {
      glossy_.emplace(world.scene(), materials, *linking().bins);
      surfaces.keeps_directions = plan.simulates(Effect::glossy_final_bounce);
      if (plan.simulates(Effect::glossy_chain)) {
        surfaces.glossy = &*glossy_;
        surfaces.glossy_direct =
            glossy_direct_radiance(world, {lights.lighting, lights.direct.options().tests_visibility, settings().direct_samples},
                                   parts().elements, parts().hierarchy, *glossy_, *linking().bins, task);
      }
    }
    Interreflection solved = LinkedStrategy::solve(world, plan, lights, materials, surfaces, direct, task);
    by_direction_ = std::move(solved.by_direction);
    return solved;
  }

  Rgb lobe_radiance(const World& world, std::uint32_t element, const SurfaceSample& sample,
                    const Vec3& toward_viewer) const override {
    if (!glossy_ || by_direction_.size() == 0) return {};
    const std::size_t leaf = parts().hierarchy.leaf_of_element(element), count = linking().bins->count();
    if (!glossy_->is_glossy(leaf)) return {};
    std::vector<float> projected(count);
    projected_bins(*linking().bins, sample.normal, projected);
    return glossy_->radiance(world.scene().objects[sample.object].material, sample.normal, toward_viewer, projected,
                             by_direction_.data() + leaf * count * channels) *
           closure()[leaf];
  }

  Vector by_direction_;
  std::optional<GlossyReflection> glossy_;
};

}  // namespace

std::unique_ptr<Strategy> antiradiance_strategy(const Settings& settings) {
  return std::make_unique<AntiradianceStrategy>(settings);
}

}  // namespace gibench::antiradiance
