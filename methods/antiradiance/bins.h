/// Directional bins: the sphere in n² cells of one size, and the mask of bins that a direction belongs to.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/core/vec.h"

namespace gibench::antiradiance {

/// Numbers that light by direction has in each bin: one for each channel of a colour.
inline constexpr std::size_t channels = 3;

/// Shares of one direction in up to four bins, in units of 1/255: they sum to 255 exactly, so that no light is lost or made.
struct DirectionMask {
  std::array<std::uint8_t, 4> weights{};
};

/// The equal-area octahedral map (Clarberg 2008) of the sphere to the unit square, cut into n × n bins: n even. Bins are by
/// the way that light travels, in world directions: the same for every element, so that light passes through a
/// surface in its own bin, and hierarchies pull and push bin by bin.
class DirectionBins {
 public:
  explicit DirectionBins(int resolution);

  std::size_t count() const { return directions_.size(); }
  const Vec3& direction(std::size_t bin) const { return directions_[bin]; }
  float solid_angle() const { return 4.0F * pi / static_cast<float>(count()); }
  /// Cosine that a bin's light has at least to a surface in whose plane its middle lies: a third of the bin's radius.
  float least_cosine() const { return least_cosine_; }

  /// The four bins whose middles surround a direction, as one number, and the bilinear shares of each.
  struct Place {
    std::uint16_t quad = 0;
    std::array<float, 4> shares{};
  };
  Place place(const Vec3& direction) const;
  const std::array<std::uint16_t, 4>& bins_of(std::uint16_t quad) const { return quads_[quad]; }
  /// The bin that a direction lies in.
  std::uint16_t bin_of(const Vec3& direction) const { return bin_of(place(direction)); }
  std::uint16_t bin_of(const Place& place) const;

  /// The mask of a direction on the side of `normal` (times `sign`) that it lies on: bins whose middle lies on the other side
  /// get nothing.
  DirectionMask mask(const Place& place, const Vec3& normal, float sign) const;

 private:
  std::uint16_t bin_at(int column, int row) const;

  int resolution_;
  float least_cosine_;
  std::vector<Vec3> directions_;
  std::vector<std::array<std::uint16_t, 4>> quads_;
};

}  // namespace gibench::antiradiance
