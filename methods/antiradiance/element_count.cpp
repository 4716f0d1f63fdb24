#include "methods/antiradiance/element_count.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace gibench::antiradiance {

namespace {

constexpr float straight = 0.02F;       // radians: of angles that sum to half a turn or to a whole one
constexpr float in_one_plane = 0.999F;  // cosine between a face's normal and its vertex's: 2.6 degrees

float angle_between(const Vec3& a, const Vec3& b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

}  // namespace

std::size_t corner_count(const SamplingMesh& mesh) {
  const auto vertices = mesh.vertices();
  std::vector<float> angles(vertices.size(), 0.0F);
  std::vector<std::uint8_t> bent(vertices.size(), 0);
  for (const MeshFace& face : mesh.faces()) {
    const std::size_t corners = face.is_quad() ? 4 : 3;
    const auto at = [&](std::size_t k) { return vertices[face.corners[k % corners]].position; };
    const Vec3 across = glm::cross(at(1) - at(0), at(2) - at(0));
    const float length = glm::length(across);
    for (std::size_t k = 0; k < corners; ++k) {
      const std::uint32_t v = face.corners[k];
      angles[v] += angle_between(at(k + 1) - at(k), at(k + corners - 1) - at(k));
      if (std::fabs(glm::dot(across, vertices[v].normal)) < in_one_plane * length) bent[v] = 1;
    }
  }
  std::size_t count = 0;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (bent[v] != 0 || (std::fabs(angles[v] - pi) > straight && std::fabs(angles[v] - 2.0F * pi) > straight)) ++count;
  return count;
}

int elements_for(std::size_t corners) {
  constexpr double room = elements_of_a_room;
  return static_cast<int>(std::lround(std::sqrt(room * std::max(room, static_cast<double>(corners)))));
}

}  // namespace gibench::antiradiance
