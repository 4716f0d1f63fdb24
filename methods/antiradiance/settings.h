/// The parameters of the disc-element methods.
#pragma once

#include "common/method/parameters.h"

namespace gibench::antiradiance {

enum class Mode { accessibility, disc_bounce, radiosity, implicit, antiradiance };
enum class OracleKind { geometry, radiosity };
/// Which of the senders in a bin of implicit visibility stays: the nearest of those across the bin's middle, or of all whose
/// links point into it, however little of the bin they fill.
enum class BinWinner { middle, links };

struct Settings {
  Mode mode = Mode::antiradiance;
  // Elements.
  int elements = 0;          ///< wanted
  float crease_degrees = 0;  ///< vertices are split where faces turn by more
  int cell_points = 0;       ///< points of a cell, for rays and near form factors
  int backface_rays = 0;     ///< all must meet backs for a point to count as inside geometry
  bool near_cells = true;    ///< elements that nearly touch exchange light as cells, not as discs
  // Links.
  OracleKind oracle = OracleKind::geometry;
  float tolerance = 0;
  int visibility_rays = 0;  ///< a link, in radiosity mode
  int closure_rays = 0;     ///< an element; 0: form factors are only kept from summing to more than one
  int bins = 0;             ///< along a side of the square that the sphere is mapped to
  BinWinner bin_winner = BinWinner::middle;
  // Iteration.
  double residual = 0;
  int most_iterations = 0;
  int iterations = 0;  ///< exactly so many; 0: until the residual has fallen
  bool clamp = true;   ///< no negative light in answers
  int direct_samples = 0;
  // Passes of accessibility and disc-bounce.
  int passes = 0;
  int sectors = 1;           ///< along a side of the map of the sphere; 1: front and back
  float far_enough = 0;      ///< largest form factor of a node that stands for its elements; 0: every element (naive)
  double memory_budget = 0;  ///< bytes
};

ParameterSchema settings_schema();
Settings settings_from(const Parameters& parameters);

}  // namespace gibench::antiradiance
