/// Transport of diffuse light between elements over the links: push-pull on one value per node and side.
#pragma once

#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "common/method/task.h"
#include "methods/antiradiance/hierarchy.h"
#include "methods/antiradiance/links.h"

namespace gibench::antiradiance {

/// E_i = s_i Σ F_ij B_j: what arrives on the fronts of the leaves.
class PatchTransport {
 public:
  PatchTransport(const Hierarchy& hierarchy, const LinkTable& links) : hierarchy_(hierarchy), links_(links) {}

  /// From radiosities of the leaves, W/m²: `fronts`, and `backs` (empty: black). `arriving`: irradiance, W/m².
  void transport(std::span<const Rgb> fronts, std::span<const Rgb> backs, std::span<Rgb> arriving, Task& task) const;

 private:
  const Hierarchy& hierarchy_;
  const LinkTable& links_;
};

/// What each leaf's sum of form factors is to be multiplied by: to what `closed` says (empty: to one at most). `sums`: the
/// irradiance under radiosity 1 everywhere. Never raised by more than a half: what no link reaches stays dark.
std::vector<float> normalisation(std::span<const float> sums, std::span<const float> closed);

}  // namespace gibench::antiradiance
