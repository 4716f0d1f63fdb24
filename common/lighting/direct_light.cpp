#include "common/lighting/direct_light.h"

#include <optional>
#include <vector>

#include "common/core/error.h"
#include "common/core/sampling.h"
#include "common/core/sobol.h"
#include "common/lighting/light_sampler.h"
#include "common/reflectance/scattering.h"

namespace gibench {

namespace {

constexpr Lobe all_lobes[] = {Lobe::diffuse, Lobe::glossy, Lobe::mirror};

/// The surface that straight light is reflected from, seen in its own frame.
struct Reflection {
  const SurfaceSample& at;
  const Scattering& surface;
  Frame frame;
  Vec3 outgoing;  // local, unit
};

}  // namespace

struct DirectLight::Impl {
  const World& world;
  LightSampler lights;
  std::vector<Scattering> scattering;  // of every material

  Impl(const World& w, const Lighting& lighting) : world(w), lights(w, lighting) {
    for (const Material& material : w.scene().materials) scattering.emplace_back(material);
  }

  /// Straight light reflected once, W/(m² sr).
  Rgb reflected(const Reflection& r, std::uint64_t key, int samples, RayStream& rays) const {
    Rgb sum;
    for (const std::uint32_t light : lights.delta_lights())
      if (const auto sample = lights.delta_light(r.at, light); sample && !rays.occluded(sample->shadow))
        for (const Lobe lobe : all_lobes)
          if (r.surface.has(lobe))
            sum += sample->radiance * r.surface.times_cosine(lobe, r.outgoing, r.frame.to_local(sample->direction));
    if (!lights.has_extended()) return sum;
    Rgb extended;
    for (int i = 0; i < samples; ++i) {
      SobolSampler random(key, static_cast<std::uint32_t>(i));
      extended += by_light(r, random, rays);
      extended += by_lobe(r, random, rays);
    }
    return sum + extended / static_cast<float>(samples);
  }

  /// Next-event estimate over the lights that have an extent.
  Rgb by_light(const Reflection& r, SobolSampler& random, RayStream& rays) const {
    const Vec2 choice = random.next_pair();
    const auto sample = lights.sample_extended(r.at, choice.x, random.next_pair());
    if (!sample) return Rgb();
    const Vec3 incoming = r.frame.to_local(sample->direction);
    Rgb weight;
    for (const Lobe lobe : all_lobes)
      if (r.surface.has(lobe))
        weight += r.surface.times_cosine(lobe, r.outgoing, incoming) *
                  power_heuristic(sample->pdf, r.surface.probability(lobe) * r.surface.pdf(lobe, r.outgoing, incoming));
    if (is_black(weight) || rays.occluded(sample->shadow)) return Rgb();
    return weight * sample->radiance / sample->pdf;
  }

  /// Estimate by a direction of one lobe, for what the light sampler finds badly or not at all.
  Rgb by_lobe(const Reflection& r, SobolSampler& random, RayStream& rays) const {
    const Vec2 choice = random.next_pair();
    const Lobe lobe = r.surface.choose(choice.x);
    const LobeSample sample = r.surface.sample(lobe, r.outgoing, random.next_pair());
    if (is_black(sample.weight)) return Rgb();
    const Vec3 direction = r.frame.to_world(sample.incoming);
    const Hit hit = rays.closest_hit({world.ray_origin(r.at), 0.0F, direction});
    Rgb radiance;
    float light_pdf = 0.0F;
    if (hit) {
      const SurfaceSample emitter = world.sample_of_hit(hit, direction);
      radiance = lights.emission(emitter.triangle, emitter.lit_side);
      light_pdf = lights.pdf_of_hit(r.at.position, emitter);
    } else {
      radiance = lights.environment(direction);
      light_pdf = lights.pdf_of_environment(direction, r.at.normal);
    }
    if (is_black(radiance)) return Rgb();
    const float probability = r.surface.probability(lobe);
    const float share =
        lobe == Lobe::mirror ? 1.0F : power_heuristic(probability * sample.pdf, lights.extended_factor() * light_pdf);
    return radiance * sample.weight * (share / probability);
  }
};

DirectLight::DirectLight(const World& world, const Lighting& lighting) : impl_(std::make_unique<Impl>(world, lighting)) {}
DirectLight::~DirectLight() = default;

const LightSampler& DirectLight::lights() const { return impl_->lights; }
bool DirectLight::dark() const { return impl_->lights.dark(); }
Rgb DirectLight::environment(const Vec3& direction) const { return impl_->lights.environment(direction); }
Rgb DirectLight::emission(const SurfaceSample& sample) const { return impl_->lights.emission(sample.triangle, sample.lit_side); }

Rgb DirectLight::irradiance(const SurfaceSample& sample, std::uint64_t key, int samples, RayStream& rays) const {
  GIBENCH_CHECK(samples > 0, "an estimate takes one sample at least");
  if (!sample.lit_side || dark()) return Rgb();
  // A receiver of irradiance is a white diffuse surface: E = π L.
  static const Scattering white = Scattering::diffuse_only(Rgb(1.0F));
  return pi * impl_->reflected({sample, white, Frame(sample.normal), {0.0F, 0.0F, 1.0F}}, key, samples, rays);
}

Rgb DirectLight::radiance(const SurfaceSample& sample, const Vec3& toward_viewer, std::uint64_t key, int samples,
                          RayStream& rays) const {
  GIBENCH_CHECK(samples > 0, "an estimate takes one sample at least");
  if (!sample.lit_side || dark()) return Rgb();
  const Scattering& surface = impl_->scattering[impl_->world.scene().objects[sample.object].material];
  const Frame frame(sample.normal);
  return emission(sample) + impl_->reflected({sample, surface, frame, frame.to_local(toward_viewer)}, key, samples, rays);
}

}  // namespace gibench
