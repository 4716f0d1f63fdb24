/// From the leaves to any point of the surfaces: values at the leaves' corners, interpolated.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "common/method/task.h"
#include "methods/wavelet/elements.h"

namespace gibench::wavelet {

/// Bilinear in quads, linear in triangles, continuous across the edges of elements where corners of leaves meet: leaves that
/// share an edge share its corners unless their normals are more than 40 degrees apart, or something stands on the edge. A corner
/// takes the value there of the plane that fits the leaves around it best; what the interpolated function then lacks of the
/// leaves' means is spread over their corners. Leaves without area take no part. (The text: textures with border texels,
/// section 5.4.)
class Reconstruction {
 public:
  Reconstruction() = default;
  /// `looks`: rays tell what stands on edges.
  Reconstruction(const World& world, const Elements& elements, bool looks, Task& task);

  std::vector<Rgb> corner_values(std::span<const Rgb> leaf_means) const;

  /// At a point of a leaf.
  Rgb at(const Elements& elements, std::span<const Rgb> corner_values, std::uint32_t leaf_node, const Vec3& point) const;

  std::size_t corners() const { return row_begin_.empty() ? 0 : row_begin_.size() - 1; }
  std::size_t bytes() const;

 private:
  class Maker;
  void add_what_lacks(std::span<const Rgb> leaf_means, std::vector<Rgb>& values) const;
  struct Weight {
    std::uint32_t leaf;
    float share;
  };

  std::vector<std::array<std::uint32_t, child_count>> corners_of_leaf_;  ///< a triangle repeats its third
  std::vector<std::uint32_t> row_begin_;
  std::vector<Weight> weights_;        ///< of the leaves in each corner's value
  std::vector<std::uint8_t> is_used_;  ///< leaves with area
};

}  // namespace gibench::wavelet
