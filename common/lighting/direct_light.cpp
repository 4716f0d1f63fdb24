#include "common/lighting/direct_light.h"

#include <algorithm>
#include <array>
#include <optional>

#include "common/core/sobol.h"
#include "common/lighting/next_event.h"
#include "common/lighting/scene_lights.h"
#include "common/reflectance/bsdf.h"
#include "common/scene/light_kinds.h"

namespace gibench {

namespace {

// Pairs of dimensions of sample i: a direction and its lobe, then a place and a choice for each group of lights.
constexpr std::uint32_t hemisphere = 0, lobe_choice = 1, first_of_groups = 2;
constexpr std::uint32_t trial = 0x747279U;           // whether small light is tried, an independent number
constexpr std::uint32_t first_punctual = 1U << 31U;  // number of a light that is visited, beside those of samples
constexpr std::size_t batch = 64;                    // rays traced together, and points at most whose rays they are
constexpr std::size_t most_visited = 64;             // punctual lights that are each given a ray
constexpr std::size_t most_looked_through = 64;      // emitting triangles that are each tested against a ray

/// A surface point that light is gathered at, with the lobe that weighs it.
struct Receiver {
  const SurfaceBsdf& bsdf;
  const SurfaceSample& sample;
  Frame frame;
  Vec3 origin;  ///< of rays
  Vec3 out;     ///< towards the viewer, local
  SobolSequence random;
};

/// What arrives at a point, by the way it is found. Each sum is taken in the order of the samples, so that it does not depend
/// on whose rays are traced with this point's.
struct Arrived {
  Rgb by_lights, by_hemisphere, by_punctual;
};

/// Light on its way to surface points, held back until its shadow rays are traced together.
class PendingLight {
 public:
  PendingLight(const NextEvent& next_event, bool tests_visibility, float small_light, RayStream& rays)
      : next_event_(next_event), tests_visibility_(tests_visibility), small_light_(small_light), rays_(rays) {}

  /// `number`: of the light sample, at its receiver.
  void add(const Receiver& receiver, const LightSample& light, std::uint32_t number, Rgb& sum) {
    if (!(light.pdf > 0.0F)) return;
    const Vec3 in = receiver.frame.to_local(light.direction);
    const BsdfValue value = receiver.bsdf.evaluate(receiver.out, in);
    Rgb contribution = value.value * light.radiance * (in.z / light.pdf);
    if (is_black(contribution)) return;
    contribution *= next_event_.weight(light, value.pdf);
    if (const float size = largest(contribution); tests_visibility_ && size < small_light_) {
      if (receiver.random.independent_pair(number, trial).unit().x * small_light_ >= size) return;
      contribution *= small_light_ / size;
    }
    if (count_ == batch) trace();
    shadow_rays_[count_] = light.shadow_ray(receiver.origin);
    sums_[count_] = &sum;
    contributions_[count_++] = contribution;
  }
  void trace() {
    std::array<std::uint8_t, batch> occluded{};
    if (tests_visibility_ && count_ > 0) rays_.occlusions({shadow_rays_.data(), count_}, {occluded.data(), count_});
    for (std::size_t i = 0; i < count_; ++i)
      if (!occluded[i]) *sums_[i] += contributions_[i];
    count_ = 0;
  }

 private:
  const NextEvent& next_event_;
  bool tests_visibility_;
  float small_light_;
  RayStream& rays_;
  std::array<Ray, batch> shadow_rays_;
  std::array<Rgb, batch> contributions_;
  std::array<Rgb*, batch> sums_{};
  std::size_t count_ = 0;
};

/// Directions drawn from the lobes of surface points, held back until they are traced together.
class PendingDirections {
 public:
  PendingDirections(const World& world, const SceneLights& lights, const NextEvent& next_event, const DirectLightOptions& options,
                    RayStream& rays)
      : world_(world), lights_(lights), next_event_(next_event), options_(options), rays_(rays) {}

  void add(const Receiver& receiver, std::uint32_t i, Rgb& sum) {
    const BsdfSample drawn = receiver.bsdf.sample(receiver.out, receiver.random.pair(i, lobe_choice).unit().x,
                                                  receiver.random.pair(i, hemisphere).unit());
    if (is_black(drawn.weight)) return;
    if (count_ == batch) trace();
    directions_[count_] = {receiver.origin, 0.0F, receiver.frame.to_world(drawn.in)};
    drawn_[count_++] = {drawn.weight, drawn.pdf, &receiver.sample, &sum};
  }
  void trace() {
    find_lights();
    for (std::size_t i = 0; i < count_; ++i) *drawn_[i].sum += drawn_[i].weight * arriving(i);
    count_ = 0;
  }

 private:
  struct Drawn {
    Rgb weight;
    float pdf = 0.0F;  ///< 0: by a mirror
    const SurfaceSample* from = nullptr;
    Rgb* sum = nullptr;
  };

