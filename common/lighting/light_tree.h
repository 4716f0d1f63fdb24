/// A hierarchy of the lights that have a place: one of them is drawn by an estimate of what it gives at a surface point.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/core/vec.h"

namespace gibench {

/// A light, or several near each other, as the estimate knows them: a ball and what leaves it. The intensity in a unit
/// direction ω is max(0, directed · ω) + even, W/sr.
struct PlacedLight {
  Vec3 centre{0.0F};
  float radius = 0.0F;  ///< metres
  Vec3 directed{0.0F};
  float even = 0.0F;
};

/// Immutable. Nodes of eight children; all eight are estimated at once. The estimate is that of an unhidden light and a
/// surface that reflects evenly: intensity · cosine / distance². It may be zero where a light gives something, so that what
/// is drawn must have another way to be found (Veach 1997, section 9.2: a mixture).
class LightTree {
 public:
  LightTree() = default;
  explicit LightTree(std::span<const PlacedLight> lights);

  /// A light, and with which probability it is drawn.
  struct Choice {
    std::size_t light = 0;
    float probability = 0.0F;  ///< 0: the estimate leads to no light
    double rest = 0.0;         ///< where in the light's own share the fraction lies, in [0, 1)
  };
  /// The light that `fraction`, in [0, 1), falls on at a surface point with this unit normal.
  Choice choose(const Vec3& position, const Vec3& normal, double fraction) const;
  /// With which probability choose() gives this light there.
  float probability(std::size_t light, const Vec3& position, const Vec3& normal) const;

  std::size_t bytes() const { return nodes_.capacity() * sizeof(Node) + place_of_light_.capacity() * sizeof(Place); }

 private:
  static constexpr std::size_t width = 8;
  /// Children in columns; unused ones give nothing.
  struct Node {
    std::array<float, width> x{}, y{}, z{}, radius{}, directed_x{}, directed_y{}, directed_z{}, strength{}, even{};
    std::array<std::uint32_t, width> child{};  ///< a node, or in the last level a light
    bool last = false;
  };
  /// A child of a node.
  struct Place {
    std::uint32_t node = 0, slot = 0;
  };

  class Builder;
  static std::array<float, width> estimates(const Node& node, const Vec3& position, const Vec3& normal);

  std::vector<Node> nodes_;            ///< the root first
  std::vector<Place> place_of_light_;  ///< by light
  std::vector<Place> place_of_node_;   ///< by node; of the root unused
};

}  // namespace gibench
