#include "methods/meshless/settings.h"

#include "common/method/parameter_table.h"

namespace gibench::meshless {

namespace {

const ParameterTable<Settings>& table() {
  constexpr double largest = 1e6;
  static const ParameterTable<Settings> made{
      parameter("levels", &Settings::levels, 1, most_levels, "levels of the point hierarchy; each halves the disc radius"),
      parameter("coarsest_samples", &Settings::coarsest_samples, 1, largest,
                "samples wanted on the coarsest level; sets the initial radius"),
      parameter("most_coarsest", &Settings::most_coarsest, 1, largest,
                "samples on the coarsest level at most, where more than coarsest_samples suit feature_radius"),
      parameter(
          "feature_radius", &Settings::feature_radius, 0.0, largest,
          "largest disc radius of the coarsest level, in medians of the harmonic mean distance that surfaces see; 0: no limit"),
      parameter("initial_radius", &Settings::initial_radius, 0.0, 1.0,
                "disc radius of the coarsest level, share of the scene's diagonal; 0: from coarsest_samples"),
      parameter("failures", &Settings::failures, 1, largest, "proposals turned down in a row that end a level"),
      parameter("backface_test", &Settings::backface_test,
                "turn down points inside geometry: the ray along the normal meets a back"),
      parameter("backface_rays", &Settings::backface_rays, 1, 1024,
                "rays that must all meet backs for a point to count as inside; 1: the paper's test"),
      parameter("groups", &Settings::grouping,
                {{"objects", Grouping::objects}, {"components", Grouping::components}, {"automatic", Grouping::automatic}},
                "reconstruction groups: as the scene says, also by connected component, or so for the largest components only"),
      parameter("neighbours", &Settings::neighbours, 1, most_neighbours,
                "k: a basis function reaches its k-th nearest neighbour"),
      parameter("radius_limit", &Settings::radius_limit, 1.0, largest,
                "largest reach of a basis function, disc radii of its level"),
      parameter("cut_levels", &Settings::cut_levels, 0, most_levels - 1,
                "levels, the last ones, whose basis functions end at walls that stand within their reach; 0: none"),
      parameter("corrections", &Settings::corrections, 0, 8,
                "times that a level is corrected at its own points; 0: the paper's single pass"),
      parameter("rays", &Settings::rays, 1, 65536,
                "rays of a gather; on finer levels fewer by level_growth to the power of 4/5 a level"),
      parameter("coarsest_rays", &Settings::coarsest_rays, 1, 65536,
                "rays of a gather on the coarsest level, half as many on each further one of bounce_levels; `rays` at least"),
      parameter("epsilon_E", &Settings::epsilon_e, 0.0, largest,
                "receivers are refined where irradiance varies by more, share of the mean indirect irradiance"),
      parameter("threshold_mean", &Settings::threshold_mean,
                {{"area", ThresholdMean::area}, {"irradiance", ThresholdMean::irradiance}},
                "the mean that epsilon_E is a share of: over the surfaces' area, or over the light that they get"),
      parameter(
          "proximity", &Settings::proximity, 0.0, largest,
          "receivers are refined, too, where this times their radius times the slope that near surroundings may cause exceeds "
          "epsilon_E; 0: the paper's oracle"),
      parameter("level_growth", &Settings::level_growth, 1.0, 4.0,
                "growth of epsilon_E from level to level: 1 bounds the largest error (the paper), 2 the mean squared one at "
                "least cost"),
      parameter("epsilon_Omega", &Settings::epsilon_omega, 0.0, 12.6,
                "senders are evaluated down to balls of this solid angle, sr"),
      parameter("noise_guard", &Settings::noise_guard, 0.0, 100.0,
                "standard deviations of the gathers that a difference must exceed to be refined; 0: the paper's oracle"),
      parameter("bounces", &Settings::bounces, 1, 10000, "most bounces that are computed"),
      parameter("bounce_levels", &Settings::bounce_levels, 0, most_levels,
                "levels that the bounces are solved on, before one gather over all of them; 0: each bounce is gathered over all"),
      parameter("residual", &Settings::residual, 1e-9, 1.0,
                "the series ends when the bounces left out hold less, share of the solution"),
      parameter("extrapolate", &Settings::extrapolate, "add the bounces left out as a geometric series once they follow one"),
      parameter("first_bounce", &Settings::first_bounce,
                {{"automatic", FirstBounce::automatic}, {"exact", FirstBounce::exact}, {"basis", FirstBounce::basis}},
                "direct light at the hits of the first gathers: evaluated there, or from the basis; automatic goes by its noise"),
      parameter("direct", &Settings::direct, {{"shared", DirectAnswer::shared}, {"basis", DirectAnswer::basis}},
                "direct light is answered by the shared evaluator, or from the basis"),
      parameter("direct_samples", &Settings::direct_samples, 1, 1024,
                "light samples at a hit of a first gather; more where direct light is noisy"),
      parameter("hemisphere_share", &Settings::hemisphere_share, 0.001, 1.0,
                "hemisphere samples for each light sample, for gathers and the basis, where that adds little noise, else 1"),
      parameter("small_light", &Settings::small_light, 0.0, largest,
                "light that would bring less than this to a hit, share of the mean direct irradiance, is tried by chance only; "
                "0: always"),
      parameter("basis_direct_samples", &Settings::basis_direct_samples, 1, 65536,
                "light samples at a basis point, for direct light in the basis; more where it is noisy"),
      parameter(
          "direct_full_level", &Settings::direct_full_level, 0, most_levels - 1,
          "direct light in the basis is computed wholly on levels up to this one, refined on others; 0: the paper's oracle"),
  };
  return made;
}

}  // namespace

ParameterSchema settings_schema() { return table().schema(); }

std::vector<Preset> presets() {
  return {{"paper",
           "the text's algorithm with the constants of its Cornell box: light in the basis, no guards, no corrections",
           {{"levels", "6"},
            {"coarsest_samples", "310"},
            {"feature_radius", "0"},
            {"failures", "1000"},
            {"backface_rays", "1"},
            {"groups", "objects"},
            {"neighbours", "10"},
            {"radius_limit", "1000000"},
            {"cut_levels", "0"},
            {"corrections", "0"},
            {"rays", "512"},
            {"coarsest_rays", "512"},
            {"epsilon_E", "0.01"},
            {"threshold_mean", "area"},
            {"proximity", "0"},
            {"level_growth", "1"},
            {"epsilon_Omega", "0.3141592653589793"},
            {"noise_guard", "0"},
            {"bounce_levels", "0"},
            {"extrapolate", "false"},
            {"first_bounce", "basis"},
            {"direct", "basis"},
            {"hemisphere_share", "1"},
            {"small_light", "0"},
            {"direct_full_level", "0"}}}};
}

Settings settings_from(const Parameters& parameters) { return table().read(parameters); }

}  // namespace gibench::meshless
