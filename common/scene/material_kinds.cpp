#include "common/scene/material_kinds.h"

#include <algorithm>

#include "common/core/error.h"

namespace gibench {

namespace {

Gloss gloss_unless_black(const Rgb& reflected, Gloss gloss) { return is_black(reflected) ? Gloss::none : gloss; }

}  // namespace

const char* to_string(Bsdf bsdf) {
  switch (bsdf) {
    case Bsdf::diffuse: return "diffuse";
    case Bsdf::phong: return "phong";
    case Bsdf::ggx: return "ggx";
    case Bsdf::mirror: return "mirror";
  }
  GIBENCH_CHECK(false, "a Bsdf is one of all_bsdfs");
}

Gloss gloss_of(const Material& material) {
  switch (material.bsdf) {
    case Bsdf::diffuse: return Gloss::none;
    case Bsdf::phong: return gloss_unless_black(material.specular, Gloss::lobe);
    case Bsdf::ggx: return gloss_unless_black(material.f0 + grazing_reflectance(material), Gloss::lobe);
    case Bsdf::mirror: return gloss_unless_black(material.reflectance, Gloss::mirror);
  }
  GIBENCH_CHECK(false, "a Bsdf is one of all_bsdfs");
}

Rgb straight_reflectance(const Material& material) {
  switch (material.bsdf) {
    case Bsdf::diffuse: return material.diffuse;
    case Bsdf::phong: return material.diffuse + material.specular;
    case Bsdf::ggx: return material.diffuse + material.f0;
    case Bsdf::mirror: return material.reflectance;
  }
  GIBENCH_CHECK(false, "a Bsdf is one of all_bsdfs");
}

Rgb grazing_reflectance(const Material& material) {
  const auto left = [](float diffuse) { return std::clamp(1.0F - diffuse, 0.0F, 1.0F); };
  return {left(material.diffuse.r), left(material.diffuse.g), left(material.diffuse.b)};
}

float largest_reflectance(const Material& material) {
  // The normalised Phong lobe reflects ks straight on and less aslant; Schlick's term grows to what the diffuse part leaves.
  const float straight = largest(straight_reflectance(material));
  return reflects_most_at_grazing(material.bsdf) ? std::max(straight, largest(material.diffuse + grazing_reflectance(material)))
                                                 : straight;
}

bool reflects_most_at_grazing(Bsdf bsdf) {
  switch (bsdf) {
    case Bsdf::diffuse:
    case Bsdf::phong:
    case Bsdf::mirror: return false;
    case Bsdf::ggx: return true;
  }
  GIBENCH_CHECK(false, "a Bsdf is one of all_bsdfs");
}

}  // namespace gibench
