#include "methods/wavelet/wavelet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "common/core/overloaded.h"
#include "common/effects/arrangement.h"
#include "common/geometry/has_area.h"
#include "methods/wavelet/bounces.h"
#include "methods/wavelet/direct_projection.h"
#include "methods/wavelet/global_operator.h"
#include "methods/wavelet/precomputation.h"
#include "methods/wavelet/settings.h"

namespace gibench {

namespace {

using namespace wavelet;

constexpr std::size_t shade_chunk = 256;  // samples
constexpr double much_lost = 0.01;        // share of the indirect light from which on the report's message says so

std::size_t sides_of(const Scene& scene) {
  std::size_t sides = 0;
  for (const Object& object : scene.objects)
    sides += (object.face_end - object.face_begin) * (object.two_sided ? std::size_t{2} : std::size_t{1});
  return sides;
}

/// Of every material whether it emits.
std::vector<std::uint8_t> emitters_of(const Scene& scene) {
  std::vector<std::uint8_t> emitters;
  for (const Material& material : scene.materials) emitters.push_back(is_black(material.emission) ? 0 : 1);
  return emitters;
}

/// Samples whose answer is not simply the interpolated one.
struct Exceptions {
  std::uint64_t clamped = 0;    ///< light below zero, answered as zero
  std::uint64_t uncovered = 0;  ///< no element lies there: answered as zero
};

class Wavelet : public TransportMethod {
 public:
  explicit Wavelet(const Settings& settings) : settings_(settings) {}

  Capabilities capabilities() const noexcept override {
    Capabilities can;
    can.effects = {Effect::direct, Effect::diffuse_indirect, Effect::environment, Effect::occlusion};
    can.quantities = {Quantity::irradiance, Quantity::radiance};
    can.direct = false;
    can.relights = true;
    return can;
  }

  std::optional<std::string> refusal(const Scene& scene) const override {
    if (!has_area(scene)) return "no face of the scene has any area: there is nowhere to put elements";
    if (const std::size_t sides = sides_of(scene); sides > most_sides)
      return fmt::format("the scene's faces have {} sides that reflect, and every pair of them is looked at: {} at most", sides,
                         most_sides);
    return std::nullopt;
  }

  std::size_t bytes() const override { return made_.bytes() + global_.bytes() + indirect_.capacity() * sizeof(Rgb); }

  void prepare(const World& world, const EffectPlan& plan, Task& task, StageReport& report) override {
    world_ = &world;
    plan_ = plan;
    made_ = {};
    global_ = {};
    emitters_ = emitters_of(world.scene());
    indirect_.clear();
    if (!simulates_indirect()) {
      report.message = "no diffuse interreflection is called for: no elements made";
      return;
    }
    const bool hides = plan.simulated.contains(Effect::occlusion) && arrangement_of(world) == Arrangement::general;
    made_ = precompute(world, settings_, hides, task, report);
    if (settings_.mode != Mode::solve && succeeded(report.termination) && !task.cancelled()) make_global(task, report);
  }

  void light(const PlannedLights& lights, Task& task, StageReport& report) override {
    indirect_.clear();
    if (!simulates_indirect() || lights.direct.dark()) {
      report.message = simulates_indirect() ? "no light: nothing to transport" : "nothing to transport";
      return;
    }
    const Coefficients<Rgb> direct = project_direct_light(*world_, made_.elements, lights.direct, settings_.direct_samples, task);
    task.progress("direct light", 0.5);
    if (task.cancelled()) return;
    const IndirectLight solved =
        settings_.mode == Mode::solve
            ? bounce(made_.elements, made_.transport, direct, reflectance(), bound(), task)
            : all_bounces(made_.elements, made_.transport, global_, gathers(), direct, reflectance(), task);
    report.termination = solved.termination;
    if (settings_.mode != Mode::solve) end_of_series(report);
    add_sentence(solved.message, report);
    task.count("bounces", static_cast<std::uint64_t>(solved.bounces));
    task.progress("bounces", 1.0, solved.residual);
    indirect_ = made_.reconstruction.corner_values(leaf_means_of<Rgb>(made_.elements, solved.irradiance));
  }

  /// Albedos stand in the global operator alone. Of faces in one place that which emits shows: its material decides where
  /// elements are.
  void edit(const SceneEdit& edit, const World& after, const EffectPlan& plan, const PlannedLights& lights, Task& task,
            StageReport& report) override {
    const bool in_place = same_work(plan) &&
                          std::visit(Overloaded{[](const LightEdit&) { return true; },
                                                [&](const MaterialEdit&) {
                                                  return settings_.mode == Mode::solve && emitters_of(after.scene()) == emitters_;
                                                },
                                                [](const MoveEdit&) { return false; }, [](const DeformEdit&) { return false; }},
                                     edit);
    world_ = &after;
    plan_ = plan;
    if (in_place) light(lights, task, report);
    else TransportMethod::edit(edit, after, plan, lights, task, report);
  }

  void shade(const ShadeRequest& request, const ShadeAnswer& answer, Task& task, StageReport&) const override {
    if (answer.indirect.empty()) return;
    std::vector<Exceptions> exceptions(chunk_count(request.samples.size(), shade_chunk));
    task.parallel_chunks(request.samples.size(), shade_chunk, [&](const ChunkRange& range) {
      for (std::size_t i = range.begin; i < range.end; ++i) {
        const SurfaceSample& sample = request.samples[i];
        answer.indirect[i] = irradiance_at(sample, exceptions[range.chunk]);
        if (request.quantity == Quantity::radiance)
          answer.indirect[i] *= world_->scene().material_of_object(sample.object).diffuse / pi;
      }
    });
    for (const Exceptions& met : exceptions) {
      task.count("clamped_samples", met.clamped);
      task.count("uncovered_samples", met.uncovered);
    }
  }

