#include "methods/spectral/spectral.h"

#include <algorithm>

#include "common/core/overloaded.h"
#include "common/geometry/has_area.h"
#include "methods/spectral/lobe_store.h"
#include "methods/spectral/relighting.h"
#include "methods/spectral/transfer_making.h"
#include "methods/spectral/vertex_light.h"

namespace gibench {

namespace {

using namespace spectral;

constexpr std::size_t shade_chunk = 256;  // samples

/// Samples at which the answer is not simply the basis between three vertices.
struct Exceptions {
  std::uint64_t clamped = 0;    ///< light below zero, answered as zero
  std::uint64_t uncovered = 0;  ///< no mesh triangle lies there: answered as zero
  std::uint64_t cut = 0;        ///< another surface cuts the mesh triangle: some corners were left out
};

void count(const std::vector<Exceptions>& chunks, Task& task) {
  Exceptions all;
  for (const Exceptions& chunk : chunks) all.clamped += chunk.clamped, all.uncovered += chunk.uncovered, all.cut += chunk.cut;
  task.count("clamped_samples", all.clamped);
  task.count("uncovered_samples", all.uncovered);
  task.count("cut_samples", all.cut);
}

class Spectral : public TransportMethod {
 public:
  explicit Spectral(const Settings& settings) : settings_(settings) {}

  Capabilities capabilities() const noexcept override {
    Capabilities can;
    can.effects = {Effect::direct, Effect::diffuse_indirect, Effect::glossy_final_bounce, Effect::environment, Effect::occlusion};
    can.quantities = {Quantity::irradiance, Quantity::radiance};
    can.direct = settings_.direct == DirectAnswer::basis;
    can.relights = true;
    return can;
  }

  std::optional<std::string> refusal(const Scene& scene) const override {
    if (scene.triangles.empty()) return "the scene has no surfaces to put a sampling mesh on";
    if (has_area(scene)) return std::nullopt;
    return "every face of the scene has zero area: there is no surface to put a sampling mesh on";
  }

  std::size_t bytes() const override {
    return transfer_.bytes() + relit_.irradiance.size() * sizeof(Rgb4) + relit_.harmonics.size() * sizeof(RgbHarmonics) +
           direct_.size() * sizeof(Rgb4);
  }

  void prepare(const World& world, const EffectPlan& plan, Task& task, StageReport& report) override {
    world_ = &world;
    plan_ = plan;
    transfer_ = {};
    relit_ = {};
    direct_.clear();
    find_lobes();
    if (!needs_mesh()) {
      report.message = "no diffuse interreflection is called for: no mesh made";
      return;
    }
    TransferWish wish;
    if (simulates_glossy())
      for (const Object& object : world.scene().objects)
        wish.glossy_objects.push_back(has_lobe(world.scene().materials[object.material]));
    if (std::find(wish.glossy_objects.begin(), wish.glossy_objects.end(), true) == wish.glossy_objects.end())
      wish.glossy_objects.clear();
    for (std::uint32_t object = 0; object < world.scene().objects.size(); ++object)
      wish.reflectance.push_back(reflectance_of(object));
    wish.most_bounces = plan.max_bounces.value_or(0);
    wish.occlusion = plan.simulated.contains(Effect::occlusion);
    glossy_objects_ = wish.glossy_objects;
    TransferMaking made = make_transfer(world, settings_, wish, task);
    transfer_ = std::move(made.transfer);
    transfer_.nodes.keep_sites(static_cast<std::size_t>(settings_.direct_points));
    if (transfer_.mesh) transfer_.mesh->forget_sites();
    report.termination = made.termination;
    report.message = made.message;
  }

