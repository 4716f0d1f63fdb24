/// Accessibility in passes (Bunnell 2005): what of a hemisphere no element blocks, double shadows taken back pass by pass.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
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

  /// Every pass takes off what blocks, each blocker scaled by the accessibility that the pass before gave the side of it that
  /// looks away from the receiver, in the sector that the light would come from: light that does not reach a blocker is not
  /// blocked by it. The last two passes are averaged.
  void compute(int passes, Task& task);

  /// At a point with a unit normal, from what the passes found; `own` is left out (no_element: none).
  float at(const Vec3& point, const Vec3& normal, std::uint32_t own = no_element) const;

  /// Of a leaf's front or back, all sectors together, [0, 1].
  float of_side(std::size_t leaf, bool front) const;
  /// Blockers looked at in all passes.
  std::uint64_t evaluations() const { return evaluations_; }
  std::size_t bytes() const { return (leaves_.capacity() + nodes_.capacity()) * sizeof(float); }

 private:
  /// Some sectors and how much of a direction is in each.
  struct Sectors {
    std::array<std::uint16_t, 4> index{};
    std::array<float, 4> share{};
  };
  /// What blocks a side of a surface, sector by sector, shares of the hemisphere.
  struct Blocked {
    explicit Blocked(std::size_t sectors) : scaled(sectors), most(sectors), sheet{scaled, scaled} {}
    std::vector<float> scaled;                ///< each blocker by its accessibility
    std::vector<float> most;                  ///< the most that one sheet blocks, whatever lies behind it
    std::array<std::vector<float>, 2> sheet;  ///< that is being looked at: what of it shows its front, and its back
    std::uint64_t evaluations = 0;
    void start();
    void end_sheet();
  };
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
  void block_by_cell(const Node& leaf, const float* accessible, const Receiver& receiver, Blocked& blocked) const;
  void add(float form_factor, const Vec3& direction, const Vec3& blocker, const float* accessible, const Receiver& receiver,
           Blocked& blocked) const;
  /// Of one sector: no less than one sheet by itself blocks. Sides alone are taken as in the text.
  float of_sector(const Blocked& blocked, std::size_t s) const {
    return bins_ ? std::max(blocked.scaled[s], blocked.most[s]) : blocked.scaled[s];
  }
  void pull();

  const Elements& elements_;
  const Hierarchy& hierarchy_;
  float far_enough_;
  std::optional<DirectionBins> bins_;  ///< by where light comes from; none: the sides are the sectors
  std::size_t sectors_;
  std::vector<float> leaves_, nodes_;  ///< rows of accessibilities, [0, 1]
  std::uint64_t evaluations_ = 0;
};

}  // namespace gibench::antiradiance
