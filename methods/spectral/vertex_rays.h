/// The rays of a vertex, and what they meet in terms of the mesh's vertices.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "methods/spectral/direction_set.h"
#include "methods/spectral/interpolation.h"

namespace gibench::spectral {

/// One ray that met the mesh: the three slots of its hit and their weights, and where it came from.
struct MeshHit {
  std::array<std::uint32_t, 3> slots;
  std::array<float, 3> weights;  ///< with the ray's own weight in them: π / rays
  Vec3 direction;                ///< unit, from the vertex, in the world's frame
};

/// Traces the rays of vertices, one after the other.
class VertexRays {
 public:
  /// `slot_of_vertex`: where the vertices of the mesh keep their values.
  VertexRays(const World& world, const SamplingMesh& mesh, const Interpolation& interpolation,
             std::span<const std::uint32_t> slot_of_vertex, int rays, std::uint64_t seed);

  /// Hands over, batch by batch, what the rays of a vertex of the mesh meet: E = Σ over hits of weights · radiance at slots,
  /// W/m², for light that leaves lit sides. Rays that leave the scene or meet backs bring nothing.
  void trace(std::uint32_t vertex, RayStream& rays, const std::function<void(std::span<const MeshHit>)>& take) const;

 private:
  struct Leaving;
  /// What a batch met, in columns.
  struct Met;
  /// Of a mesh triangle.
  struct Corners {
    std::array<std::uint32_t, 3> slots;
    std::uint32_t torn;
  };

  std::vector<Leaving> leaving(std::uint32_t vertex) const;
  std::size_t meet(const DirectionBatch& batch, const Met& met, float ray_weight, RayStream& rays, MeshHit* hits) const;

  const World& world_;
  const SamplingMesh& mesh_;
  const Interpolation& interpolation_;
  DirectionSet set_;
  std::uint64_t seed_;
  std::vector<Corners> corners_;
};

}  // namespace gibench::spectral
