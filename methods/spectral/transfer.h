/// Mesh, basis and transfer matrices, which depend on the geometry only.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "methods/spectral/basis.h"
#include "methods/spectral/interpolation.h"
#include "methods/spectral/node_weights.h"
#include "methods/spectral/transfer_matrix.h"
#include "methods/spectral/vertex_rays.h"

namespace gibench::spectral {

struct Transfer {
  static constexpr std::uint32_t no_row = 0xffffffffU;

  std::unique_ptr<SamplingMesh> mesh;  ///< empty: nothing was called for
  Interpolation interpolation;
  Nodes nodes;
  std::vector<std::uint32_t> node_of_slot;
  NodeWeights weights;  ///< of the slots, by vertex of the mesh
  SpectralBasis basis;
  TransferMatrix one_bounce;                    ///< T^s, one row for each slot
  std::vector<TransferMatrix> all_bounces;      ///< T* in mode fixed_albedo: one, or one per channel
  std::vector<std::vector<float>> all_light;    ///< G of T* = T^s G, as many, dense, where there are slices
  std::vector<std::uint32_t> glossy_slots;      ///< the slots that have harmonic slices, row by row, whole blocks first
  std::vector<std::uint32_t> glossy_row;        ///< of every slot: its row in the slices, or no_row
  std::vector<TransferMatrix> harmonic_slices;  ///< T_k^s, k = 1…15; that of the constant harmonic is T^s times it

  const Node& node_at(std::size_t slot) const { return nodes[node_of_slot[slot]]; }
  std::size_t bytes() const;
};

/// Whether slots [begin, end) are a block of rows, all with slices.
bool is_whole_block_of_glossy(std::span<const std::uint32_t> glossy_row, std::size_t begin, std::size_t end);

/// The rays of the transfer's nodes. It must stay where it is.
VertexRays rays_of(const World& world, const Transfer& transfer, int rays, std::uint64_t seed);

}  // namespace gibench::spectral