  /// What the rays meet, as far as light may come from there. Where nothing is hidden, a ray meets the emitter that it points
  /// at; among many of them it is looked up as the closest surface.
  void find_lights() {
    if (count_ == 0) return;
    if (options_.tests_visibility || (options_.surfaces_in_sight && lights_.emitter_count() > most_looked_through)) {
      rays_.closest_hits({directions_.data(), count_}, {hits_.data(), count_});
      return;
    }
    for (std::size_t i = 0; i < count_; ++i)
      hits_[i] = options_.surfaces_in_sight ? lights_.emitter_met(directions_[i].origin, directions_[i].direction) : Hit();
  }

  /// Radiance that a ray brings from a light, times its weight.
  Rgb arriving(std::size_t i) const {
    const Hit& hit = hits_[i];
    const Drawn& drawn = drawn_[i];
    const Vec3& direction = directions_[i].direction;
    if (!hit) return next_event_.environment(drawn.from->normal, direction, drawn.pdf);
    const Object& object = world_.scene().objects[world_.scene().triangle_object[hit.triangle]];
    const float cosine = -glm::dot(world_.normal(hit.triangle), direction);
    return next_event_.emission(drawn.from->position, drawn.from->normal,
                                {hit.triangle, object.material, hit.distance, cosine, object.two_sided}, drawn.pdf);
  }

  const World& world_;
  const SceneLights& lights_;
  const NextEvent& next_event_;
  const DirectLightOptions& options_;
  RayStream& rays_;
  std::array<Ray, batch> directions_;
  std::array<Hit, batch> hits_;
  std::array<Drawn, batch> drawn_;
  std::size_t count_ = 0;
};

}  // namespace

struct DirectLight::Impl {
  const World& world;
  DirectLightOptions options;
  bool visits_punctual;
  SceneLights lights;
  std::vector<SurfaceBsdf> bsdfs;  ///< one for each material
  SurfaceBsdf sensor = SurfaceBsdf::diffuse(Rgb(pi));

  Impl(const World& w, const Lighting& lighting, const DirectLightOptions& o)
      : world(w),
        options(o),
        visits_punctual(punctual_lights_of(lighting) <= most_visited),
        lights(w, lighting, visits_punctual ? PunctualLights::visited : PunctualLights::sampled) {
    for (const Material& material : w.scene().materials)
      bsdfs.push_back(options.glossy ? SurfaceBsdf(material) : SurfaceBsdf::diffuse(material.diffuse));
  }

  static std::size_t punctual_lights_of(const Lighting& lighting) {
    std::size_t count = 0;
    for (const Light& light : lighting.lights) count += kind_of(light).background ? 0U : 1U;
    return count;
  }
  const Rgb& emission(const SurfaceSample& sample) const {
    return lights.emission_of_material(world.scene().objects[sample.object].material);
  }
  const SurfaceBsdf& bsdf_of(const SurfaceSample& sample) const { return bsdfs[world.scene().objects[sample.object].material]; }

  /// Has all rays of a point traced, in company.
  void gather(const Receiver& receiver, std::uint32_t samples, float hemisphere_share, PendingLight& light,
              PendingDirections& directions, Arrived& arrived) const {
    for (std::uint32_t i = 0; i < samples; ++i) {
      if (!receiver.bsdf.is_delta())
        for (const LightGroup group : lights.groups())
          light.add(receiver, sample_light(receiver, group, i), i * most_light_groups + static_cast<std::uint32_t>(group),
                    arrived.by_lights);
      if (lights.can_be_hit() && (hemisphere_share >= 1.0F || receiver.random.pair(i, lobe_choice).unit().y < hemisphere_share))
        directions.add(receiver, i, arrived.by_hemisphere);
    }
    if (!visits_punctual || receiver.bsdf.is_delta()) return;
    for (std::size_t i = 0; i < lights.punctual_count(); ++i)
      light.add(receiver, lights.punctual(i, receiver.sample.position), first_punctual + static_cast<std::uint32_t>(i),
                arrived.by_punctual);
  }
  LightSample sample_light(const Receiver& receiver, LightGroup group, std::uint32_t i) const {
    const std::uint32_t place = first_of_groups + 2U * static_cast<std::uint32_t>(group);
    const std::uint32_t choice = lights.has_choice(group) ? receiver.random.pair(i, place + 1U).x : 0U;
    return lights.sample(group, receiver.sample.position, receiver.sample.normal, choice, receiver.random.pair(i, place).unit());
  }

