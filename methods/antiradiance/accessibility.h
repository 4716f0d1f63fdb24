/// Accessibility in passes (Bunnell 2005): what of a hemisphere no element blocks, double shadows taken back pass by pass.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "common/method/task.h"
#include "methods/antiradiance/bins.h"
#include "methods/antiradiance/elements.h"
#include "methods/antiradiance/hierarchy.h"

namespace gibench::antiradiance {

/// What of the light from outside reaches elements, sector of directions by sector.
class Accessibility {
 public:
  /// `far_enough`: a node whose form factor to the receiver is smaller stands for its elements; 0: every element by itself.
  /// `sectors`: n × n sectors of the sphere (n even); 1: one for the front and one for the back, as Bunnell has it.
  /// The elements and the hierarchy must outlive this object.
  Accessibility(const Elements& elements, const Hierarchy& hierarchy, float far_enough, int sectors = 1);

  /// Makes ready for answers of so many passes. In the first, whatever is in the way blocks; every further one scales each
  /// blocker by the accessibility that the pass before gave the side of it that looks away from the receiver, in the sector that
  /// the light would come from: light that does not reach a blocker is not blocked by it.
  void compute(int passes, Task& task);

  /// At a point with a unit normal: the mean of what the last two passes find (of one pass, that alone); `own` is left out
  /// (no_element: none). `open`, one for each sector or empty: how much of the hemisphere is open, sector by sector, each
  /// between nothing and all that the sector fills of it.
  float at(const Vec3& point, const Vec3& normal, std::uint32_t own = no_element, std::span<float> open = {}) const;

  /// By where light comes from; none where a side is one sector.
  const DirectionBins* sectors() const { return bins_ ? &*bins_ : nullptr; }
  /// Blockers looked at in all passes of compute().
  std::uint64_t evaluations() const { return evaluations_; }
  std::size_t bytes() const { return (before_.capacity() + last_.capacity()) * sizeof(float); }

 private:
  /// Some sectors and how much of a direction is in each.
  struct Sectors {
    std::array<std::uint16_t, 4> index{};
    std::array<float, 4> share{};
  };
  /// What blocks a side of a surface, sector by sector, shares of the hemisphere.
  class Blocked;
  struct Receiver {
    Vec3 point, normal;
    float side = 1.0F;  ///< of the normal that looks around: ±1
    std::uint32_t own = no_element;
    Vec3 looks() const { return normal * side; }
  };
  /// Of a direction, on the front or the back of a surface with this normal.
  Sectors sectors_of(const DirectionBins::Place& around, bool front, const Vec3& normal) const;
  /// What of every sector a side of a surface sees, share of the hemisphere.
  void side_shares(const Vec3& normal, std::span<float> shares) const;
  void block(const Receiver& receiver, Blocked& blocked) const;
  void block_by_tree(std::uint32_t root, const Receiver& receiver, Blocked& blocked) const;
  void block_by_cell(std::uint32_t leaf, const Receiver& receiver, Blocked& blocked) const;
  void block_by_points(std::uint32_t leaf, const Receiver& receiver, Blocked& blocked) const;
  void add(float form_factor, const Vec3& direction, std::uint32_t blocker, const Receiver& receiver, Blocked& blocked) const;
  std::vector<float> pulled(std::span<const float> leaves) const;

  const Elements& elements_;
  const Hierarchy& hierarchy_;
  float far_enough_;
  std::optional<DirectionBins> bins_;  ///< by where light comes from; none: the sides are the sectors
  std::size_t sectors_;
  bool blends_ = false;               ///< there is a pass before the last
  std::vector<float> before_, last_;  ///< that the last two passes scale the nodes by, rows of sectors, [0, 1]; empty: one
  std::uint64_t evaluations_ = 0;
};

}  // namespace gibench::antiradiance
