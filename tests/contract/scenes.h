/// The scenes that the contract is held against.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/ray/world.h"
#include "common/scene/scene.h"

namespace gibench::contract {

inline constexpr std::size_t sample_count = 320;
inline constexpr std::uint64_t sample_seed = 11;

/// A diffuse box with two blocks, lit by a lamp, a point light and a spot light: what every method can do.
Scene plain_box();
/// The same surfaces with no reflection at all.
Scene black_box();
/// The same surfaces without any light.
Scene dark_box();

/// Lights and emissions times `factor`.
Lighting scaled(Lighting lighting, float factor);
/// Everything that emits, and nothing else.
Lighting only_emission(Lighting lighting);
/// Everything but what emits.
Lighting only_punctual(Lighting lighting);

/// Samples of the lit sides, uniform by area.
std::vector<SurfaceSample> samples_of(const World& world);
/// The same points as seen from the other side: black on a one-sided object.
std::vector<SurfaceSample> other_sides(const World& world, const std::vector<SurfaceSample>& samples);
/// The same points in a scene that was moved or scaled.
std::vector<SurfaceSample> carried_over(const World& to, const std::vector<SurfaceSample>& samples);

/// A scene that asks for something out of the ordinary.
struct OddScene {
  std::string name;
  Scene scene;
  bool ordinary_surfaces = false;  ///< diffuse surfaces and ordinary lights: no reason to refuse it
};
std::vector<OddScene> odd_scenes();

}  // namespace gibench::contract
