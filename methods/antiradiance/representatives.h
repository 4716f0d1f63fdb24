/// A few vertices of each element that stand for the others where rays are traced, so that finer faces cost no more rays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/finite_elements/grouped.h"
#include "common/geometry/sampling_mesh.h"
#include "common/method/task.h"

namespace gibench::antiradiance {

/// Of each element at most so many vertices, spread over its cell; every vertex has the one nearest to it. Those of an element of
/// few vertices stand for themselves.
class Representatives {
 public:
  Representatives(const SamplingMesh& mesh, const Grouped& members, Task& task);

  /// Of an element.
  std::span<const std::uint32_t> of(std::size_t element) const { return of_element_.of(element); }
  /// Of a vertex.
  std::uint32_t of_vertex(std::uint32_t vertex) const { return of_vertex_[vertex]; }

 private:
  struct Chosen {
    std::vector<std::uint32_t> begin, vertices;
    std::span<const std::uint32_t> of(std::size_t element) const {
      return std::span(vertices).subspan(begin[element], begin[element + 1] - begin[element]);
    }
  };

  Chosen of_element_;
  std::vector<std::uint32_t> of_vertex_;
};

}  // namespace gibench::antiradiance
