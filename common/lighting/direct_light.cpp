#include "common/lighting/direct_light.h"

#include <algorithm>
#include <array>

#include "common/core/sobol.h"
#include "common/lighting/next_event.h"
#include "common/lighting/scene_lights.h"
#include "common/reflectance/bsdf.h"
#include "common/scene/light_kinds.h"

namespace gibench {

namespace {

constexpr std::uint32_t light_place = 0, light_choice = 1, hemisphere = 2, lobe_choice = 3;  // dimension pairs
constexpr std::size_t batch = 32;                                                            // rays traced together
constexpr std::size_t most_visited = 64;         // punctual lights that are each given a ray
constexpr std::size_t most_looked_through = 64;  // emitting triangles that are each tested against a ray

/// The surface point that light is gathered at, with the lobe that weighs it.
struct Gatherer {
  const World& world;
  const SceneLights& lights;
  const SurfaceBsdf& bsdf;
  const SurfaceSample& sample;
  Frame frame;
  Vec3 origin;  ///< of rays
  Vec3 out;     ///< towards the viewer, local
  SobolSequence random;
  RayStream& rays;
  const DirectLightOptions& options;
  NextEvent next_event{lights, 1.0F};

  Rgb from_punctual() const;
  Rgb from_lights(std::uint32_t begin, std::uint32_t end) const;
  Rgb from_hemisphere(std::uint32_t begin, std::uint32_t end) const;
  void find_lights(std::span<const Ray> directions, std::span<Hit> hits) const;
  Rgb arriving(const Hit& hit, const Vec3& direction, float pdf) const;
};

/// Light on its way to the surface point, held back until its shadow rays are traced together.
class PendingLight {
 public:
  PendingLight(const Gatherer& gatherer, Rgb& sum) : gatherer_(gatherer), sum_(sum) {}

  void add(const LightSample& light) {
    if (!(light.pdf > 0.0F)) return;
    const Vec3 in = gatherer_.frame.to_local(light.direction);
    const BsdfValue value = gatherer_.bsdf.evaluate(gatherer_.out, in);
    const Rgb contribution = value.value * light.radiance * (in.z / light.pdf);
    if (is_black(contribution)) return;
    if (count_ == batch) trace();
    shadow_rays_[count_] = light.shadow_ray(gatherer_.origin);
    contributions_[count_++] = contribution * gatherer_.next_event.weight(light, value.pdf);
  }
  void trace() {
    std::array<std::uint8_t, batch> occluded{};
    if (gatherer_.options.tests_visibility) gatherer_.rays.occlusions({shadow_rays_.data(), count_}, {occluded.data(), count_});
    for (std::size_t i = 0; i < count_; ++i)
      if (!occluded[i]) sum_ += contributions_[i];
    count_ = 0;
  }

