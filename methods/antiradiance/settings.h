/// The parameters of the disc-element methods.
#pragma once

#include "common/method/parameters.h"

namespace gibench::antiradiance {

enum class Mode { accessibility, disc_bounce, radiosity, implicit, antiradiance };
enum class OracleKind { geometry, radiosity };
/// Which of the senders in a bin of implicit visibility stays: the nearest of those across the bin's middle, or of all whose
/// links point into it, however little of the bin they fill.
enum class BinWinner { middle, links };

/// Each member is initialised with the default of its parameter.
struct Settings {
  Mode mode = Mode::antiradiance;
  // Elements.
  int elements = 0;           ///< wanted; 0: as many as the scene needs
  bool merge = true;          ///< where the scene's own vertices are many more than `elements`
  float crease_degrees = 40;  ///< vertices are split where faces turn by more
  int cell_points = 16;       ///< points of a cell, for rays and near form factors
  int backface_rays = 64;     ///< all must meet backs for a point to count as inside geometry
  bool near_cells = true;     ///< elements that nearly touch exchange light as cells, not as discs
  // Links.
  OracleKind oracle = OracleKind::geometry;
  float tolerance = 0.01F;
  int visibility_rays = 4;    ///< a link, in radiosity mode
  bool split_partial = true;  ///< links that rays find free in part are taken apart, in radiosity mode
  int closure_rays = 256;     ///< an element; 0: form factors are only kept from summing to more than one
  int bins = 12;              ///< along a side of the square that the sphere is mapped to
  BinWinner bin_winner = BinWinner::middle;
  // Iteration.
  double residual = 1e-4;
  int most_iterations = 200;
  int iterations = 0;  ///< exactly so many; 0: until the residual has fallen
  bool clamp = true;   ///< no negative light in answers
  int direct_samples = 4;
  // Passes of accessibility and disc-bounce.
  int passes = 3;               ///< the last two are blended; 2 in the text
  int sectors = 8;              ///< along a side of the map of the sphere; 1: front and back
  float far_enough = 0.02F;     ///< largest form factor of a node that stands for its elements; 0: every element (naive)
  double memory_budget = 2048;  ///< MiB

  double bytes_at_most() const { return memory_budget * 1024.0 * 1024.0; }
};

ParameterSchema settings_schema();
Settings settings_from(const Parameters& parameters);

}  // namespace gibench::antiradiance