 private:
  bool simulates_indirect() const {
    return plan_.simulated.contains(Effect::diffuse_indirect) && plan_.max_bounces.value_or(1) > 0;
  }
  bool gathers() const { return settings_.mode == Mode::gathered; }
  BounceBound bound() const { return {plan_.max_bounces, settings_.bounces, settings_.residual}; }

  /// Albedos of the elements.
  std::vector<Rgb> reflectance() const {
    std::vector<Rgb> albedos;
    for (const Element& element : made_.elements.elements())
      albedos.push_back(world_->scene().material_of_object(element.object).diffuse);
    return albedos;
  }

  void make_global(Task& task, StageReport& report) {
    const int last = plan_.max_bounces.value_or(settings_.powers + 1) - (gathers() ? 1 : 0);
    if (last > 0)
      global_ = GlobalOperator(
          made_.elements, made_.transport, reflectance(),
          {settings_.series_threshold, std::min(last, settings_.powers), static_cast<std::size_t>(settings_.memory_budget * 1e6)},
          task);
    if (task.cancelled()) return;
    if (global_.refused()) {
      report.termination = Termination::out_of_budget;
      add_sentence(
          fmt::format("the global operator would pass memory_budget={:g} MB: raise it or series_threshold, or set mode=solve",
                      settings_.memory_budget),
          report);
      return;
    }
    task.count("global_links", global_.links());
    task.count("global_coefficients", global_.coefficients());
    for (std::size_t p = 0; p < global_.powers().size(); ++p)
      task.count(fmt::format("power_{}_coefficients", p + 1), global_.powers()[p].coefficients);
    const double lost = lost_to_compression(made_.elements, made_.transport, global_, gathers(), reflectance(), bound(), task);
    task.count("energy_lost_ppm", static_cast<std::uint64_t>(std::lround(1e6 * std::max(0.0, lost))));
    if (lost > much_lost)
      add_sentence(fmt::format("compression takes {:.1f}% of the indirect light under even direct light: mode=solve takes none, "
                               "a smaller series_threshold less",
                               100.0 * lost),
                   report);
  }

  /// The powers end by themselves, with the plan, or short of both at the most that are made.
  void end_of_series(StageReport& report) const {
    const std::span powers = global_.powers();
    const bool plan_bounds = plan_.max_bounces && *plan_.max_bounces - (gathers() ? 1 : 0) <= settings_.powers;
    if (plan_bounds || powers.size() < static_cast<std::size_t>(settings_.powers)) return;
    const double before = powers.size() > 1 ? powers[powers.size() - 2].squares : 0.0;
    const double ratio = before > 0.0 ? std::sqrt(powers.back().squares / before) : 0.0;
    report.termination = ratio > fading_ratio ? Termination::not_converged : Termination::bound_reached;
    add_sentence(
        ratio > fading_ratio
            ? fmt::format("the powers do not fade (ratio {:.6f}): the scene absorbs no light; powers={} ends them", ratio,
                          settings_.powers)
            : fmt::format("{} powers made, the last {:.6f} of the one before; raise the parameter powers", powers.size(), ratio),
        report);
  }

  static void add_sentence(const std::string& text, StageReport& report) {
    if (text.empty()) return;
    report.message += (report.message.empty() ? "" : "; ") + text;
  }

  /// Whether what prepare() made serves another plan as well.
  bool same_work(const EffectPlan& plan) const {
    return simulates_indirect() && plan.simulated.contains(Effect::diffuse_indirect) && plan.max_bounces.value_or(1) > 0 &&
           plan.simulated.contains(Effect::occlusion) == plan_.simulated.contains(Effect::occlusion);
  }

  Rgb irradiance_at(const SurfaceSample& sample, Exceptions& met) const {
    if (indirect_.empty() || !sample.lit_side) return {};
    const std::uint32_t leaf = made_.elements.leaf_at(*world_, sample);
    if (leaf == none) {
      ++met.uncovered;
      return {};
    }
    const Rgb value = made_.reconstruction.at(made_.elements, indirect_, leaf, sample.position);
    if (smallest(value) >= 0.0F) return value;
    ++met.clamped;
    return {std::max(0.0F, value.r), std::max(0.0F, value.g), std::max(0.0F, value.b)};
  }

  Settings settings_;
  const World* world_ = nullptr;
  EffectPlan plan_;
  Precomputed made_;
  GlobalOperator global_;               ///< not of mode=solve
  std::vector<std::uint8_t> emitters_;  ///< of every material, as prepared
  std::vector<Rgb> indirect_;           ///< irradiance at the corners of leaves, W/m²; empty: none
};

}  // namespace

MethodEntry wavelet_entry() {
  return {"wavelet",
          "relighting: transport between Haar wavelets on the surfaces, refined where the kernel calls for it",
          "Kontkanen, Turquin, Holzschuch, Sillion: Wavelet Radiance Transport for Interactive Indirect Lighting, Eurographics "
          "Symposium on Rendering 2006",
          "C(<R[DGS]>|<RD>*)[LOB]",
          settings_schema(),
          [](const Parameters& parameters) -> std::unique_ptr<TransportMethod> {
            return std::make_unique<Wavelet>(settings_from(parameters));
          },
          {{"leaves", "1200"},
           {"sender_threshold", "0.003"},
           {"receiver_threshold", "0.003"},
           {"compression", "1e-4"},
           {"series_threshold", "1e-3"},
           {"direct_samples", "8"}},
          "mode",
          presets()};
}

}  // namespace gibench
