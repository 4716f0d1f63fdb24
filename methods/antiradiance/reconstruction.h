/// From the elements to any point of the surfaces: values at the vertices that have the elements' means, interpolated.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "methods/antiradiance/elements.h"
#include "methods/antiradiance/smooth_weights.h"

namespace gibench::antiradiance {

/// Linear over the mesh's triangles, elements inside geometry left out: continuous, and nothing leaks from one object or from
/// one side of a crease to another. An element's value is its cell's mean. Where the cell surrounds the vertex it is the
/// vertex's value as well; at borders and creases it is that of a point further in, so that there the vertex's value is
/// made such that the interpolated function has the cell's mean. The vertices of merged elements are blended (smooth_weights.h).
class Reconstruction {
 public:
  Reconstruction() = default;
  /// No argument is kept. `parted_triangles`: see parted_triangles.h; empty: none.
  Reconstruction(const World& world, const SamplingMesh& mesh, const Elements& elements, const Hierarchy& hierarchy,
                 std::span<const std::uint8_t> parted_triangles, Task& task);

  /// Values at the vertices from the elements' means; raised at most twofold, not turned in sign.
  std::vector<Rgb> vertex_values(std::span<const Rgb> means) const;

  std::size_t bytes() const {
    return rows_.capacity() * sizeof(Row) + weights_.capacity() * sizeof(Weight) + (smooth_ ? smooth_->bytes() : 0);
  }

  /// The mesh's corners and their weights at a sample; all weights zero where there is nothing to interpolate.
  struct Place {
    std::array<std::uint32_t, 3> vertices{};
    std::array<float, 3> weights{};
    std::uint32_t triangle = 0;  ///< of the mesh
    bool in_doubt = false;       ///< an element here reaches inside geometry: so may the sample
    bool covered() const { return weights[0] + weights[1] + weights[2] > 0.0F; }
  };
  /// Takes the elements (or of merged ones the corners) out of a place that another surface hides from the sample; leaves all
  /// where it hides all, and returns false.
  static bool leave_hidden_out(const World& world, const SamplingMesh& mesh, const Elements& elements,
                               const SurfaceSample& sample, RayStream& rays, Place& place);
  /// The heaviest corner (0, 1 or 2) of a place that no other surface hides from the sample; none where all are hidden.
  static std::optional<std::size_t> heaviest_seen(const World& world, const SamplingMesh& mesh, const Elements& elements,
                                                  const SurfaceSample& sample, RayStream& rays, Place place);
  static Place place(const World& world, const SamplingMesh& mesh, const Elements& elements, const SurfaceSample& sample);

 private:
  struct Weight {
    std::uint32_t element;
    float share;
  };
  struct Row {
    std::uint32_t element, begin, end;
    float own;
  };

  std::vector<Row> rows_;  ///< of the elements beside their vertex
  std::vector<Weight> weights_;
  std::optional<SmoothWeights> smooth_;  ///< of merged elements
};

}  // namespace gibench::antiradiance
