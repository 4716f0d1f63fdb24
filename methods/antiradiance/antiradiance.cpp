#include "methods/antiradiance/antiradiance.h"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <utility>

#include "common/core/random.h"
#include "common/effects/scene_effects.h"
#include "common/geometry/has_area.h"
#include "methods/antiradiance/accessibility.h"
#include "methods/antiradiance/bin_transport.h"
#include "methods/antiradiance/discretisation.h"
#include "methods/antiradiance/interreflection.h"
#include "methods/antiradiance/settings.h"
#include "methods/antiradiance/sky_as_ambient.h"
#include "methods/antiradiance/sources.h"

namespace gibench {

namespace {

using namespace antiradiance;

constexpr std::size_t shade_chunk = 64;  // samples
constexpr std::uint64_t asked_stage = 0x61736b6564ULL;

class Antiradiance : public TransportMethod {
 public:
  explicit Antiradiance(const Settings& settings) : settings_(settings) {}

  Capabilities capabilities() const noexcept override {
    Capabilities can;
    can.effects = {Effect::direct, Effect::environment, Effect::occlusion};
    can.quantities = {Quantity::irradiance, Quantity::radiance};
    can.relights = true;
    can.direct = answers_accessibility();
    can.indirect = !answers_accessibility();
    if (answers_accessibility()) can.quantities.insert(Quantity::accessibility);
    else can.effects.insert(Effect::diffuse_indirect);
    if (settings_.mode == Mode::antiradiance) can.effects.insert({Effect::glossy_final_bounce, Effect::glossy_chain});
    return can;
  }

  std::optional<std::string> refusal(const Scene& scene) const override {
    if (settings_.mode == Mode::antiradiance)
      for (const Object& object : scene.objects)
        if (std::string why = too_narrow_for_bins(scene.materials[object.material], settings_.bins); !why.empty()) return why;
    if (has_area(scene)) return std::nullopt;
    return "every face of the scene has zero area: there is nowhere to put elements";
  }

  std::size_t bytes() const override {
    return (parts_ ? parts_->bytes() : 0) + linking_.bytes() + closure_.capacity() * sizeof(float) +
           indirect_.capacity() * sizeof(Rgb) + static_cast<std::size_t>(by_direction_.size()) * sizeof(float) +
           (accessibility_ ? accessibility_->bytes() : 0);
  }

  void prepare(const World& world, const EffectPlan& plan, Task& task, StageReport& report) override {
    world_ = &world;
    plan_ = plan;
    parts_.reset();
    linking_ = {};
    closure_.clear();
    indirect_.clear();
    accessibility_.reset();
    glossy_.reset();
    if (!simulates_indirect() && !answers_accessibility()) {
      report.message = "no interreflection is called for: no elements made";
      return;
    }
    parts_ = std::make_unique<Discretisation>(world, settings_, task);
    task.count("elements", parts_->elements.size());
    task.count("elements_inside_geometry", parts_->elements.size() - parts_->hierarchy.leaf_count());
    task.count("nodes", parts_->hierarchy.size());
    task.progress("elements", 0.1);
    if (task.cancelled()) return;
    if (answers_accessibility()) {
      accessibility_.emplace(parts_->elements, parts_->hierarchy, settings_.far_enough, settings_.sectors);
      accessibility_->compute(settings_.passes, task);
      task.count("blockers", accessibility_->evaluations());
    } else if (settings_.oracle == OracleKind::geometry) {
      link({}, task, report);
    }
  }

