#include "methods/meshless/meshless.h"

#include <optional>

#include "common/core/error.h"
#include "common/effects/scene_facts.h"
#include "common/geometry/has_area.h"
#include "methods/meshless/coarsest_shares.h"
#include "methods/meshless/crossings.h"
#include "methods/meshless/cuts.h"
#include "methods/meshless/placement.h"
#include "methods/meshless/settings.h"
#include "methods/meshless/solver.h"

namespace gibench {

namespace {

using namespace meshless;

constexpr std::size_t shade_chunk = 256;  // samples

/// Samples at which the answer is not simply that of the basis.
struct Exceptions {
  std::uint64_t clamped = 0;    ///< light below zero, answered as zero
  std::uint64_t inside = 0;     ///< taken for points inside geometry: answered as zero
  std::uint64_t uncovered = 0;  ///< no basis function reaches there: answered as zero
};

void count(const std::vector<Exceptions>& chunks, Task& task) {
  Exceptions all;
  for (const Exceptions& chunk : chunks)
    all.clamped += chunk.clamped, all.inside += chunk.inside, all.uncovered += chunk.uncovered;
  task.count("clamped_samples", all.clamped);
  task.count("inside_samples", all.inside);
  task.count("uncovered_samples", all.uncovered);
}

class Meshless : public TransportMethod {
 public:
  explicit Meshless(const Settings& settings) : settings_(settings) {}

  Capabilities capabilities() const noexcept override {
    Capabilities can;
    can.effects = {Effect::direct, Effect::diffuse_indirect, Effect::environment, Effect::occlusion};
    can.quantities = {Quantity::irradiance, Quantity::radiance};
    can.direct = settings_.direct == DirectAnswer::basis;
    can.relights = true;
    return can;
  }

  std::optional<std::string> refusal(const Scene& scene) const override {
    if (scene.triangles.empty()) return "the scene has no surfaces to put basis points on";
    if (has_area(scene)) return std::nullopt;
    return "every face of the scene has zero area: there is nowhere to put basis points";
  }

  std::size_t bytes() const override { return transport_.groups.bytes() + transport_.hierarchy.bytes() + solution_.bytes(); }

  void prepare(const World& world, const EffectPlan& plan, Task& task, StageReport& report) override {
    world_ = &world;
    plan_ = plan;
    solution_ = {};
    transport_ = {};
    if (!needs_points()) {
      report.message = "no diffuse interreflection is called for: no points placed";
      return;
    }
    const Settings settings = planned_settings();
    transport_.groups = make_groups(world, settings, task);
    Placement placement = place_points(world, transport_.groups, settings, task);
    if (!placement.refusal.empty()) {
      report.termination = Termination::out_of_budget;
      report.message = placement.refusal;
      return;
    }
    task.count("proposals", placement.proposals);
    task.count("proposals_inside", placement.inside);
    transport_.hierarchy = Hierarchy(std::move(placement), transport_.groups.count, settings, task);
    if (!is_one_convex_room()) cut_at_walls(world, transport_.hierarchy, settings.cut_levels, task);
    transport_.hierarchy.set_coarsest_shares(coarsest_shares(world, transport_.groups, transport_.hierarchy, task));
    task.count("samples", transport_.hierarchy.size());
    task.count("levels", transport_.hierarchy.levels());
    if (transport_.hierarchy.levels() > 0) task.count("coarsest_samples", transport_.hierarchy.level_size(0));
    task.count("groups", transport_.groups.count);
  }

  void light(const PlannedLights& lights, Task& task, StageReport& report) override {
    direct_light_ = &lights.direct;
    solution_ = {};
    if (!needs_points() || (direct_light_->dark() && settings_.direct == DirectAnswer::shared)) {
      report.message = needs_points() ? "no light: nothing to transport" : "nothing to transport";
      return;
    }
    const bool grey = plan_.grey_surfaces && is_grey(lights.lighting);
    solution_ =
        solve(*world_, transport_, *direct_light_, settings_, {plan_.max_bounces, simulates_indirect(), grey ? 1 : 3}, task);
    task.count("channels", grey ? 1 : 3);
    report.termination = solution_.termination;
    report.message = solution_.message;
  }

