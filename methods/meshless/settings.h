/// The parameters of meshless hierarchical radiosity, with the names and defaults of Lehtinen et al. 2007.
#pragma once

#include "common/method/parameters.h"
#include "common/method/presets.h"

namespace gibench::meshless {

/// How objects are parted into reconstruction groups, between which no basis function reaches.
enum class Grouping {
  objects,     ///< Object::group alone (the paper)
  components,  ///< its connected components, too
  automatic,   ///< the largest components, and what is left of every object
};
/// What the gathers of the first bounce see at their hits: direct light evaluated there, or from the basis. `automatic`
/// takes the former where its noise is small enough.
enum class FirstBounce { automatic, exact, basis };
/// Who answers for direct light.
enum class DirectAnswer { shared, basis };

inline constexpr int most_neighbours = 64, most_levels = 12;

/// The mean of irradiance over the surfaces that epsilon_E is a share of: by area, or weighted once more by irradiance, so that
/// dark surfaces do not dilute it.
enum class ThresholdMean { area, irradiance };

/// Each member is initialised with the default of its parameter.
struct Settings {
  // Placement (section 6.1).
  int levels = 6;
  int coarsest_samples = 310;   ///< wanted on level 0, at least; sets the initial radius
  int most_coarsest = 1600;     ///< placed there where surfaces are near each other
  double feature_radius = 0.5;  ///< largest initial radius, in medians of the harmonic mean distance that surfaces see
  double initial_radius = 0.0;  ///< share of the scene's diagonal; 0: from coarsest_samples
  int failures = 1000;          ///< proposals turned down in a row that end a level
  bool backface_test = true;
  int backface_rays = 16;  ///< all must meet backs for a point to count as inside geometry; 1: the paper's test
  Grouping grouping = Grouping::automatic;
  // Basis (section 4.2).
  int neighbours = 10;        ///< k of the nearest-neighbour radius
  double radius_limit = 4.0;  ///< largest radius of a basis function, in disc radii of its level
  int cut_levels = 2;         ///< the last ones, whose functions end at walls
  int corrections = 1;        ///< repetitions of a level on its own points
  // Transport (section 6.3).
  int rays = 512;            ///< of a gather; fewer on finer levels than the first after bounce_levels, see LightAtPoints
  int coarsest_rays = 2048;  ///< of a gather on level 0, half of it on each further one of bounce_levels: their noise remains
                             ///< where light is smooth
  double epsilon_e = 0.04;   ///< receiver threshold, share of the mean irradiance
  ThresholdMean threshold_mean = ThresholdMean::irradiance;
  double proximity = 0.3;                     ///< of the spread within a ball that near surroundings may cause
  double level_growth = 1.4;                  ///< of the receiver threshold from level to level
  double epsilon_omega = 0.3141592653589793;  ///< sender threshold, sr
  double noise_guard = 5.0;                   ///< deviations of the estimates that a difference must exceed to be refined
  int bounces = 100;                          ///< most bounces computed one by one
  int bounce_levels = 2;    ///< that the bounces are solved on, before one gather over all; 0: over all (the paper)
  double residual = 1e-3;   ///< share of the solution that the bounces left out may hold
  bool extrapolate = true;  ///< add the geometric tail once the bounces have settled into it
  FirstBounce first_bounce = FirstBounce::automatic;
  DirectAnswer direct = DirectAnswer::shared;
  int direct_samples = 1;          ///< light samples at a hit, at least
  double hemisphere_share = 0.25;  ///< hemisphere samples for each light sample
  double small_light = 0.5;        ///< of the mean direct irradiance: what would bring less to a hit is tried by chance only
  int basis_direct_samples = 16;   ///< light samples at a basis point, at least
  int direct_full_level = 2;  ///< levels up to this one hold direct light wholly: small lights and shadows must not slip through
};

ParameterSchema settings_schema();
std::vector<Preset> presets();
Settings settings_from(const Parameters& parameters);

}  // namespace gibench::meshless
