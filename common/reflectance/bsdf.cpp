#include "common/reflectance/bsdf.h"

namespace gibench {

SurfaceBsdf::SurfaceBsdf(const Material& material)
    : kind_(material.bsdf),
      diffuse_{material.diffuse},
      phong_{material.specular, material.exponent},
      ggx_(material.f0, material.roughness),
      mirror_(material.reflectance) {}

SurfaceBsdf SurfaceBsdf::diffuse(const Rgb& albedo) {
  SurfaceBsdf bsdf;
  bsdf.diffuse_.albedo = albedo;
  return bsdf;
}

bool SurfaceBsdf::is_black() const {
  switch (kind_) {
    case Bsdf::diffuse: return gibench::is_black(diffuse_.albedo);
    case Bsdf::phong: return gibench::is_black(diffuse_.albedo) && gibench::is_black(phong_.specular);
    case Bsdf::ggx: return false;  // Schlick's term reflects at grazing even where f0 is zero
    case Bsdf::mirror: return gibench::is_black(mirror_);
  }
  return true;
}

/// The probability of sampling the specular lobe: its share of what both reflect, estimated at `out`.
float SurfaceBsdf::specular_share(const Vec3& out) const {
  if (kind_ == Bsdf::diffuse) return 0.0F;
  const float specular = kind_ == Bsdf::phong ? largest(phong_.specular) : largest(ggx_.fresnel(out.z));
  const float both = specular + largest(diffuse_.albedo);
  return both > 0.0F ? specular / both : 0.0F;
}

BsdfValue SurfaceBsdf::evaluate(const Vec3& out, const Vec3& in) const {
  if (!(out.z > 0.0F) || !(in.z > 0.0F) || kind_ == Bsdf::mirror) return {};
  BsdfValue result{diffuse_.value(), DiffuseLobe::pdf(in)};
  if (kind_ == Bsdf::diffuse) return result;
  const float share = specular_share(out);
  const bool phong = kind_ == Bsdf::phong;
  result.value += phong ? phong_.value(out, in) : ggx_.value(out, in);
  result.pdf = (1.0F - share) * result.pdf + share * (phong ? phong_.pdf(out, in) : ggx_.pdf(out, in));
  return result;
}

BsdfSample SurfaceBsdf::sample(const Vec3& out, float choice, Vec2 u) const {
  BsdfSample sample;
  if (!(out.z > 0.0F)) return sample;
  if (kind_ == Bsdf::mirror) return {{-out.x, -out.y, out.z}, mirror_, 0.0F, true};
  if (kind_ == Bsdf::diffuse) {
    sample.in = DiffuseLobe::sample(u);
    sample.pdf = DiffuseLobe::pdf(sample.in);
    if (sample.pdf > 0.0F) sample.weight = diffuse_.albedo;
    return sample;
  }
  if (choice >= specular_share(out)) sample.in = DiffuseLobe::sample(u);
  else sample.in = kind_ == Bsdf::phong ? phong_.sample(out, u) : ggx_.sample(out, u);
  const BsdfValue value = evaluate(out, sample.in);
  if (!(value.pdf > 0.0F)) return sample;
  sample.pdf = value.pdf;
  sample.weight = value.value * (sample.in.z / value.pdf);
  return sample;
}

}  // namespace gibench