  void light(const PlannedLights& lights, Task& task, StageReport& report) override {
    direct_light_ = &lights.direct;
    relit_ = {};
    direct_.clear();
    if (!needs_mesh() || direct_light_->dark()) {
      report.message = needs_mesh() ? "no light: nothing to transport" : "nothing to transport";
      return;
    }
    direct_ = direct_irradiance(*world_, transfer_, *direct_light_, settings_, task);
    if (task.cancelled()) return;
    if (simulates_indirect()) {
      task.progress("direct light", 0.5);
      std::vector<Rgb4> reflectance;
      for (std::uint32_t slot = 0; slot < direct_.size(); ++slot)
        reflectance.push_back(reflectance_of(transfer_.node_at(slot).object));
      relit_ = relight(transfer_, direct_, reflectance, {plan_.max_bounces, settings_.bounces, settings_.residual}, task);
      report.termination = relit_.termination;
      report.message = relit_.message;
      task.count("bounces", static_cast<std::uint64_t>(relit_.bounces));
      task.progress("bounces", 1.0, relit_.residual);
    }
    if (settings_.direct == DirectAnswer::shared) direct_.clear();
    else approximate_direct(task);
  }

  /// Albedos and lobes change in place; what would need other slices or another matrix is prepared again.
  void edit(const SceneEdit& edit, const World& after, const EffectPlan& plan, const PlannedLights& lights, Task& task,
            StageReport& report) override {
    world_ = &after;
    plan_ = plan;
    const bool in_place =
        std::visit(Overloaded{[](const LightEdit&) { return true; }, [&](const MaterialEdit&) { return slices_suffice(); },
                              [](const MoveEdit&) { return false; }, [](const DeformEdit&) { return false; }},
                   edit);
    if (!in_place) {
      TransportMethod::edit(edit, after, plan, lights, task, report);
      return;
    }
    find_lobes();
    light(lights, task, report);
  }

  void shade(const ShadeRequest& request, const ShadeAnswer& answer, Task& task, StageReport&) const override {
    std::vector<Exceptions> exceptions(chunk_count(request.samples.size(), shade_chunk));
    task.parallel_chunks(request.samples.size(), shade_chunk, [&](const ChunkRange& range) {
      RayStream rays = task.rays(*world_);
      Exceptions& met = exceptions[range.chunk];
      for (std::size_t i = range.begin; i < range.end; ++i) {
        const SurfaceSample& sample = request.samples[i];
        const bool leaving = request.quantity == Quantity::radiance;
        const std::optional<MeshPoint> point = place_of(sample, rays, met);
        const Rgb factor = leaving ? reflectance_of(sample.object) : Rgb(1.0F);
        bool below_zero = false;
        if (!answer.direct.empty())
          answer.direct[i] =
              not_below_zero(between(direct_, point), below_zero) * factor + (leaving ? direct_light_->emission(sample) : Rgb());
        if (!answer.indirect.empty()) {
          answer.indirect[i] = not_below_zero(between(relit_.irradiance, point), below_zero) * factor;
          if (leaving) answer.indirect[i] += not_below_zero(glossy(sample, request.toward_viewer[i], point), below_zero);
        }
        met.clamped += below_zero ? 1U : 0U;
      }
    });
    count(exceptions, task);
  }

 private:
  bool simulates_indirect() const {
    return plan_.simulated.contains(Effect::diffuse_indirect) && plan_.max_bounces.value_or(1) > 0;
  }
  bool simulates_glossy() const { return simulates_indirect() && plan_.simulated.contains(Effect::glossy_final_bounce); }
  bool needs_mesh() const { return simulates_indirect() || settings_.direct == DirectAnswer::basis; }

  bool slices_suffice() const {
    if (settings_.mode == Mode::fixed_albedo) return false;
    if (!simulates_glossy()) return true;
    const Scene& scene = world_->scene();
    for (std::size_t object = 0; object < scene.objects.size(); ++object)
      if (has_lobe(scene.materials[scene.objects[object].material]) && (glossy_objects_.empty() || !glossy_objects_[object]))
        return false;
    return true;
  }

  void find_lobes() {
    lobes_.clear();
    if (!simulates_glossy()) return;
    for (const Material& material : world_->scene().materials) lobes_.push_back(lobe_store_.lobe_of(material));
  }

  void approximate_direct(Task& task) {
    std::vector<Rgb4> light(transfer_.basis.columns());
    transfer_.basis.project(direct_, light, task);
    transfer_.basis.reconstruct(light, direct_, task);
  }

  Rgb reflectance_of(std::uint32_t object) const { return world_->scene().material_of_object(object).diffuse / pi; }

