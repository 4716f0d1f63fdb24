#include "common/reflectance/bsdf.h"

#include "common/scene/material_kinds.h"

namespace gibench {

SurfaceBsdf::SurfaceBsdf(const Material& material)
    : kind_(material.bsdf),
      diffuse_{material.diffuse},
      phong_{material.specular, material.exponent},
      ggx_(material.f0, grazing_reflectance(material), material.roughness),
      mirror_(material.reflectance) {}

SurfaceBsdf SurfaceBsdf::specular_part(const Material& material) {
  SurfaceBsdf bsdf(material);
  bsdf.diffuse_.albedo = Rgb();
  return bsdf;
}

SurfaceBsdf SurfaceBsdf::diffuse(const Rgb& albedo) {
  SurfaceBsdf bsdf;
  bsdf.diffuse_.albedo = albedo;
  return bsdf;
}

bool SurfaceBsdf::is_black() const {
  switch (kind_) {
    case Bsdf::diffuse: return gibench::is_black(diffuse_.albedo);
    case Bsdf::phong: return gibench::is_black(diffuse_.albedo) && gibench::is_black(phong_.specular);
    case Bsdf::ggx: return gibench::is_black(diffuse_.albedo) && gibench::is_black(ggx_.f0) && gibench::is_black(ggx_.f90);
    case Bsdf::mirror: return gibench::is_black(mirror_);
  }
  return true;
}

/// The largest channel of what it reflects, estimated at `out`.
float SurfaceBsdf::lobe_strength(const Vec3& out) const {
  switch (kind_) {
    case Bsdf::diffuse:
    case Bsdf::mirror: return 0.0F;
    case Bsdf::phong: return largest(phong_.specular);
    case Bsdf::ggx: return largest(ggx_.fresnel(out.z));
  }
  return 0.0F;
}

BsdfValue SurfaceBsdf::lobe_value(const Vec3& out, const Vec3& in) const {
  switch (kind_) {
    case Bsdf::diffuse:
    case Bsdf::mirror: return {};
    case Bsdf::phong: return {phong_.value(out, in), phong_.pdf(out, in)};
    case Bsdf::ggx: return {ggx_.value(out, in), ggx_.pdf(out, in)};
  }
  return {};
}

Vec3 SurfaceBsdf::lobe_sample(const Vec3& out, Vec2 u) const {
  switch (kind_) {
    case Bsdf::diffuse: return DiffuseLobe::sample(u);
    case Bsdf::mirror: return {-out.x, -out.y, out.z};
    case Bsdf::phong: return phong_.sample(out, u);
    case Bsdf::ggx: return ggx_.sample(out, u);
  }
  return DiffuseLobe::sample(u);
}

/// The probability of sampling the specular lobe: its share of what both reflect, estimated at `out`.
float SurfaceBsdf::specular_share(const Vec3& out, Lobes lobes) const {
  if (kind_ == Bsdf::diffuse || !contains(lobes, Lobes::specular)) return 0.0F;
  if (lobes == Lobes::specular) return 1.0F;
  const float specular = lobe_strength(out);
  const float both = specular + largest(diffuse_.albedo);
  return both > 0.0F ? specular / both : 0.0F;
}

BsdfValue SurfaceBsdf::evaluate(const Vec3& out, const Vec3& in) const {
  const LobeValues lobes = evaluate_lobes(out, in, Lobes::both);
  return {lobes.diffuse + lobes.specular, lobes.pdf};
}

LobeValues SurfaceBsdf::evaluate_lobes(const Vec3& out, const Vec3& in, Lobes lobes) const {
  LobeValues result;
  if (!(out.z > 0.0F) || !(in.z > 0.0F) || kind_ == Bsdf::mirror) return result;
  if (contains(lobes, Lobes::diffuse)) {
    result.diffuse = diffuse_.value();
    result.pdf = DiffuseLobe::pdf(in);
  }
  if (kind_ == Bsdf::diffuse || !contains(lobes, Lobes::specular)) return result;
  const float share = specular_share(out, lobes);
  const BsdfValue lobe = lobe_value(out, in);
  result.specular = lobe.value;
  result.pdf = (1.0F - share) * result.pdf + share * lobe.pdf;
  return result;
}

BsdfSample SurfaceBsdf::sample(const Vec3& out, float choice, Vec2 u, Lobes lobes) const {
  BsdfSample sample;
  if (!(out.z > 0.0F) || lobes == Lobes::none) return sample;
  if (kind_ == Bsdf::mirror) return {lobe_sample(out, u), contains(lobes, Lobes::specular) ? mirror_ : Rgb(), 0.0F, true};
  if (kind_ == Bsdf::diffuse) {
    if (!contains(lobes, Lobes::diffuse)) return sample;
    sample.in = DiffuseLobe::sample(u);
    sample.pdf = DiffuseLobe::pdf(sample.in);
    if (sample.pdf > 0.0F) sample.weight = diffuse_.albedo;
    return sample;
  }
  sample.in = choice >= specular_share(out, lobes) ? DiffuseLobe::sample(u) : lobe_sample(out, u);
  const LobeValues value = evaluate_lobes(out, sample.in, lobes);
  if (!(value.pdf > 0.0F)) return sample;
  sample.pdf = value.pdf;
  sample.weight = (value.diffuse + value.specular) * (sample.in.z / value.pdf);
  return sample;
}

}  // namespace gibench