  void light(const PlannedLights& lights, Task& task, StageReport& report) override {
    direct_light_ = &lights.direct;
    indirect_.clear();
    by_direction_.resize(0);
    if (answers_accessibility()) {
      DirectLightOptions options;
      options.tests_visibility = lights.direct.options().tests_visibility;
      options.glossy = !plan().forbids(Effect::glossy_final_bounce);
      sky_.emplace(world(), lights.lighting, options);
      return;
    }
    if (!parts_ || direct_light().dark()) {
      report.message = parts_ ? "no light: nothing to transport" : "nothing to transport";
      return;
    }
    const std::vector<Rgb> direct =
        direct_irradiance(world(), direct_light(), parts_->elements, parts_->hierarchy, settings_.direct_samples, task);
    task.progress("direct light", 0.1);
    if (task.cancelled()) return;
    Surfaces surfaces = surfaces_of_leaves();
    if (settings_.oracle == OracleKind::radiosity) {
      link(foreseen_radiosity(direct, surfaces.albedo), task, report);
      if (!succeeded(report.termination) || task.cancelled()) return;
    }
    surfaces.closure = closure_;
    const Interreflection solved = settings_.mode == Mode::disc_bounce
                                       ? disc_bounce(*parts_, linking_, settings_, surfaces, direct, task)
                                       : interreflect(*parts_, linking_, settings_, surfaces, direct, task);
    report.termination = solved.termination;
    report.message = report.message.empty() || solved.message.empty() ? report.message + solved.message
                                                                      : report.message + "; " + solved.message;
    task.count("iterations", static_cast<std::uint64_t>(solved.iterations));
    by_direction_ = solved.by_direction;
    std::vector<Rgb> means(parts_->elements.size());
    for (std::size_t leaf = 0; leaf < solved.irradiance.size(); ++leaf)
      means[parts_->hierarchy.order()[leaf]] = solved.irradiance[leaf];
    indirect_ = parts_->reconstruction.vertex_values(means);
  }

  void shade(const ShadeRequest& request, const ShadeAnswer& answer, Task& task, StageReport&) const override {
    task.parallel_chunks(request.samples.size(), shade_chunk, [&](const ChunkRange& range) {
      RayStream rays = task.rays(world());
      for (std::size_t i = range.begin; i < range.end; ++i) {
        const SurfaceSample& sample = request.samples[i];
        const Vec3* viewer = request.quantity == Quantity::radiance ? &request.toward_viewer[i] : nullptr;
        if (request.quantity == Quantity::accessibility) {
          if (!answer.direct.empty()) answer.direct[i] = Rgb(accessibility_->at(world().ray_origin(sample), sample.normal));
          if (!answer.indirect.empty()) answer.indirect[i] = Rgb();
          continue;
        }
        if (!answer.direct.empty())
          answer.direct[i] =
              sky_->answer(sample, viewer, mix_keys(task.seed(), i), request.samples.size(), *accessibility_, rays);
        if (!answer.indirect.empty()) answer.indirect[i] = indirect(sample, viewer, task.seed(), rays);
      }
    });
  }

 private:
  const World& world() const { return *world_; }
  const EffectPlan& plan() const { return plan_; }
  const DirectLight& direct_light() const { return *direct_light_; }

  bool answers_accessibility() const { return settings_.mode == Mode::accessibility; }
  bool simulates_indirect() const {
    const EffectSet& simulated = plan().simulated;
    return (simulated.contains(Effect::diffuse_indirect) || simulated.contains(Effect::glossy_chain) ||
            simulated.contains(Effect::glossy_final_bounce)) &&
           plan().max_bounces.value_or(1) > 0;
  }
  bool has_lobes() const {
    return settings_.mode == Mode::antiradiance &&
           (plan().simulated.contains(Effect::glossy_chain) || plan().simulated.contains(Effect::glossy_final_bounce));
  }

  Visibility visibility() const {
    // Where nothing hides anything no directions are kept and no ray is traced for it, unless lobes need the directions.
    const bool hides = plan().simulated.contains(Effect::occlusion) && arrangement_of(world()) == Arrangement::general;
    switch (settings_.mode) {
      case Mode::radiosity: return hides ? Visibility::traced : Visibility::none_needed;
      case Mode::implicit: return hides ? Visibility::nearest : Visibility::none_needed;
      case Mode::disc_bounce: return Visibility::shadow_passes;
      default: return hides || has_lobes() ? Visibility::antiradiance : Visibility::none_needed;
    }
  }

  /// Makes the links and what their form factors are held to.
  void link(std::span<const float> radiosity, Task& task, StageReport& report) {
    linking_ = make_linking(world(), *parts_, settings_, visibility(), radiosity, task);
    report.message = linking_.warning;
    if (linking_.refused) {
      report.termination = Termination::out_of_budget;
      return;
    }
    task.count("links", linking_.links.size());
    task.count("link_bytes", linking_.links.bytes());
    if (linking_.bins) task.count("bins", linking_.bins->count());
    task.progress("form factors", 0.6);
    if (task.cancelled()) return;
    closure_ = closure_factors(*parts_, linking_, settings_, task);
  }

