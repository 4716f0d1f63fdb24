#include "methods/spectral/lobe_store.h"

namespace gibench::spectral {

bool has_lobe(const Material& material) {
  switch (material.bsdf) {
    case Bsdf::diffuse: return false;
    case Bsdf::phong: return !is_black(material.specular);
    case Bsdf::ggx: return true;
    case Bsdf::mirror: return !is_black(material.reflectance);
  }
  return false;
}

std::shared_ptr<const LobeHarmonics> LobeStore::lobe_of(const Material& material) {
  if (!has_lobe(material)) return nullptr;
  const auto channels = [](const Rgb& c) { return std::tuple(c.r, c.g, c.b); };
  const Key key(static_cast<int>(material.bsdf), channels(material.specular), material.exponent, material.roughness,
                channels(material.f0), channels(material.reflectance));
  auto& lobe = lobes_[key];
  if (!lobe) lobe = std::make_shared<const LobeHarmonics>(material);
  return lobe;
}

}  // namespace gibench::spectral
