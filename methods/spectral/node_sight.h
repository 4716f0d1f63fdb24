/// Sight between nodes of the mesh just above the surface: what walls part does not come together.
#pragma once

#include <algorithm>
#include <cstdint>

#include "common/ray/ray_stream.h"
#include "methods/spectral/nodes.h"

namespace gibench::spectral {

/// Whether two vertices see each other from this far above them, metres, or from an eighth of that: from sites, which lie off the
/// edges of faces, with nothing between these and the places above them. A wall that stands on the surface hides them from both
/// heights; beside one that bulges the higher place may lie in it.
inline bool see_each_other(const World& world, const SamplingMesh& mesh, std::uint32_t a, std::uint32_t b, float height,
                           RayStream& rays) {
  const SurfaceSample first = mesh.sample(world, a, mesh.sites(a).front()), second = mesh.sample(world, b, mesh.sites(b).front());
  const auto are_apart = [&](const Vec3& from, const Vec3& to) {
    return from != to && rays.occluded({from, 0.0F, to - from, 1.0F});
  };
  const auto see_from = [&](float up) {
    const auto above = [&](const SurfaceSample& sample) {
      return sample.position + std::max(up, world.offset(sample)) * sample.normal;
    };
    const Vec3 from = above(first), to = above(second);
    return !are_apart(from, to) && !are_apart(world.ray_origin(first), from) && !are_apart(world.ray_origin(second), to);
  };
  return see_from(height) || see_from(height / 8.0F);
}

/// The vertex that a node is looked at from: its most central one.
inline std::uint32_t central_vertex(const Nodes& nodes, std::uint32_t node) { return nodes.sites(node).front().vertex; }

}  // namespace gibench::spectral
