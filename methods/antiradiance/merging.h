/// The merging of discs: which vertices of the mesh share an element.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/sampling_mesh.h"
#include "common/method/task.h"

namespace gibench::antiradiance {

/// Where the scene's light gets to.
enum class Reached : std::uint8_t {
  front,    ///< the side that the element is on
  back,     ///< only the black back of a one-sided surface, where that is of any account
  nowhere,  ///< next to none gets to either: the inside of walls
};

/// Elements by vertex. Where nothing is merged all is empty: each vertex has an element of its own.
struct Merging {
  std::size_t elements = 0;
  std::vector<std::uint32_t> of_vertex;
  std::vector<Reached> reached;  ///< of the elements

  bool merges() const { return !of_vertex.empty(); }
};

/// Merges the mesh's vertices into about `wanted` discs. Vertices share one only where they are of one object (of one material,
/// where there are more objects than discs enough for them) and one side of it, where light reaches the same sides of both, where
/// their normals differ by no more than a bound, and where no surface higher than the disc is wide stands between them. What
/// no light reaches gets few.
/// `backs_count`: light at black backs is of account, as where negative light is sent.
Merging merge_discs(const World& world, const SamplingMesh& mesh, std::size_t wanted, bool backs_count, Task& task);

}  // namespace gibench::antiradiance
