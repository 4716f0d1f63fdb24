/// Accessibility in passes (Bunnell 2005): what of a hemisphere no element blocks, double shadows taken back pass by pass.
#pragma once

#include <vector>

#include "common/method/task.h"
#include "methods/antiradiance/elements.h"
#include "methods/antiradiance/hierarchy.h"

namespace gibench::antiradiance {

/// Shares of light from outside that reach an element's front and its back, [0, 1].
struct TwoSides {
  float front = 1.0F, back = 1.0F;
};

class Accessibility {
 public:
  /// `far_enough`: a node whose form factor to the receiver is smaller stands for its elements; 0: every element by itself.
  /// The elements and the hierarchy must outlive this object.
  Accessibility(const Elements& elements, const Hierarchy& hierarchy, float far_enough)
      : elements_(elements), hierarchy_(hierarchy), far_enough_(far_enough) {}

  /// Every pass takes off what blocks, each blocker scaled by the accessibility that the pass before gave the side of it that
  /// looks away from the receiver: light that does not reach a blocker is not blocked by it. The last two passes are averaged.
  void compute(int passes, Task& task);

  /// At a point with a unit normal, from what the passes found; `own` is left out (no_element: none).
  float at(const Vec3& point, const Vec3& normal, std::uint32_t own = no_element) const;

  const std::vector<TwoSides>& of_leaves() const { return leaves_; }
  /// Blockers looked at in all passes.
  std::uint64_t evaluations() const { return evaluations_; }
  std::size_t bytes() const { return (leaves_.capacity() + nodes_.capacity()) * sizeof(TwoSides); }

 private:
  struct Blocked {
    float share = 0.0F;
    std::uint64_t evaluations = 0;
  };
  Blocked blocked(const Vec3& point, const Vec3& normal, std::uint32_t own) const;
  float leaf_form_factor(const Node& leaf, const Vec3& point, const Vec3& normal) const;
  void pull();

  const Elements& elements_;
  const Hierarchy& hierarchy_;
  float far_enough_;
  std::vector<TwoSides> leaves_, nodes_;
  std::uint64_t evaluations_ = 0;
};

}  // namespace gibench::antiradiance