  /// Light that points reflect, block by block: `receiver_at(i)` is the i-th point's, nothing where it gets no light.
  template <class ReceiverAt>
  void gather_all(std::size_t points, const ReceiverAt& receiver_at, int samples, const RaySavings& savings, RayStream& rays,
                  std::span<Rgb> out) const {
    const auto each = static_cast<std::uint32_t>(std::max(1, samples));
    const NextEvent next_event(lights, 1.0F / savings.hemisphere_share);
    PendingLight light(next_event, options.tests_visibility, savings.small_light, rays);
    PendingDirections directions(world, lights, next_event, options, rays);
    for (std::size_t begin = 0; begin < points; begin += batch) {
      const std::size_t end = std::min(points, begin + batch);
      std::array<Arrived, batch> arrived{};
      for (std::size_t i = begin; i < end; ++i)
        if (const std::optional<Receiver> receiver = receiver_at(i))
          gather(*receiver, each, savings.hemisphere_share, light, directions, arrived[i - begin]);
      light.trace();
      directions.trace();
      for (std::size_t i = begin; i < end; ++i) {
        const Arrived& sums = arrived[i - begin];
        out[i] = (sums.by_lights + sums.by_hemisphere * (1.0F / savings.hemisphere_share)) * (1.0F / static_cast<float>(each)) +
                 sums.by_punctual;
      }
    }
  }

  void irradiance(std::span<const SurfaceSample> points, std::span<const std::uint64_t> keys, int samples,
                  const RaySavings& savings, RayStream& rays, std::span<Rgb> out) const {
    const auto receiver_at = [&](std::size_t i) -> std::optional<Receiver> {
      const SurfaceSample& point = points[i];
      if (!point.lit_side || lights.empty()) return std::nullopt;
      return Receiver{sensor, point, Frame(point.normal), world.ray_origin(point), {0.0F, 0.0F, 1.0F}, SobolSequence(keys[i])};
    };
    gather_all(points.size(), receiver_at, samples, savings, rays, out);
  }
  void radiance(std::span<const SurfaceSample> points, std::span<const Vec3> toward_viewer, std::span<const std::uint64_t> keys,
                int samples, RayStream& rays, std::span<Rgb> out) const {
    const auto is_seen = [&](std::size_t i) {
      return points[i].lit_side && !lights.empty() && glm::dot(points[i].normal, toward_viewer[i]) > 0.0F;
    };
    const auto receiver_at = [&](std::size_t i) -> std::optional<Receiver> {
      const SurfaceSample& point = points[i];
      if (!is_seen(i)) return std::nullopt;
      const Frame frame(point.normal);
      return Receiver{bsdf_of(point),        point, frame, world.ray_origin(point), frame.to_local(toward_viewer[i]),
                      SobolSequence(keys[i])};
    };
    gather_all(points.size(), receiver_at, samples, {}, rays, out);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (is_seen(i)) out[i] += emission(points[i]);
  }
};

DirectLight::DirectLight(const World& world, const Lighting& lighting, const DirectLightOptions& options)
    : impl_(std::make_unique<Impl>(world, lighting, options)) {}
DirectLight::~DirectLight() = default;

Rgb DirectLight::emission(const SurfaceSample& sample) const { return sample.lit_side ? impl_->emission(sample) : Rgb(); }

Rgb DirectLight::environment(const Vec3& direction) const { return impl_->lights.environment(direction); }

bool DirectLight::dark() const { return impl_->lights.empty(); }

const DirectLightOptions& DirectLight::options() const { return impl_->options; }

void DirectLight::irradiance(std::span<const SurfaceSample> points, std::span<const std::uint64_t> keys, int samples,
                             RayStream& rays, std::span<Rgb> out, const RaySavings& savings) const {
  GIBENCH_CHECK(keys.size() == points.size() && out.size() == points.size(), "one key and one value for each point");
  GIBENCH_CHECK(savings.hemisphere_share > 0.0F && savings.hemisphere_share <= 1.0F,
                "a hemisphere sample for each light sample at most");
  impl_->irradiance(points, keys, samples, savings, rays, out);
}

void DirectLight::radiance(std::span<const SurfaceSample> points, std::span<const Vec3> toward_viewer,
                           std::span<const std::uint64_t> keys, int samples, RayStream& rays, std::span<Rgb> out) const {
  GIBENCH_CHECK(toward_viewer.size() == points.size() && keys.size() == points.size() && out.size() == points.size(),
                "one direction, one key and one value for each point");
  impl_->radiance(points, toward_viewer, keys, samples, rays, out);
}

Rgb DirectLight::irradiance(const SurfaceSample& sample, std::uint64_t key, int samples, RayStream& rays) const {
  Rgb out;
  impl_->irradiance({&sample, 1}, {&key, 1}, samples, {}, rays, {&out, 1});
  return out;
}

Rgb DirectLight::radiance(const SurfaceSample& sample, const Vec3& toward_viewer, std::uint64_t key, int samples,
                          RayStream& rays) const {
  Rgb out;
  impl_->radiance({&sample, 1}, {&toward_viewer, 1}, {&key, 1}, samples, rays, {&out, 1});
  return out;
}

}  // namespace gibench
