/// The rays of a node, and what they meet in terms of the mesh's vertices.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "methods/spectral/direction_set.h"
#include "methods/spectral/interpolation.h"
#include "methods/spectral/node_weights.h"

namespace gibench::spectral {

/// One ray that met the mesh: the three vertices around its hit and their weights, and where it came from.
struct MeshHit {
  std::array<std::uint32_t, 3> vertices;
  std::array<float, 3> weights;  ///< with the ray's own weight in them: π / rays
  Vec3 direction;                ///< unit, from the node, in the world's frame
};

/// Traces the rays of nodes, one after the other.
class VertexRays {
 public:
  /// `weights`: the slots in which nodes keep their values, by vertex.
  VertexRays(const World& world, const SamplingMesh& mesh, const Interpolation& interpolation, const Nodes& nodes,
             const NodeWeights& weights, int rays, std::uint64_t seed);

  /// Hands over, batch by batch, what the rays of a node meet: E = Σ over hits of weights · radiance at vertices,
  /// W/m², for light that leaves lit sides. Rays that leave the scene or meet backs bring nothing.
  void trace(std::uint32_t node, RayStream& rays, const std::function<void(std::span<const MeshHit>)>& take) const;

  /// Calls add(slot, weight) for all that a hit brings light from.
  template <class Add>
  void each_slot(const MeshHit& hit, const Add& add) const {
    for (std::size_t c = 0; c < 3; ++c)
      weights_.each(hit.vertices[c], [&](std::uint32_t slot, float share) { add(slot, hit.weights[c] * share); });
  }

 private:
  struct Leaving;
  /// What a batch met, in columns.
  struct Met;
  /// Of a mesh triangle.
  struct Corners {
    std::array<std::uint32_t, 3> vertices;
    std::uint32_t torn;
  };

  std::vector<Leaving> leaving(std::uint32_t node) const;
  std::size_t meet(const DirectionBatch& batch, const Met& met, float ray_weight, RayStream& rays, MeshHit* hits) const;

  const World& world_;
  const SamplingMesh& mesh_;
  const Interpolation& interpolation_;
  const Nodes& nodes_;
  const NodeWeights& weights_;
  DirectionSet set_;
  std::uint64_t seed_;
  std::vector<Corners> corners_;
};

}  // namespace gibench::spectral
