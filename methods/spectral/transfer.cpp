#include "methods/spectral/transfer.h"

namespace gibench::spectral {

double Transfer::area_of(std::size_t slot) const { return static_cast<double>(mesh->vertices()[vertex_of_slot[slot]].area); }

VertexRays rays_of(const World& world, const Transfer& transfer, int rays, std::uint64_t seed) {
  return {world, *transfer.mesh, transfer.interpolation, transfer.slot_of_vertex, rays, seed};
}

std::size_t Transfer::bytes() const {
  if (!mesh) return 0;
  std::size_t bytes =
      mesh->bytes() + interpolation.bytes() + basis.bytes() + one_bounce.bytes() +
      (vertex_of_slot.size() + slot_of_vertex.size() + glossy_slots.size() + glossy_row.size()) * sizeof(std::uint32_t);
  for (const TransferMatrix& matrix : all_bounces) bytes += matrix.bytes();
  for (const std::vector<float>& matrix : all_light) bytes += matrix.size() * sizeof(float);
  for (const TransferMatrix& matrix : harmonic_slices) bytes += matrix.bytes();
  return bytes;
}

}  // namespace gibench::spectral