  std::optional<MeshPoint> place_of(const SurfaceSample& sample, RayStream& rays, Exceptions& met) const {
    if (!transfer_.mesh || !sample.lit_side) return std::nullopt;
    const bool front = glm::dot(world_->normal(sample.triangle), sample.normal) >= 0.0F;
    if (!transfer_.mesh->covers(sample.triangle, front)) {
      ++met.uncovered;
      return std::nullopt;
    }
    const MeshPoint point = transfer_.mesh->locate(sample.triangle, sample.barycentrics, front);
    met.cut += transfer_.interpolation.torn(point.triangle) ? 1U : 0U;
    return transfer_.interpolation.seen(*world_, *transfer_.mesh, point, sample.position, rays);
  }

  /// Calls add(slot, weight) for the nodes around a point.
  template <class Add>
  void each_slot(const MeshPoint& point, const Add& add) const {
    for (std::size_t c = 0; c < 3; ++c)
      transfer_.weights.each(transfer_.mesh->triangles()[point.triangle].corners[c],
                             [&](std::uint32_t slot, float weight) { add(slot, point.weights[c] * weight); });
  }

  Rgb between(const std::vector<Rgb4>& values, const std::optional<MeshPoint>& point) const {
    if (values.empty() || !point) return {};
    Rgb sum;
    each_slot(*point, [&](std::uint32_t slot, float weight) { sum += Rgb(values[slot]) * weight; });
    return sum;
  }
  /// A truncated basis may ring below zero, which no irradiance does.
  static Rgb not_below_zero(const Rgb& v, bool& below_zero) {
    below_zero = below_zero || v.r < 0.0F || v.g < 0.0F || v.b < 0.0F;
    return {std::max(0.0F, v.r), std::max(0.0F, v.g), std::max(0.0F, v.b)};
  }

  /// Σ_k ρ_k(ω_o) ∫ L h_k cos (Wang et al. 2007, Eq. 6).
  Rgb glossy(const SurfaceSample& sample, const Vec3& toward_viewer, const std::optional<MeshPoint>& point) const {
    const std::uint32_t material = world_->scene().objects[sample.object].material;
    if (!point || relit_.harmonics.empty() || lobes_.empty() || !lobes_[material]) return {};
    const RgbHarmonics lobe = lobes_[material]->coefficients(sample.normal, toward_viewer);
    Rgb sum;
    each_slot(*point, [&](std::uint32_t slot, float weight) {
      const RgbHarmonics& arriving = relit_.harmonics[transfer_.glossy_row[slot]];
      for (std::size_t k = 0; k < harmonic_count; ++k) sum += lobe[k] * arriving[k] * weight;
    });
    return sum;
  }

  Settings settings_;
  const World* world_ = nullptr;
  EffectPlan plan_;
  const DirectLight* direct_light_ = nullptr;  ///< of the last light()
  Transfer transfer_;
  std::vector<bool> glossy_objects_;  ///< whose vertices have harmonic slices; empty: none
  LobeStore lobe_store_;
  std::vector<std::shared_ptr<const LobeHarmonics>> lobes_;  ///< one for each material; empty: no glossy light is planned
  std::vector<Rgb4> direct_;                                 ///< as the basis holds it, where it is asked for
  Relit relit_;
};

}  // namespace

MethodEntry spectral_entry() {
  return {"spectral",
          "relighting: direct-to-indirect transfer over a spectral mesh basis, precomputed by rays",
          "Wang, Zhu, Humphreys: Precomputed Radiance Transfer for Real-Time Indirect Lighting using a Spectral Mesh Basis, "
          "Eurographics Symposium on Rendering 2007",
          "C(<R[DGS]><RD>*){0,1}[LO]",
          settings_schema(),
          [](const Parameters& parameters) -> std::unique_ptr<TransportMethod> {
            return std::make_unique<Spectral>(settings_from(parameters));
          },
          {{"vertices", "1500"},
           {"rays", "256"},
           {"basis_functions", "256"},
           {"part_vertices", "200"},
           {"compression_error", "0.01"}},
          "mode",
          presets()};
}

}  // namespace gibench