  void shade(const ShadeRequest& request, const ShadeAnswer& answer, Task& task, StageReport&) const override {
    const bool solved = solution_.indirect || solution_.direct;
    const std::vector<std::uint8_t> clear = clear_samples(request.samples, task);
    std::vector<Exceptions> exceptions(chunk_count(request.samples.size(), shade_chunk));
    task.parallel_chunks(request.samples.size(), shade_chunk, [&](const ChunkRange& range) {
      Exceptions& met = exceptions[range.chunk];
      for (std::size_t i = range.begin; i < range.end; ++i) {
        const SurfaceSample& sample = request.samples[i];
        bool below_zero = false;
        const Rgb direct = clear[i] != 0 ? irradiance(solution_.direct, sample, below_zero) : Rgb();
        const Rgb indirect = clear[i] != 0 ? irradiance(solution_.indirect, sample, below_zero) : Rgb();
        met.clamped += below_zero ? 1U : 0U;
        if (solved && sample.lit_side && clear[i] == 0) ++met.inside;
        if (solved && clear[i] != 0 && is_black(direct) && is_black(indirect) && !transport_.hierarchy.covered(place_of(sample)))
          ++met.uncovered;
        const bool leaving = request.quantity == Quantity::radiance;
        const Rgb factor = leaving ? world_->scene().material_of_object(sample.object).diffuse / pi : Rgb(1.0F);
        if (!answer.direct.empty()) answer.direct[i] = direct * factor + (leaving ? direct_light_->emission(sample) : Rgb());
        if (!answer.indirect.empty()) answer.indirect[i] = indirect * factor;
      }
    });
    count(exceptions, task);
    if (solved && plan_.simulates(Effect::occlusion)) count_crossings(request.samples, task);
  }

 private:
  bool simulates_indirect() const {
    return plan_.simulated.contains(Effect::diffuse_indirect) && plan_.max_bounces.value_or(1) > 0;
  }
  bool needs_points() const { return simulates_indirect() || settings_.direct == DirectAnswer::basis; }

  /// In one convex room light reaches everything.
  Groups make_groups(const World& world, const Settings& settings, Task& task) const {
    if (is_one_convex_room() || settings.grouping == Grouping::objects) return meshless::make_groups(world, settings.grouping);
    const SideLight light(world, task);
    return meshless::make_groups(world, settings.grouping, &light);
  }
  bool is_one_convex_room() const {
    return plan_.limits && plan_.arrangement != Arrangement::general && !plan_.simulates(Effect::occlusion);
  }

  /// In one convex room no point lies inside geometry: nothing is behind another's front.
  Settings planned_settings() const {
    Settings settings = settings_;
    if (is_one_convex_room()) settings.backface_test = false;
    return settings;
  }

  /// 0 for samples on an unlit side or inside geometry, which no basis point stands for.
  std::vector<std::uint8_t> clear_samples(std::span<const SurfaceSample> samples, Task& task) const {
    std::vector<std::uint8_t> clear(samples.size(), 1);
    if (!solution_.indirect && !solution_.direct) return clear;
    if (planned_settings().backface_test) {
      std::vector<DiscPoint> points;
      points.reserve(samples.size());
      for (const SurfaceSample& sample : samples) points.push_back({sample.position, sample.normal, {sample.triangle, true}});
      clear_of_backfaces(*world_, points, clear, settings_.backface_rays, task);
    }
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (!samples[i].lit_side) clear[i] = 0;
    return clear;
  }

  Place place_of(const SurfaceSample& sample) const { return {sample.position, sample.normal, transport_.groups.of(sample)}; }

  void count_crossings(std::span<const SurfaceSample> samples, Task& task) const {
    const Expansion& expansion = solution_.indirect ? *solution_.indirect : *solution_.direct;
    const Crossings met = find_crossings(*world_, transport_.groups, expansion, samples, task);
    task.count("tried_samples", met.tried);
    task.count("crossed_samples", met.crossed);
  }

  /// The expansion at the sample; differences of levels may ring below zero, which no irradiance does.
  Rgb irradiance(const std::optional<Expansion>& expansion, const SurfaceSample& sample, bool& below_zero) const {
    if (!expansion) return {};
    const Rgb value = expansion->evaluate(place_of(sample));
    below_zero = below_zero || smallest(value) < 0.0F;
    return {std::max(0.0F, value.r), std::max(0.0F, value.g), std::max(0.0F, value.b)};
  }

  Settings settings_;
  const World* world_ = nullptr;
  EffectPlan plan_;
  const DirectLight* direct_light_ = nullptr;  ///< of the last light()
  Transport transport_;
  Solution solution_;
};

}  // namespace

MethodEntry meshless_entry() {
  return {"meshless",
          "hierarchical radiosity on scattered points: Shepard multilevel basis, adaptive gathers, Neumann bounces",
          "Lehtinen, Zwicker, Kontkanen, Turquin, Sillion, Aila: Meshless Finite Elements for Hierarchical Global "
          "Illumination, TML-B7, Helsinki University of Technology 2007",
          "C.{0,1}[LOB]|CDD+[LOB]",
          settings_schema(),
          [](const Parameters& parameters) -> std::unique_ptr<TransportMethod> {
            return std::make_unique<Meshless>(settings_from(parameters));
          },
          {{"levels", "3"}, {"coarsest_samples", "100"}, {"rays", "64"}, {"coarsest_rays", "128"}},
          {},
          presets()};
}

}  // namespace gibench
