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
/// Schlick reflectance at grazing incidence of what lies over a material's diffuse part: 1 − diffuse, what that part leaves.
/// With Schlick's F = f0 + (f90 − f0)(1 − cos)^5 (Schlick 1994; f90 as in Lagarde and de Rousiers 2014, 3.2) and f0 + diffuse at
/// most 1, F is at most 1 − diffuse for every pair of directions. The GGX lobe with Smith's masking reflects at most all of
/// what it gets where F is 1 (Heitz 2014, 3.4), so that lobe and diffuse part together reflect at most all. The sum is
/// reciprocal, and the diffuse part stays Lambertian with its albedo, as finite-element methods take it.
Rgb grazing_reflectance(const Material& material);
/// Over all directions, the largest channel.
float largest_reflectance(const Material& material);
/// Whether aslant more is reflected than straight on, whatever the material.
bool reflects_most_at_grazing(Bsdf bsdf);

}  // namespace gibench
