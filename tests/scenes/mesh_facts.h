/// Facts of a made mesh: edges, degenerate faces, and the volumes of its parts.
#pragma once

#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "scenes/generators/mesh.h"

namespace gibench::generators {

struct MeshFacts {
  std::size_t unmatched_edges = 0;     ///< those without exactly one neighbour of the opposite direction
  std::size_t degenerate_faces = 0;    ///< of less than `least_area`
  double volume = 0.0;                 ///< m³; positive where faces look outwards
  std::vector<double> part_volumes{};  ///< of the connected parts
  double area = 0.0;                   ///< m²
};

inline MeshFacts facts_of(const Mesh& mesh, double least_area = 5e-10) {
  MeshFacts facts;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed;
  std::vector<std::uint32_t> part(mesh.vertices.size());
  std::iota(part.begin(), part.end(), 0U);
  const auto root = [&](std::uint32_t vertex) {
    while (part[vertex] != vertex) vertex = part[vertex] = part[part[vertex]];
    return vertex;
  };
  std::map<std::uint32_t, double> volumes;
  for (const auto& face : mesh.faces)
    for (const std::uint32_t corner : face) part[root(corner)] = root(face[0]);
  for (const auto& face : mesh.faces) {
    const std::size_t corners = face[3] == face[2] ? 3 : 4;
    const Vec3d a = mesh.vertices[face[0]];
    Vec3d doubled_area(0.0);
    for (std::size_t i = 0; i < corners; ++i) ++directed[{face[i], face[(i + 1) % corners]}];
    for (std::size_t i = 1; i + 1 < corners; ++i) {
      const Vec3d b = mesh.vertices[face[i]], c = mesh.vertices[face[i + 1]];
      doubled_area += glm::cross(b - a, c - a);
      volumes[root(face[0])] += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    facts.area += 0.5 * glm::length(doubled_area);
    if (!(0.5 * glm::length(doubled_area) > least_area)) ++facts.degenerate_faces;
  }
  for (const auto& [edge, count] : directed) {
    const auto back = directed.find({edge.second, edge.first});
    if (count != 1 || back == directed.end() || back->second != 1) ++facts.unmatched_edges;
  }
  for (const auto& [representative, volume] : volumes) {
    facts.part_volumes.push_back(volume);
    facts.volume += volume;
  }
  return facts;
}

}  // namespace gibench::generators
