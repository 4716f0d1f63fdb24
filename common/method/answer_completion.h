/// Completion of a method's answers: direct light by the shared evaluator, and quantities that follow from irradiance.
#pragma once

#include "common/lighting/direct_light.h"
#include "common/method/shading.h"
#include "common/method/task.h"
#include "common/ray/world.h"

namespace gibench {

/// True for a quantity that follows from irradiance on surfaces that reflect diffusely.
bool follows_from_irradiance(Quantity quantity);

/// Turns irradiance in `direct` and `indirect` into the quantity asked for, on diffuse surfaces: radiosity B = π Le + ρ E,
/// radiance L = Le + ρ E / π. The emission Le counts as direct light.
void derive_from_irradiance(const World& world, const DirectLight& direct_light, const ShadeRequest& request,
                            const ShadeAnswer& answer);

/// Writes direct light by the shared evaluator: irradiance, radiance with every lobe of the surface, or radiosity.
void shade_direct(const World& world, const DirectLight& direct_light, const ShadeRequest& request, std::span<Rgb> direct,
                  Task& task);

}  // namespace gibench