  Surfaces surfaces_of_leaves() {
    Surfaces surfaces;
    std::vector<std::uint32_t> materials;
    for (const std::uint32_t element : parts_->hierarchy.order()) {
      materials.push_back(world().scene().objects[parts_->elements.sheet(element) / 2].material);
      surfaces.albedo.push_back(world().scene().materials[materials.back()].diffuse);
    }
    surfaces.max_bounces = plan().max_bounces;
    if (has_lobes() && linking_.bins) {
      glossy_.emplace(world().scene(), materials, *linking_.bins);
      surfaces.glossy = &*glossy_;
    }
    return surfaces;
  }

  /// Of every node, W/m²: what is reflected first, and as much again everywhere as is reflected in the mean.
  std::vector<float> foreseen_radiosity(std::span<const Rgb> direct, std::span<const Rgb> albedo) const {
    std::vector<float> leaves;
    double sum = 0.0;
    for (std::size_t i = 0; i < direct.size(); ++i) {
      leaves.push_back(luminance(direct[i] * albedo[i]));
      sum += static_cast<double>(leaves.back());
    }
    for (float& value : leaves) value += static_cast<float>(sum / static_cast<double>(leaves.size()));
    return pull(parts_->hierarchy, leaves);
  }

  /// See reconstruction.h.
  Rgb indirect(const SurfaceSample& sample, const Vec3* toward_viewer, std::uint64_t seed, RayStream& rays) const {
    if (indirect_.empty() || !sample.lit_side) return {};
    const Reconstruction::Place at = Reconstruction::place(world(), parts_->mesh, parts_->elements, sample);
    if (at.in_doubt && !is_exposed(world(), world().ray_origin(sample), sample.normal, settings_.backface_rays,
                                   RandomStream(seed, asked_stage, sample.triangle), rays))
      return {};
    const Material& material = world().scene().material_of_object(sample.object);
    Rgb sum;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(at.weights[k] > 0.0F)) continue;
      Rgb value = indirect_[at.elements[k]];
      if (toward_viewer != nullptr) value = value * material.diffuse / pi + lobe_radiance(at.elements[k], sample, *toward_viewer);
      sum += value * at.weights[k];
    }
    return settings_.clamp ? Rgb(std::max(0.0F, sum.r), std::max(0.0F, sum.g), std::max(0.0F, sum.b)) : sum;
  }

  Rgb lobe_radiance(std::uint32_t element, const SurfaceSample& sample, const Vec3& toward_viewer) const {
    if (!glossy_ || by_direction_.size() == 0) return {};
    const std::size_t leaf = parts_->hierarchy.leaf_of_element(element), count = linking_.bins->count();
    if (!glossy_->is_glossy(leaf)) return {};
    std::vector<float> projected(count);
    projected_bins(*linking_.bins, sample.normal, projected);
    return glossy_->radiance(world().scene().objects[sample.object].material, sample.normal, toward_viewer, projected,
                             by_direction_.data() + leaf * count * 4) *
           closure_[leaf];
  }

  Settings settings_;
  const World* world_ = nullptr;
  EffectPlan plan_;
  const DirectLight* direct_light_ = nullptr;  ///< of the last light()
  std::unique_ptr<Discretisation> parts_;
  Linking linking_;
  std::vector<float> closure_;
  std::vector<Rgb> indirect_;  ///< irradiance at every vertex, W/m²
  Vector by_direction_;
  std::optional<GlossyReflection> glossy_;
  std::optional<Accessibility> accessibility_;
  std::optional<SkyAsAmbient> sky_;
};

}  // namespace

MethodEntry antiradiance_entry() {
  return {"antiradiance",
          "disc elements: accessibility, one disc bounce, and hierarchical radiosity with traced, implicit or no visibility",
          "course notes on finite elements at interactive rates, after Bunnell 2005, Dong et al. 2007, Dachsbacher et al. 2007, "
          "Meyer et "
          "al. 2009",
          "C(<R[DG]>)*[LOB]",
          settings_schema(),
          [](const Parameters& parameters) -> std::unique_ptr<TransportMethod> {
            return std::make_unique<Antiradiance>(settings_from(parameters));
          },
          {{"elements", "800"}, {"bins", "8"}, {"tolerance", "0.03"}, {"residual", "1e-5"}, {"far_enough", "0.05"}},
          "mode"};
}

}  // namespace gibench