 private:
  const Gatherer& gatherer_;
  Rgb& sum_;
  std::array<Ray, batch> shadow_rays_;
  std::array<Rgb, batch> contributions_;
  std::size_t count_ = 0;
};

/// The sum over all punctual lights.
Rgb Gatherer::from_punctual() const {
  Rgb sum;
  PendingLight pending(*this, sum);
  for (std::size_t light = 0; light < lights.punctual_count(); ++light) pending.add(lights.punctual(light, sample.position));
  pending.trace();
  return sum;
}

/// The sum over light samples [begin, end).
Rgb Gatherer::from_lights(std::uint32_t begin, std::uint32_t end) const {
  Rgb sum;
  PendingLight pending(*this, sum);
  for (std::uint32_t i = begin; i < end; ++i) {
    const LightSample light =
        lights.sample(sample.position, sample.normal, random.pair(i, light_choice).x, random.pair(i, light_place).unit());
    pending.add(light);
  }
  pending.trace();
  return sum;
}

/// The sum over directions [begin, end) drawn from the lobe.
Rgb Gatherer::from_hemisphere(std::uint32_t begin, std::uint32_t end) const {
  std::array<Ray, batch> directions;
  std::array<Hit, batch> hits;
  std::array<BsdfSample, batch> samples;
  std::size_t count = 0;
  for (std::uint32_t i = begin; i < end; ++i) {
    const BsdfSample drawn = bsdf.sample(out, random.pair(i, lobe_choice).unit().x, random.pair(i, hemisphere).unit());
    if (is_black(drawn.weight)) continue;
    directions[count] = {origin, 0.0F, frame.to_world(drawn.in)};
    samples[count++] = drawn;
  }
  find_lights({directions.data(), count}, {hits.data(), count});
  Rgb sum;
  for (std::size_t i = 0; i < count; ++i) sum += samples[i].weight * arriving(hits[i], directions[i].direction, samples[i].pdf);
  return sum;
}

/// What the rays meet, as far as light may come from there. Where nothing is hidden, a ray meets the emitter that it points
/// at; among many of them it is looked up as the closest surface.
void Gatherer::find_lights(std::span<const Ray> directions, std::span<Hit> hits) const {
  if (options.tests_visibility || (options.surfaces_in_sight && lights.emitter_count() > most_looked_through)) {
    rays.closest_hits(directions, hits);
    return;
  }
  for (std::size_t i = 0; i < directions.size(); ++i)
    hits[i] = options.surfaces_in_sight ? lights.emitter_met(directions[i].origin, directions[i].direction) : Hit();
}

/// Radiance that a ray drawn with this density (0: a mirror's) brings from a light, times its weight.
Rgb Gatherer::arriving(const Hit& hit, const Vec3& direction, float pdf) const {
  if (!hit) return next_event.environment(sample.normal, direction, pdf);
  const Object& object = world.scene().objects[world.scene().triangle_object[hit.triangle]];
  const float cosine = -glm::dot(world.normal(hit.triangle), direction);
  return next_event.emission(sample.position, {hit.triangle, object.material, hit.distance, cosine, object.two_sided}, pdf);
}

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

  Rgb gather(const SurfaceBsdf& bsdf, const SurfaceSample& sample, const Vec3& out, std::uint64_t key, int samples,
             RayStream& rays) const {
    const Frame frame(sample.normal);
    const Gatherer gatherer{world, lights, bsdf, sample, frame, world.ray_origin(sample), out, SobolSequence(key), rays, options};
    const auto count = static_cast<std::uint32_t>(std::max(1, samples));
    Rgb sum;
    const bool samples_lights = !bsdf.is_delta() && !lights.nothing_to_sample();
    for (std::uint32_t begin = 0; begin < count; begin += batch) {
      const std::uint32_t end = std::min<std::uint32_t>(count, begin + batch);
      if (samples_lights) sum += gatherer.from_lights(begin, end);
      if (lights.can_be_hit()) sum += gatherer.from_hemisphere(begin, end);
    }
    sum *= 1.0F / static_cast<float>(count);
    if (visits_punctual && !bsdf.is_delta()) sum += gatherer.from_punctual();
    return sum;
  }
};

DirectLight::DirectLight(const World& world, const Lighting& lighting, const DirectLightOptions& options)
    : impl_(std::make_unique<Impl>(world, lighting, options)) {}
DirectLight::~DirectLight() = default;

Rgb DirectLight::emission(const SurfaceSample& sample) const {
  if (!sample.lit_side) return Rgb();
  return impl_->lights.emission_of_material(impl_->world.scene().objects[sample.object].material);
}

Rgb DirectLight::environment(const Vec3& direction) const { return impl_->lights.environment(direction); }

bool DirectLight::dark() const { return impl_->lights.empty(); }

const DirectLightOptions& DirectLight::options() const { return impl_->options; }

Rgb DirectLight::irradiance(const SurfaceSample& sample, std::uint64_t key, int samples, RayStream& rays) const {
  if (!sample.lit_side || dark()) return Rgb();
  return impl_->gather(impl_->sensor, sample, {0.0F, 0.0F, 1.0F}, key, samples, rays);
}

Rgb DirectLight::radiance(const SurfaceSample& sample, const Vec3& toward_viewer, std::uint64_t key, int samples,
                          RayStream& rays) const {
  const Vec3 out = Frame(sample.normal).to_local(toward_viewer);
  if (!sample.lit_side || dark() || !(out.z > 0.0F)) return Rgb();
  const SurfaceBsdf& bsdf = impl_->bsdfs[impl_->world.scene().objects[sample.object].material];
  return emission(sample) + impl_->gather(bsdf, sample, out, key, samples, rays);
}

}  // namespace gibench
