#include "methods/spectral/slot_order.h"

#include <algorithm>
#include <limits>
#include <span>
#include <tuple>

namespace gibench::spectral {

namespace {

class Halving {
 public:
  Halving(const SamplingMesh& mesh, std::size_t block) : mesh_(mesh), block_(block) {}

  /// `first`: the slot that the vertices begin at.
  void sort(std::span<std::uint32_t> vertices, std::size_t first) const {
    if (vertices.size() <= 1) return;
    const int axis = longest_side(vertices);
    const auto key = [&](std::uint32_t vertex) {
      const Vec3& p = mesh_.vertices()[vertex].position;
      return std::tuple(p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3], vertex);
    };
    const std::size_t left = size_of_left(vertices.size(), first);
    std::nth_element(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(left), vertices.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    sort(vertices.first(left), first);
    sort(vertices.subspan(left), first + left);
  }

 private:
  int longest_side(std::span<const std::uint32_t> vertices) const {
    Vec3 low(std::numeric_limits<float>::max()), high(-std::numeric_limits<float>::max());
    for (const std::uint32_t vertex : vertices) {
      low = glm::min(low, mesh_.vertices()[vertex].position);
      high = glm::max(high, mesh_.vertices()[vertex].position);
    }
    const Vec3 side = high - low;
    return side.x >= side.y && side.x >= side.z ? 0 : side.y >= side.z ? 1 : 2;
  }

  /// Half of them, or as near to it as a block ends.
  std::size_t size_of_left(std::size_t size, std::size_t first) const {
    const std::size_t half = size / 2, end = (first + half + block_ / 2) / block_ * block_;
    return end > first && end < first + size ? end - first : half;
  }

  const SamplingMesh& mesh_;
  std::size_t block_;
};

}  // namespace

void put_neighbours_together(const SamplingMesh& mesh, std::size_t block, Partition& partition) {
  const Halving halving(mesh, block);
  for (std::size_t part = 0; part < partition.parts(); ++part)
    halving.sort(std::span(partition.order).subspan(partition.part_begin[part], partition.part_size(part)),
                 partition.part_begin[part]);
}

}  // namespace gibench::spectral
