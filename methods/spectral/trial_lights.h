/// Lights by which compression is judged.
#pragma once

#include <span>
#include <vector>

#include "methods/spectral/transfer.h"

namespace gibench::spectral {

/// Irradiance fields projected onto the basis, three to one vector, in its channels, each with an area mean of 1 (0 for a light
/// that nothing sees).
struct TrialLights {
  std::vector<std::vector<Rgb4>> usual;   ///< measure how much light a function usually carries: 48 point lights and three skies
  std::vector<std::vector<Rgb4>> judges;  ///< judge what is left out: 24 other point lights, and the skies
};

/// Point lights at random in the open space of the scene; skies all round, above and to one side. Without `occlusion` nothing
/// stands before a point light, and no visibility ray is traced.
/// Above nodes that light is known not to reach none stands.
TrialLights trial_lights(const World& world, const Transfer& transfer, bool occlusion, Task& task);

/// The same plus light of one radiance everywhere, `ambient` times their means: what bounces add to them.
TrialLights with_ambient(TrialLights lights, const SpectralBasis& basis, float ambient);

}  // namespace gibench::spectral
