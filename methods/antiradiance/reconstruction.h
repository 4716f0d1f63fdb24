/// From the elements to any point of the surfaces: values at the vertices that have the elements' means, interpolated.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "methods/antiradiance/elements.h"

namespace gibench::antiradiance {

/// Linear over the mesh's triangles, elements inside geometry left out: continuous, and nothing leaks from one object or from
/// one side of a crease to another. An element's value is its cell's mean. Where the cell surrounds the vertex it is the
/// vertex's value as well; at borders and creases it is that of a point further in, so that there the vertex's value is
/// made such that the interpolated function has the cell's mean.
class Reconstruction {
 public:
  Reconstruction() = default;
  /// Neither argument is kept.
  Reconstruction(const World& world, const SamplingMesh& mesh, const Elements& elements);

  /// Values at the vertices from the elements' means (both one for each vertex); raised at most twofold, not turned in sign.
  std::vector<Rgb> vertex_values(std::span<const Rgb> means) const;

  std::size_t bytes() const { return rows_.capacity() * sizeof(Row) + weights_.capacity() * sizeof(Weight); }

  /// The mesh's corners and their weights at a sample; all weights zero where there is nothing to interpolate.
  struct Place {
    std::array<std::uint32_t, 3> elements{};
    std::array<float, 3> weights{};
    bool in_doubt = false;  ///< an element here reaches inside geometry: so may the sample
  };
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
};

}  // namespace gibench::antiradiance
