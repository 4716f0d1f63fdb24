#include "common/reflectance/scattering.h"

#include <algorithm>

#include "common/core/sampling.h"

namespace gibench {

Scattering::Scattering(const Material& material) {
  if (material.bsdf != Bsdf::mirror) diffuse_ = material.diffuse;
  float glossy = 0.0F;
  if (material.bsdf == Bsdf::phong && !is_black(material.specular)) {
    glossy_ = Glossy::phong;
    phong_ = {material.specular, material.exponent};
    glossy = largest(material.specular);
  } else if (material.bsdf == Bsdf::ggx) {
    glossy_ = Glossy::ggx;
    ggx_ = {material.f0, std::max(GgxLobe::least_alpha, material.roughness * material.roughness)};
    // Schlick's reflectance reaches one at grazing angles whatever f0 is: the lobe is never left out.
    glossy = std::max(0.1F, largest(material.f0));
  } else if (material.bsdf == Bsdf::mirror) {
    mirror_ = material.reflectance;
  }
  weigh_lobes(largest(diffuse_), glossy, largest(mirror_));
}

Scattering Scattering::diffuse_only(const Rgb& albedo) {
  Scattering scattering;
  scattering.diffuse_ = albedo;
  scattering.weigh_lobes(largest(albedo), 0.0F, 0.0F);
  return scattering;
}

void Scattering::weigh_lobes(float diffuse, float glossy, float mirror) {
  const float sum = diffuse + glossy + mirror;
  if (!(sum > 0.0F)) return;
  probability_[0] = diffuse / sum;
  probability_[1] = glossy / sum;
  probability_[2] = mirror / sum;
}

Lobe Scattering::choose(float u) const {
  if (u < probability_[0]) return Lobe::diffuse;
  if (probability_[2] > 0.0F) return Lobe::mirror;  // a mirror has no other lobe
  return probability_[1] > 0.0F ? Lobe::glossy : Lobe::diffuse;
}

Rgb Scattering::times_cosine(Lobe lobe, const Vec3& outgoing, const Vec3& incoming) const {
  if (incoming.z <= 0.0F || outgoing.z <= 0.0F || lobe == Lobe::mirror) return Rgb();
  if (lobe == Lobe::diffuse) return diffuse_ * (incoming.z / pi);
  return (glossy_ == Glossy::ggx ? ggx_.evaluate(outgoing, incoming) : phong_.evaluate(outgoing, incoming)) * incoming.z;
}

float Scattering::pdf(Lobe lobe, const Vec3& outgoing, const Vec3& incoming) const {
  if (incoming.z <= 0.0F || outgoing.z <= 0.0F || lobe == Lobe::mirror) return 0.0F;
  if (lobe == Lobe::diffuse) return incoming.z / pi;
  return glossy_ == Glossy::ggx ? ggx_.pdf(outgoing, incoming) : phong_.pdf(outgoing, incoming);
}

LobeSample Scattering::sample(Lobe lobe, const Vec3& outgoing, Vec2 u) const {
  LobeSample sample;
  if (lobe == Lobe::mirror) {
    sample.incoming = PhongLobe::mirrored(outgoing);
    sample.weight = mirror_;
    return sample;
  }
  if (lobe == Lobe::diffuse) {
    sample.incoming = square_to_cosine_hemisphere(u);
    sample.pdf = sample.incoming.z / pi;
    if (sample.pdf > 0.0F) sample.weight = diffuse_;
    return sample;
  }
  sample.incoming = glossy_ == Glossy::ggx ? ggx_.sample(outgoing, u) : phong_.sample(outgoing, u);
  sample.pdf = pdf(Lobe::glossy, outgoing, sample.incoming);
  if (!(sample.pdf > 0.0F)) return sample;
  if (glossy_ == Glossy::ggx) sample.weight = ggx_.weight(outgoing, sample.incoming);
  else sample.weight = phong_.specular * ((phong_.exponent + 2.0F) / (phong_.exponent + 1.0F) * sample.incoming.z);
  return sample;
}

}  // namespace gibench
