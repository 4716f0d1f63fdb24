/// The parameters of wavelet radiance transport, with the names of Kontkanen, Turquin, Holzschuch, Sillion 2006.
#pragma once

#include "common/method/parameters.h"
#include "common/method/presets.h"

namespace gibench::wavelet {

/// How the kernel between two nodes is integrated.
enum class KernelForm {
  polygons,  ///< form factors in closed form times sampled visibility
  samples    ///< the text's: V cos cos / (π r²) at pairs of points, and its oracle on these
};
/// How the direct operator's coefficients are held.
enum class Precision { bits16, bits32 };
/// What computes the bounces.
enum class Mode {
  solve,    ///< the direct operator, bounce by bounce, whenever the lights change
  global,   ///< the global operator, made once (section 4.4)
  gathered  ///< the direct operator times the series: a final gather at its resolution (section 4.4)
};

/// Each member is initialised with the default of its parameter.
struct Settings {
  // Elements.
  int leaves = 6000;  ///< of all quadtrees, about
  bool cuts = true;
  int exposure_rays = 4;  ///< from each of a leaf's 16 points
  // Direct transport operator (section 4.3).
  KernelForm kernel = KernelForm::polygons;
  double sender_threshold = 1e-3;    ///< ε_s
  double receiver_threshold = 1e-3;  ///< ε_r
  int rays = 16;                     ///< of a pair of leaves
  int closure_rays = 64;             ///< from a leaf
  double compression = 1e-4;         ///< links without a larger coefficient are left out
  Precision precision = Precision::bits16;
  double memory_budget = 2000.0;  ///< MB
  // Global transport operator (section 4.4).
  Mode mode = Mode::solve;
  double series_threshold = 1e-4;  ///< links of a power without a larger coefficient are left out
  int powers = 100;                ///< of the direct operator, at most
  // Light.
  int bounces = 1000;       ///< most bounces computed
  double residual = 1e-3;   ///< share of the solution that the bounces left out may hold
  int direct_points = 4;    ///< of a leaf, where its direct light is taken
  int direct_samples = 64;  ///< light samples at such a point; what comes from points and in one direction takes one ray
};

ParameterSchema settings_schema();
std::vector<Preset> presets();
Settings settings_from(const Parameters& parameters);

}  // namespace gibench::wavelet
