#include "methods/antiradiance/parted_triangles.h"

#include <array>
#include <glm/common.hpp>
#include <limits>
#include <span>

#include "common/finite_elements/surface_point.h"
#include "methods/antiradiance/cell_crossings.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t triangle_chunk = 128;
constexpr float inset = 1.0F / 64.0F;  // of the way to the triangle's middle

/// The exposed point nearest to the element's middle; none where none is exposed.
const CellPoint* middle_point(const Elements& elements, std::uint32_t element) {
  const CellPoint* best = nullptr;
  float least = std::numeric_limits<float>::infinity();
  for (const CellPoint& point : elements.points(element)) {
    const Vec3 d = point.origin - elements.disc(element).centre;
    if (point.exposed && glm::dot(d, d) < least) least = glm::dot(d, d), best = &point;
  }
  return best;
}

/// Whether something hides the ends of an edge from each other.
bool is_parted_edge(const World& world, const SamplingMesh& mesh, const Elements& elements, std::uint32_t triangle, std::size_t k,
                    std::span<const std::uint32_t> face, RayStream& rays) {
  const auto& corners = mesh.triangles()[triangle].corners;
  const std::size_t next = (k + 1) % 3;
  const std::uint32_t from = elements.of_vertex(corners[k]), to = elements.of_vertex(corners[next]);
  if (from == to) return false;
  if (elements.merging().merges())
    return !nothing_between(world, corner_point(world, mesh, triangle, k), corner_point(world, mesh, triangle, next), face, rays);
  const CellPoint *a = middle_point(elements, from), *b = middle_point(elements, to);
  return a != nullptr && b != nullptr && !nothing_between(world, *a, *b, face, rays);
}

}  // namespace

CellPoint corner_point(const World& world, const SamplingMesh& mesh, std::uint32_t triangle, std::size_t corner) {
  const MeshTriangle& whole = mesh.triangles()[triangle];
  const MeshFace& face = mesh.faces()[whole.face];
  const auto at = [&](std::size_t k) { return mesh.vertices()[whole.corners[k]].position; };
  const Vec3 middle = (at(0) + at(1) + at(2)) / 3.0F;
  const Vec3 normal = world.normal(face.scene_triangle) * (face.front ? 1.0F : -1.0F);
  const SurfaceSample sample = surface_sample(world, face.scene_triangle, glm::mix(at(corner), middle, inset), normal);
  const Vec3 offset = world.offset(sample) * normal;
  return {sample.position + offset, sample.position - offset, normal, face.scene_triangle, true};
}

std::vector<std::uint8_t> parted_triangles(const World& world, const SamplingMesh& mesh, const Elements& elements, Task& task) {
  std::vector<std::uint8_t> parted(mesh.triangles().size(), 0);
  task.parallel_chunks(parted.size(), triangle_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    for (std::size_t t = range.begin; t < range.end; ++t) {
      const std::array<std::uint32_t, 1> face{world.scene().triangle_face[mesh.faces()[mesh.triangles()[t].face].scene_triangle]};
      for (std::size_t k = 0; k < 3; ++k)
        if (elements.parted(elements.of_vertex(mesh.triangles()[t].corners[k])) ||
            is_parted_edge(world, mesh, elements, static_cast<std::uint32_t>(t), k, face, rays))
          parted[t] = 1;
    }
  });
  return parted;
}

}  // namespace gibench::antiradiance
