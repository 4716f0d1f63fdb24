#include "methods/spectral/transfer.h"

namespace gibench::spectral {

VertexRays rays_of(const World& world, const Transfer& transfer, int rays, std::uint64_t seed) {
  return {world, *transfer.mesh, transfer.interpolation, transfer.nodes, transfer.weights, rays, seed};
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
