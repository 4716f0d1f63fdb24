#include "methods/antiradiance/linked_strategy.h"

#include <algorithm>

#include "common/core/random.h"
#include "common/effects/arrangement.h"
#include "methods/antiradiance/pull.h"
#include "methods/antiradiance/report_message.h"
#include "methods/antiradiance/sources.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t shade_chunk = 64;  // samples
constexpr std::uint64_t asked_stage = 0x61736b6564ULL;

bool simulates_indirect(const EffectPlan& plan) {
  const EffectSet& simulated = plan.simulated;
  return (simulated.contains(Effect::diffuse_indirect) || simulated.contains(Effect::glossy_chain) ||
          simulated.contains(Effect::glossy_final_bounce)) &&
         plan.max_bounces.value_or(1) > 0;
}

}  // namespace

Capabilities LinkedStrategy::capabilities() const {
  Capabilities can;
  can.effects = {Effect::direct, Effect::environment, Effect::occlusion, Effect::diffuse_indirect};
  can.quantities = {Quantity::irradiance, Quantity::radiance};
  can.relights = true;
  can.direct = false;
  return can;
}

void LinkedStrategy::prepare(const World& world, const EffectPlan& plan, Task& task, StageReport& report) {
  parts_.reset();
  linking_ = {};
  closure_.clear();
  indirect_.clear();
  clear_all();
  if (!simulates_indirect(plan)) {
    report.message = "no interreflection is called for: no elements made";
    return;
  }
  const bool by_direction = visibility_on(world, plan) == Visibility::antiradiance;
  parts_ = make_elements(world, settings(), by_direction ? direction_table_bytes(settings()) : 0.0, task, report);
  if (parts_ && !task.cancelled() && settings().oracle == OracleKind::geometry) link(world, plan, {}, task, report);
}

Visibility LinkedStrategy::visibility_on(const World& world, const EffectPlan& plan) const {
  return visibility(plan, plan.simulated.contains(Effect::occlusion) && arrangement_of(world) == Arrangement::general);
}

/// Makes the links and what their form factors are held to.
void LinkedStrategy::link(const World& world, const EffectPlan& plan, std::span<const float> radiosity, Task& task,
                          StageReport& report) {
  linking_ = make_linking(world, *parts_, settings(), visibility_on(world, plan), radiosity, task);
  add_message(linking_.warning, report);
  if (linking_.refused) {
    report.termination = Termination::out_of_budget;
    return;
  }
  task.count("links", linking_.links.size());
  task.count("link_bytes", linking_.links.bytes());
  if (linking_.bins) task.count("bins", linking_.bins->count());
  task.progress("form factors", 0.6);
  if (task.cancelled()) return;
  Closure closure = closure_factors(*parts_, linking_, settings(), task);
  if (closure.iterations > 0) task.count("closure_iterations", static_cast<std::uint64_t>(closure.iterations));
  report.termination = closure.termination;
  add_message(closure.message, report);
  closure_ = std::move(closure.factors);
}

void LinkedStrategy::light(const World& world, const EffectPlan& plan, const PlannedLights& lights, Task& task,
                           StageReport& report) {
  indirect_.clear();
  clear_light();
  if (!parts_ || lights.direct.dark()) {
    report.message = parts_ ? "no light: nothing to transport" : "nothing to transport";
    return;
  }
  const std::vector<Rgb> direct =
      direct_irradiance(world, lights.direct, parts_->elements, parts_->hierarchy, settings().direct_samples, task);
  task.progress("direct light", 0.1);
  if (task.cancelled()) return;
  Surfaces surfaces;
  std::vector<std::uint32_t> materials;
  for (const std::uint32_t element : parts_->hierarchy.order()) {
    materials.push_back(world.scene().objects[parts_->elements.sheet(element) / 2].material);
    surfaces.albedo.push_back(world.scene().materials[materials.back()].diffuse);
  }
  surfaces.max_bounces = plan.max_bounces;
  if (settings().oracle == OracleKind::radiosity) {
    link(world, plan, foreseen_radiosity(direct, surfaces.albedo), task, report);
    if (!succeeded(report.termination) || task.cancelled()) return;
  }
  surfaces.closure = closure_;
  const Interreflection solved = solve(world, plan, lights, materials, surfaces, direct, task);
  report.termination = solved.termination;
  add_message(solved.message, report);
  task.count("iterations", static_cast<std::uint64_t>(solved.iterations));
  std::vector<Rgb> means(parts_->elements.size());
  for (std::size_t leaf = 0; leaf < solved.irradiance.size(); ++leaf)
    means[parts_->hierarchy.order()[leaf]] = solved.irradiance[leaf];
  indirect_ = parts_->reconstruction.vertex_values(means);
}

