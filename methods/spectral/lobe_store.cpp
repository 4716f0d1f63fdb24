#include "methods/spectral/lobe_store.h"

#include "common/scene/material_kinds.h"

namespace gibench::spectral {

bool has_lobe(const Material& material) { return gloss_of(material) != Gloss::none; }

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
