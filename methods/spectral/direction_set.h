/// Cosine-distributed directions, one set for all vertices, turned for each.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/core/vec.h"

namespace gibench::spectral {

/// So many directions as are traced together, in columns.
struct DirectionBatch {
  static constexpr std::size_t capacity = 256;
  alignas(32) std::array<float, capacity> x, y, z;
  std::size_t count = 0;

  Vec3 direction(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// One low-discrepancy set for all vertices (an Owen-scrambled Sobol net), each of which turns it about the normal and shifts
/// it in elevation (Cranley and Patterson 1976). Neighbours in the square stand next to one another, so that rays traced
/// together run together.
class DirectionSet {
 public:
  /// A vertex's shift in elevation, and its frame with the turn about the normal in it.
  struct Turn {
    float shift;
    Vec3 tangent, bitangent, normal;
  };

  DirectionSet() = default;
  DirectionSet(int rays, std::uint64_t seed);

  std::size_t size() const { return elevation_.size(); }
  static Turn turn(std::uint64_t seed, std::uint32_t vertex, const Vec3& normal);
  /// Unit directions from place `begin` of the set on, a batch or as many as are left.
  void directions(const Turn& turn, std::size_t begin, DirectionBatch& batch) const;
  /// Those at the given places, no more than a batch.
  void directions(const Turn& turn, std::span<const std::uint32_t> places, DirectionBatch& batch) const;

 private:
  std::vector<float> elevation_, cosine_, sine_;  // squared radius in the disc, and the azimuth's
};

}  // namespace gibench::spectral
