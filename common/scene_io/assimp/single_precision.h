/// Models so far from their origin that the single precision of their vertices shows.
#pragma once

#include <string>
#include <vector>

#include "common/scene/scene_assembler.h"

namespace gibench {

/// Compares the distance of neighbouring numbers where a mesh lies with the mean length of its edges: rounding moves a
/// vertex by half of it, so that above a thousandth, edges turn by more than about half a milliradian.
class LostPrecision {
 public:
  /// A mesh in its own coordinates, which are those that are rounded.
  void add(const ObjectGeometry& mesh);

  /// One warning, of the mesh that suffers most, where one does.
  void warn(const std::string& file, std::vector<std::string>& warnings) const;

 private:
  double worst_ = 0.0;  // of a mean edge
};

}  // namespace gibench
