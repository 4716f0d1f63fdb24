#include "methods/spectral/transfer.h"

#include <algorithm>

namespace gibench::spectral {

VertexRays rays_of(const World& world, const Transfer& transfer, int rays, std::uint64_t seed) {
  return {world, *transfer.mesh, transfer.interpolation, transfer.nodes, transfer.weights, rays, seed};
}

bool is_whole_block_of_glossy(std::span<const std::uint32_t> glossy_row, std::size_t begin, std::size_t end) {
  return begin % block_rows == 0 && end == begin + block_rows &&
         std::none_of(glossy_row.begin() + static_cast<std::ptrdiff_t>(begin),
                      glossy_row.begin() + static_cast<std::ptrdiff_t>(end),
                      [](std::uint32_t row) { return row == Transfer::no_row; });
}

std::size_t Transfer::bytes() const {
  if (!mesh) return 0;
  std::size_t bytes = mesh->bytes() + interpolation.bytes() + nodes.bytes() + weights.bytes() + basis.bytes() +
                      one_bounce.bytes() +
                      (node_of_slot.size() + glossy_slots.size() + glossy_row.size()) * sizeof(std::uint32_t);
  for (const TransferMatrix& matrix : all_bounces) bytes += matrix.bytes();
  for (const std::vector<float>& matrix : all_light) bytes += matrix.size() * sizeof(float);
  for (const TransferMatrix& matrix : harmonic_slices) bytes += matrix.bytes();
  return bytes;
}

}  // namespace gibench::spectral