Interreflection LinkedStrategy::solve(const World&, const EffectPlan&, const PlannedLights&,
                                      std::span<const std::uint32_t> /*materials*/, Surfaces& surfaces,
                                      std::span<const Rgb> direct, Task& task) {
  return interreflect(*parts_, linking_, settings(), surfaces, direct, task);
}

/// Of every node, W/m²: what is reflected first, and as much again everywhere as is reflected in the mean.
std::vector<float> LinkedStrategy::foreseen_radiosity(std::span<const Rgb> direct, std::span<const Rgb> albedo) const {
  std::vector<float> leaves;
  double sum = 0.0;
  for (std::size_t i = 0; i < direct.size(); ++i) {
    leaves.push_back(luminance(direct[i] * albedo[i]));
    sum += static_cast<double>(leaves.back());
  }
  for (float& value : leaves) value += static_cast<float>(sum / static_cast<double>(leaves.size()));
  return pull<float>(parts_->hierarchy, leaves);
}

void LinkedStrategy::shade(const World& world, const ShadeRequest& request, const ShadeAnswer& answer, Task& task) const {
  if (answer.indirect.empty()) return;
  std::vector<Exceptions> chunks(chunk_count(request.samples.size(), shade_chunk));
  task.parallel_chunks(request.samples.size(), shade_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const Vec3* viewer = request.quantity == Quantity::radiance ? &request.toward_viewer[i] : nullptr;
      answer.indirect[i] = indirect(world, request.samples[i], viewer, task.seed(), rays, chunks[range.chunk]);
    }
  });
  for (const Exceptions& chunk : chunks) {
    task.count("answers_clamped", chunk.clamped);
    task.count("answers_uncovered", chunk.uncovered);
    task.count("answers_inside_geometry", chunk.inside);
    task.count("answers_cut_off", chunk.cut_off);
  }
}

/// See reconstruction.h.
Rgb LinkedStrategy::indirect(const World& world, const SurfaceSample& sample, const Vec3* toward_viewer, std::uint64_t seed,
                             RayStream& rays, Exceptions& exceptions) const {
  if (indirect_.empty() || !sample.lit_side) return {};
  Reconstruction::Place at = Reconstruction::place(world, parts_->mesh, parts_->elements, sample);
  if (!at.covered()) {
    ++exceptions.uncovered;
    return {};
  }
  if (at.in_doubt && !is_exposed(world, world.ray_origin(sample), sample.normal, settings().backface_rays,
                                 RandomStream(seed, asked_stage, sample.triangle), rays)) {
    ++exceptions.inside;
    return {};
  }
  if (parts_->is_parted(at.triangle) &&
      !Reconstruction::leave_hidden_out(world, parts_->mesh, parts_->elements, sample, rays, at))
    ++exceptions.cut_off;
  const Material& material = world.scene().material_of_object(sample.object);
  Rgb sum;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(at.weights[k] > 0.0F)) continue;
    Rgb value = indirect_[at.vertices[k]];
    if (toward_viewer != nullptr)
      value = value * material.diffuse / pi +
              lobe_radiance(world, parts_->elements.of_vertex(at.vertices[k]), sample, *toward_viewer);
    sum += value * at.weights[k];
  }
  if (!settings().clamp || std::min({sum.r, sum.g, sum.b}) >= 0.0F) return sum;
  ++exceptions.clamped;
  return {std::max(0.0F, sum.r), std::max(0.0F, sum.g), std::max(0.0F, sum.b)};
}

std::size_t LinkedStrategy::bytes() const {
  return (parts_ ? parts_->bytes() : 0) + linking_.bytes() + closure_.capacity() * sizeof(float) +
         indirect_.capacity() * sizeof(Rgb);
}

}  // namespace gibench::antiradiance
