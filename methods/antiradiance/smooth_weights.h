/// The weights by which values of merged elements are blended into values at the mesh's vertices.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "methods/antiradiance/elements.h"
#include "methods/antiradiance/hierarchy.h"

namespace gibench::antiradiance {

/// Around its middle each element has a hill as long and as wide as its cell; a vertex takes the mean of the elements on whose
/// hills it stands, by their heights there (Shepard). It takes nothing from elements of another sheet, of the other
/// kind (sealed or not), that face another way, or that stand behind something higher than a disc is wide.
class SmoothWeights {
 public:
  SmoothWeights() = default;
  SmoothWeights(const World& world, const SamplingMesh& mesh, const Elements& elements, const Hierarchy& hierarchy, Task& task);

  /// Values at the vertices whose means over the elements' cells are close to `means`: blended, and then twice what the means
  /// of that lack. No less than nothing where the means are not, nor turned in sign.
  std::vector<Rgb> vertex_values(std::span<const Rgb> means) const;

  std::size_t bytes() const {
    return row_begin_.capacity() * sizeof(std::uint32_t) + entries_.capacity() * sizeof(Entry) +
           areas_.capacity() * sizeof(float) + own_.capacity() * sizeof(std::uint32_t);
  }

 private:
  struct Entry {
    std::uint32_t element;
    float weight;
  };
  class Maker;
  void add_blended(std::span<const Rgb> of_elements, std::vector<Rgb>& values) const;

  std::vector<std::uint32_t> row_begin_;  ///< of every vertex, and the end
  std::vector<Entry> entries_;
  std::vector<float> areas_;        ///< of the vertices, share of their elements'
  std::vector<std::uint32_t> own_;  ///< elements of the vertices
};

}  // namespace gibench::antiradiance
