#include "methods/meshless/settings.h"

namespace gibench::meshless {

ParameterSchema settings_schema() {
  const double largest = 1e6;
  return {
      {"levels", std::int64_t{6}, 1, 12, {}, "levels of the point hierarchy; each halves the disc radius"},
      {"coarsest_samples", std::int64_t{310}, 1, largest, {}, "samples wanted on the coarsest level; sets the initial radius"},
      {"initial_radius",
       0.0,
       0.0,
       1.0,
       {},
       "disc radius of the coarsest level, share of the scene's diagonal; 0: from coarsest_samples"},
      {"failures", std::int64_t{1000}, 1, largest, {}, "proposals turned down in a row that end a level"},
      {"backface_test", true, 0, 0, {}, "turn down points inside geometry: the ray along the normal meets a back"},
      {"backface_rays",
       std::int64_t{16},
       1,
       1024,
       {},
       "rays that must all meet backs for a point to count as inside; 1: the paper's test"},
      {"groups",
       std::string("automatic"),
       0,
       0,
       {"objects", "components", "automatic"},
       "reconstruction groups: as the scene says, also by connected component, or that where the components are few"},
      {"neighbours", std::int64_t{10}, 1, most_neighbours, {}, "k: a basis function reaches its k-th nearest neighbour"},
      {"radius_limit", 4.0, 1.0, largest, {}, "largest reach of a basis function, disc radii of its level"},
      {"corrections", std::int64_t{1}, 0, 8, {}, "times that a level is corrected at its own points; 0: the paper's single pass"},
      {"rays", std::int64_t{512}, 1, 65536, {}, "rays of a gather"},
      {"coarsest_rays", std::int64_t{2048}, 1, 65536, {}, "rays of a gather on the coarsest level, where more than `rays`"},
      {"epsilon_E",
       0.04,
       0.0,
       largest,
       {},
       "receivers are refined where irradiance varies by more, share of the mean indirect irradiance"},
      {"epsilon_Omega", 0.3141592653589793, 0.0, 12.6, {}, "senders are evaluated down to balls of this solid angle, sr"},
      {"noise_guard",
       5.0,
       0.0,
       100.0,
       {},
       "standard deviations of the gathers that a difference must exceed to be refined; 0: the paper's oracle"},
      {"bounces", std::int64_t{100}, 1, 10000, {}, "most bounces that are computed"},
      {"residual", 1e-3, 1e-9, 1.0, {}, "the series ends when the bounces left out hold less, share of the solution"},
      {"extrapolate", true, 0, 0, {}, "add the bounces left out as a geometric series once they follow one"},
      {"first_bounce",
       std::string("automatic"),
       0,
       0,
       {"automatic", "exact", "basis"},
       "direct light at the hits of the first gathers: evaluated there, or from the basis; automatic goes by its noise"},
      {"direct",
       std::string("shared"),
       0,
       0,
       {"shared", "basis"},
       "direct light is answered by the shared evaluator, or from the basis"},
      {"direct_samples",
       std::int64_t{1},
       1,
       1024,
       {},
       "light samples at a hit of a first gather; more where direct light is noisy"},
      {"basis_direct_samples",
       std::int64_t{16},
       1,
       65536,
       {},
       "light samples at a basis point, for direct light in the basis; more where it is noisy"},
  };
}

Settings settings_from(const Parameters& parameters) {
  const auto whole = [&](const char* name) { return static_cast<int>(parameters.whole(name)); };
  Settings settings;
  settings.levels = whole("levels");
  settings.coarsest_samples = whole("coarsest_samples");
  settings.initial_radius = parameters.real("initial_radius");
  settings.failures = whole("failures");
  settings.backface_test = parameters.flag("backface_test");
  settings.backface_rays = whole("backface_rays");
  const std::string& groups = parameters.text("groups");
  settings.grouping = groups == "objects"      ? Grouping::objects
                      : groups == "components" ? Grouping::components
                                               : Grouping::automatic;
  settings.neighbours = whole("neighbours");
  settings.radius_limit = parameters.real("radius_limit");
  settings.corrections = whole("corrections");
  settings.rays = whole("rays");
  settings.coarsest_rays = whole("coarsest_rays");
  settings.epsilon_e = parameters.real("epsilon_E");
  settings.epsilon_omega = parameters.real("epsilon_Omega");
  settings.noise_guard = parameters.real("noise_guard");
  settings.bounces = whole("bounces");
  settings.residual = parameters.real("residual");
  settings.extrapolate = parameters.flag("extrapolate");
  const std::string& first_bounce = parameters.text("first_bounce");
  settings.first_bounce = first_bounce == "exact"   ? FirstBounce::exact
                          : first_bounce == "basis" ? FirstBounce::basis
                                                    : FirstBounce::automatic;
  settings.direct = parameters.text("direct") == "shared" ? DirectAnswer::shared : DirectAnswer::basis;
  settings.direct_samples = whole("direct_samples");
  settings.basis_direct_samples = whole("basis_direct_samples");
  return settings;
}

}  // namespace gibench::meshless
