#include "methods/spectral/interpolation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gibench::spectral {

namespace {

constexpr std::size_t triangle_chunk = 512;
constexpr float inset = 1.0F / 64.0F;  // of a triangle: rays run between points just inside its corners
constexpr float tip = inset / 16.0F;   // where a corner itself is looked for: a surface between there and the inset cuts it off
constexpr float lift = 1.0F / 256.0F;  // of a triangle's size: how far above it

/// The places just above a triangle's corners.
struct Lifted {
  std::array<Vec3, 3> corners, tips;
  Vec3 up;  // metres

  Lifted(const World& world, const SamplingMesh& mesh, std::uint32_t triangle) {
    const MeshTriangle& t = mesh.triangles()[triangle];
    const MeshFace& face = mesh.faces()[t.face];
    std::array<Vec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = mesh.vertices()[t.corners[i]].position;
    const Vec3& front = world.normal(face.scene_triangle);
    const SurfaceSample centre = world.sample_at(face.scene_triangle, Vec2(1.0F / 3.0F), front);
    const float height = std::max(world.offset(centre), lift * std::sqrt(glm::length(glm::cross(p[1] - p[0], p[2] - p[0]))));
    up = (face.front ? height : -height) * front;
    const Vec3 middle = (p[0] + p[1] + p[2]) / 3.0F;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = glm::mix(p[i], middle, 3.0F * inset) + up;
      tips[i] = glm::mix(p[i], middle, 3.0F * tip) + up;
    }
  }
};

}  // namespace

Interpolation::Interpolation(const World& world, SamplingMesh& mesh, float smallest, Task& task)
    : cut_edges_(mesh.triangles().size(), 0) {
  if (smallest > 0.0F) leave_out_small(mesh, smallest);
  cut_edges(world, mesh, task);
  if (task.cancelled()) return;
  const auto was_left_out = [](std::uint8_t marks) { return marks == left_out; };
  std::vector<std::uint8_t> avoided = cut_edges_;
  std::replace_if(avoided.begin(), avoided.end(), was_left_out, std::uint8_t{0});
  mesh.place_sites(world, avoided);
  find_sites(world, mesh);
  find_hidden_sites(world, mesh, task);
  std::replace_if(cut_edges_.begin(), cut_edges_.end(), was_left_out, std::uint8_t{0});
}

void Interpolation::leave_out_small(const SamplingMesh& mesh, float smallest) {
  const auto corner = [&](std::size_t t, std::size_t i) { return mesh.vertices()[mesh.triangles()[t].corners[i]].position; };
  for (std::size_t t = 0; t < cut_edges_.size(); ++t) {
    const float longest = std::max({glm::length(corner(t, 1) - corner(t, 0)), glm::length(corner(t, 2) - corner(t, 1)),
                                    glm::length(corner(t, 0) - corner(t, 2))});
    if (longest < smallest) cut_edges_[t] = left_out;
  }
}

void Interpolation::cut_edges(const World& world, const SamplingMesh& mesh, Task& task) {
  task.parallel_chunks(cut_edges_.size(), triangle_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    for (std::size_t t = range.begin; t < range.end; ++t) {
      if (cut_edges_[t] == left_out) continue;
      const Lifted lifted(world, mesh, static_cast<std::uint32_t>(t));
      for (std::uint32_t i = 0; i < 3; ++i) {
        const Vec3 &from = lifted.corners[i], &to = lifted.corners[(i + 1) % 3];
        if (rays.occluded({from, 0.0F, to - from, 1.0F})) cut_edges_[t] = static_cast<std::uint8_t>(cut_edges_[t] | (1U << i));
      }
      for (std::size_t c = 0; c < 3 && cut_edges_[t] == 0; ++c)
        if (rays.occluded({lifted.tips[c], 0.0F, lifted.corners[c] - lifted.tips[c], 1.0F})) cut_edges_[t] = hidden_site;
    }
  });
}

void Interpolation::find_sites(const World& world, const SamplingMesh& mesh) {
  constexpr float none = std::numeric_limits<float>::infinity();
  for (std::uint32_t vertex = 0; vertex < mesh.vertices().size(); ++vertex) {
    const std::span<const VertexSite> own = mesh.sites(vertex);
    sites_.push_back(own.size() == 1 ? mesh.sample(world, vertex, own.front()).position : Vec3(none));
  }
}

/// A site may lie beyond a surface that passes between it and a triangle without touching that triangle's edges.
void Interpolation::find_hidden_sites(const World& world, const SamplingMesh& mesh, Task& task) {
  task.parallel_chunks(cut_edges_.size(), triangle_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const auto t = static_cast<std::uint32_t>(i);
      if (torn(t)) continue;
      const Lifted lifted(world, mesh, t);
      for (std::size_t c = 0; c < 3 && !torn(t); ++c) {
        const Vec3 &from = lifted.corners[c], to = site(mesh, t, c, from, lifted.up);
        if (to != from && rays.occluded({from, 0.0F, to - from, 1.0F})) cut_edges_[t] = hidden_site;
      }
    }
  });
}

Vec3 Interpolation::site(const SamplingMesh& mesh, std::uint32_t triangle, std::size_t corner, const Vec3& own,
                         const Vec3& up) const {
  const std::uint32_t vertex = mesh.triangles()[triangle].corners[corner];
  return std::isfinite(sites_[vertex].x) ? sites_[vertex] + up : own;
}

std::size_t Interpolation::torn_triangles() const {
  return static_cast<std::size_t>(std::count_if(cut_edges_.begin(), cut_edges_.end(), [](std::uint8_t cut) { return cut != 0; }));
}

MeshPoint Interpolation::seen(const World& world, const SamplingMesh& mesh, MeshPoint point, const Vec3& position,
                              RayStream& rays) const {
  if (!torn(point.triangle)) return point;
  const Lifted lifted(world, mesh, point.triangle);
  const Vec3 from = position + lifted.up;
  MeshPoint kept = point;
  float sum = 0.0F;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 to = site(mesh, point.triangle, i, lifted.corners[i], lifted.up);
    if (rays.occluded({from, 0.0F, to - from, 1.0F})) kept.weights[i] = 0.0F;
    sum += kept.weights[i];
  }
  if (!(sum > 0.0F)) return point;
  for (float& weight : kept.weights) weight /= sum;
  return kept;
}

}  // namespace gibench::spectral
