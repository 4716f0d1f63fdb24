/// The rays of a vertex, and what they meet in terms of the mesh's vertices.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "methods/spectral/interpolation.h"

namespace gibench::spectral {

/// Cosine-distributed directions: one low-discrepancy set for all vertices (an Owen-scrambled Sobol net), each of which turns
/// it about the normal and shifts it in elevation (Cranley and Patterson 1976). Neighbours in the square stand next to one
/// another, so that rays traced together run together.
class DirectionSet {
 public:
  DirectionSet() = default;
  DirectionSet(int rays, std::uint64_t seed);

  std::size_t size() const { return elevation_.size(); }
  /// In the frame whose z axis is the normal; `directions` as long as the set.
  void directions(std::uint64_t seed, std::uint32_t vertex, std::span<Vec3> directions) const;

 private:
  std::vector<float> elevation_, cosine_, sine_;  // squared radius in the disc, and the azimuth's
};

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
  std::vector<Leaving> leaving(std::uint32_t vertex) const;
  std::size_t trace_batch(std::span<const Ray> batch, float ray_weight, RayStream& rays, MeshHit* hits) const;

  const World& world_;
  const SamplingMesh& mesh_;
  const Interpolation& interpolation_;
  DirectionSet set_;
  std::uint64_t seed_;
  std::vector<std::array<std::uint32_t, 3>> triangle_slots_;
};

}  // namespace gibench::spectral
