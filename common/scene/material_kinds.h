/// The facts of every kind of BRDF that need no evaluation. A kind without them does not compile.
#pragma once

#include <array>

#include "common/scene/scene.h"

namespace gibench {

inline constexpr std::array all_bsdfs{Bsdf::diffuse, Bsdf::phong, Bsdf::ggx, Bsdf::mirror};
/// "diffuse", as scene files write it.
const char* to_string(Bsdf bsdf);

/// What a surface does to light apart from reflecting it diffusely.
enum class Gloss { none, lobe, mirror };
Gloss gloss_of(const Material& material);

/// Reflected at normal incidence, channel by channel.
Rgb straight_reflectance(const Material& material);
/// Over all directions, the largest channel.
float largest_reflectance(const Material& material);
/// Whether aslant more is reflected than straight on, whatever the material.
bool reflects_most_at_grazing(Bsdf bsdf);

}  // namespace gibench
