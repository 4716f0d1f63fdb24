/// The making of mesh, basis and transfer matrices.
#pragma once

#include <string>
#include <vector>

#include "common/method/stage_report.h"
#include "methods/spectral/settings.h"
#include "methods/spectral/transfer.h"

namespace gibench::spectral {

/// What prepare() is to make, in addition to the settings.
struct TransferWish {
  std::vector<bool> glossy_objects;  ///< whose vertices get harmonic slices; empty: none
  std::vector<Rgb4> reflectance;     ///< ρ/π of every object, 1/sr; for T*
  int most_bounces = 0;              ///< in T*
  bool occlusion = true;             ///< surfaces may hide one another; false: no visibility ray is traced
};

struct TransferMaking {
  Transfer transfer;
  Termination termination = Termination::done;
  std::string message;
};

/// Counts parts, vertices, functions, coefficients and bytes in the task.
TransferMaking make_transfer(const World& world, const Settings& settings, const TransferWish& wish, Task& task);

}  // namespace gibench::spectral
