/// The cells of space in which cameras, and diffuse reflections of what they see, find surfaces.
#pragma once

#include <cstdint>
#include <vector>

#include "common/ray/world.h"

namespace gibench {

/// A grid over what is found: 64 cells along its longest side. Says where it is worth looking for seen points; which points are
/// seen is asked point by point (CameraSight).
class SeenCells {
 public:
  /// Traces 128 × 128 rays from each camera and four cosine-distributed rays from each point that they meet; what lies between
  /// neighbouring points of a camera counts as found.
  explicit SeenCells(const World& world);

  /// Whether a cell that overlaps the box, or a neighbour of one, holds something found.
  bool overlap(const Vec3& low, const Vec3& high) const;
  float cell_size() const { return cell_size_; }  ///< metres; 0 where nothing was found

 private:
  struct Cell {
    int x, y, z;
  };
  Cell cell_of(const Vec3& position) const;
  void mark_around(const Cell& cell);
  bool is_marked(int x, int y, int z) const;

  Vec3 low_{0.0F};
  float cell_size_ = 0.0F;
  int nx_ = 0, ny_ = 0, nz_ = 0;
  std::vector<char> marked_;
};

}  // namespace gibench
