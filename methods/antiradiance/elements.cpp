#include "methods/antiradiance/elements.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/core/sampling.h"
#include "common/finite_elements/inside_geometry.h"
#include "common/finite_elements/surface_point.h"
#include "methods/antiradiance/cell_crossings.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t element_chunk = 64;
constexpr std::uint32_t most_parts = 16;  // of an element of several vertices; with more its points stand for its cell
constexpr float inset = 1.0F / 64.0F;     // of the way from a vertex to the middle of its face
constexpr float golden_ratio = 0.61803398875F;
constexpr std::uint64_t point_stage = 0x70617274ULL, exposure_stage = 0x6578706fULL;

/// m² of a quadrilateral by its diagonals: exact where it is planar.
float area_of(const CellPart& part) {
  const auto& [a, b, c, d] = part.corners;
  return 0.5F * glm::length(glm::cross(c - a, d - b));
}

Vec3 centroid_of(const CellPart& part) {
  const auto& [a, b, c, d] = part.corners;
  const float first = glm::length(glm::cross(b - a, c - a)), second = glm::length(glm::cross(c - a, d - a));
  const float sum = first + second;
  return sum > 0.0F ? ((a + b + c) * first + (a + c + d) * second) / (3.0F * sum) : (a + b + c + d) * 0.25F;
}

/// A point of the part, bilinear in the unit square.
Vec3 point_of(const CellPart& part, Vec2 at) {
  const auto& [a, b, c, d] = part.corners;
  return (a * (1.0F - at.x) + b * at.x) * (1.0F - at.y) + (d * (1.0F - at.x) + c * at.x) * at.y;
}

/// A point of each part, just beside the vertex of the cell.
std::vector<CellPoint> beside_vertex(const World& world, std::span<const CellPart> parts) {
  std::vector<CellPoint> points;
  for (const CellPart& part : parts) {
    const Vec3 position = part.corners[0] + (part.corners[2] - part.corners[0]) * inset;
    const Vec3 offset = world.offset(surface_sample(world, part.triangle, position, part.normal)) * part.normal;
    points.push_back({position + offset, position - offset, part.normal, part.triangle, true});
  }
  return points;
}

/// Whether a coplanar face is in front of the point.
bool is_covered(const World& world, const CellPoint& point) {
  if (world.coincident().empty()) return false;
  const SurfaceSample sample = sample_of(world, point);
  return !world.coincident().shows(sample.triangle, sample.barycentrics.x, sample.barycentrics.y, -point.normal);
}

}  // namespace

bool is_exposed(const World& world, const Vec3& origin, const Vec3& normal, int count, RandomStream random, RayStream& rays) {
  if (count == 0) return true;
  const Frame frame(normal);
  const Vec2 shift{random.next_float(), random.next_float()};
  return !all_meet_black_backs(world, origin, 0, count, rays, [&](int ray) {
    const Vec2 at = shift + Vec2(static_cast<float>(ray) / static_cast<float>(count), golden_ratio * static_cast<float>(ray));
    return frame.to_world(cosine_hemisphere(at - glm::floor(at)));
  });
}

Elements::Elements(const World& world, const SamplingMesh& mesh, int points, const CellTests& tests, Task& task, Merging merging)
    : points_per_element_(static_cast<std::size_t>(points)), merging_(std::move(merging)) {
  const std::size_t count = merging_.merges() ? merging_.elements : mesh.vertices().size();
  discs_.resize(count);
  sheets_.assign(count, 0);
  black_back_.assign(count, 0);
  exposed_share_.assign(count, 0.0F);
  reach_.assign(count, 0.0F);
  marks_.assign(count, 0);
  points_.resize(count * points_per_element_);
  set_out(world, mesh);
  cut_cells(world, mesh);
  task.parallel_chunks(count, element_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const auto element = static_cast<std::uint32_t>(i);
      place_points(world, element, task.seed());
      find_exposed(world, element, tests, task.seed(), rays);
      place_disc(element);
      if (tests.looks_behind && backed_within(this->points(element), std::sqrt(discs_[i].area / pi), rays))
        marks_[i] |= backed_mark;
    }
  });
  if (merging_.merges()) let_many_parts_go();
}

/// Of every element the side that it is on, and the disc of its whole cell.
void Elements::set_out(const World& world, const SamplingMesh& mesh) {
  std::vector<std::uint32_t> members(size(), 0);
  std::vector<float> areas(size(), 0.0F);
  for (std::uint32_t v = 0; v < mesh.vertices().size(); ++v) {
    const MeshVertex& vertex = mesh.vertices()[v];
    const std::uint32_t element = of_vertex(v);
    area_ += static_cast<double>(vertex.area);
    sheets_[element] = 2 * vertex.object + (vertex.front ? 0 : 1);
    black_back_[element] = world.scene().objects[vertex.object].two_sided ? 0 : 1;
    Disc& disc = discs_[element];
    if (members[element]++ == 0) {
      disc = {vertex.position, vertex.normal, areas[element] = vertex.area};
      continue;
    }
    const float all = areas[element] + vertex.area;
    if (all > 0.0F) disc.centre += (vertex.position - disc.centre) * (vertex.area / all);
    disc.normal = (members[element] == 2 ? disc.normal * areas[element] : disc.normal) + vertex.normal * vertex.area;
    areas[element] = all;
  }
  for (std::size_t element = 0; element < size(); ++element) {
    if (members[element] < 2) continue;
    marks_[element] |= several_mark;
    Disc& disc = discs_[element];
    const float length = glm::length(disc.normal);
    disc.area = areas[element];
    disc.normal = length > 0.0F ? disc.normal / length : Vec3(0.0F, 0.0F, 1.0F);
  }
}

void Elements::cut_cells(const World& world, const SamplingMesh& mesh) {
  part_begin_.assign(size() + 1, 0);
  const auto corner_count = [](const MeshFace& face) { return face.is_quad() ? std::size_t{4} : std::size_t{3}; };
  for (const MeshFace& face : mesh.faces())
    for (std::size_t k = 0; k < corner_count(face); ++k) ++part_begin_[of_vertex(face.corners[k]) + 1];
  for (std::size_t i = 1; i < part_begin_.size(); ++i) part_begin_[i] += part_begin_[i - 1];
  parts_.resize(part_begin_.back());
  std::vector<std::uint32_t> next(part_begin_.begin(), part_begin_.end() - 1);
  for (const MeshFace& face : mesh.faces()) {
    const std::size_t corners = corner_count(face);
    Vec3 middle(0.0F);
    const auto at = [&](std::size_t k) { return mesh.vertices()[face.corners[k % corners]].position; };
    for (std::size_t k = 0; k < corners; ++k) middle += at(k) / static_cast<float>(corners);
    const Vec3 normal = world.normal(face.scene_triangle) * (face.front ? 1.0F : -1.0F);
    for (std::size_t k = 0; k < corners; ++k)
      parts_[next[of_vertex(face.corners[k])]++] = {
          {at(k), 0.5F * (at(k) + at(k + 1)), middle, 0.5F * (at(k) + at(k + corners - 1))}, normal, face.scene_triangle};
  }
}

/// Stratified over the parts by area; within a part by a rank-1 lattice with a shift of its own.
void Elements::place_points(const World& world, std::uint32_t element, std::uint64_t seed) {
  const auto cell = parts(element);
  float total = 0.0F;
  for (const CellPart& part : cell) total += area_of(part);
  RandomStream random(seed, point_stage, element);
  const Vec2 shift{random.next_float(), random.next_float()};
  std::size_t part = 0;
  float before = 0.0F;
  for (std::size_t k = 0; k < points_per_element_; ++k) {
    const float target = (static_cast<float>(k) + shift.x) / static_cast<float>(points_per_element_);
    while (part + 1 < cell.size() && before + area_of(cell[part]) < target * total) before += area_of(cell[part++]);
    const float own = total > 0.0F ? area_of(cell[part]) / total : 1.0F;
    const float u = own > 0.0F ? std::clamp((target - (total > 0.0F ? before / total : 0.0F)) / own, 0.0F, 1.0F) : 0.5F;
    const float v = shift.y + golden_ratio * static_cast<float>(k);
    SurfaceSample sample;
    sample.position = point_of(cell[part], {u, v - std::floor(v)});
    sample.normal = cell[part].normal;
    sample.triangle = cell[part].triangle;
    const Vec3 offset = world.offset(sample) * sample.normal;
    points_[element * points_per_element_ + k] = {sample.position + offset, sample.position - offset, sample.normal,
                                                  sample.triangle, true};
  }
  const Vec3& centre = discs_[element].centre;
  for (const CellPart& one : cell)
    for (const Vec3& corner : one.corners) reach_[element] = std::max(reach_[element], glm::length(corner - centre));
}

void Elements::find_exposed(const World& world, std::uint32_t element, const CellTests& tests, std::uint64_t seed,
                            RayStream& rays) {
  const std::span<CellPoint> own = own_points(element);
  for (std::size_t k = 0; k < own.size(); ++k) {
    const bool covered = is_covered(world, own[k]);
    if (covered) marks_[element] |= covered_mark;
    own[k].exposed = !covered && is_exposed(world, own[k].origin, own[k].normal, tests.backface_rays,
                                            RandomStream(seed, exposure_stage, element * own.size() + k), rays);
  }
  if (tests.backface_rays > 0 && (marks_[element] & several_mark) == 0) {
    std::vector<std::uint32_t> faces;
    for (const CellPart& part : parts(element)) faces.push_back(world.scene().triangle_face[part.triangle]);
    if (part_cell(world, own, beside_vertex(world, parts(element)), faces, rays)) marks_[element] |= parted_mark;
  }
  const auto exposed = std::count_if(own.begin(), own.end(), [](const CellPoint& point) { return point.exposed; });
  exposed_share_[element] = static_cast<float>(exposed) / static_cast<float>(own.size());
}

/// At the vertex where its cell surrounds it. Where the cell lies to one side (at a border, at a crease, at another surface
/// that cuts it off) half the disc would hang in the air or stick in a wall: there at the exposed part's middle.
void Elements::place_disc(std::uint32_t element) {
  Disc& disc = discs_[element];
  Vec3 centre(0.0F);
  if (exposed_share_[element] < 1.0F) {
    float count = 0.0F;
    for (const CellPoint& point : points(element))
      if (point.exposed) centre += 0.5F * (point.origin + point.behind), count += 1.0F;
    centre = count > 0.0F ? centre / count : disc.centre;
  } else {
    float total = 0.0F;
    for (const CellPart& part : parts(element)) centre += centroid_of(part) * area_of(part), total += area_of(part);
    centre = total > 0.0F ? centre / total : disc.centre;
  }
  reach_[element] += glm::length(centre - disc.centre);
  disc.centre = centre;
  disc.area *= exposed_share_[element];
}

void Elements::let_many_parts_go() {
  std::uint32_t kept = 0;
  for (std::size_t element = 0; element < size(); ++element) {
    const std::uint32_t begin = part_begin_[element], end = part_begin_[element + 1];
    part_begin_[element] = kept;
    if (end - begin > most_parts) continue;
    for (std::uint32_t part = begin; part < end; ++part) parts_[kept++] = parts_[part];
  }
  part_begin_.back() = kept;
  parts_.resize(kept);
  parts_.shrink_to_fit();
}

std::size_t Elements::bytes() const {
  return discs_.capacity() * sizeof(Disc) + sheets_.capacity() * sizeof(std::uint32_t) + black_back_.capacity() +
         marks_.capacity() + (exposed_share_.capacity() + reach_.capacity()) * sizeof(float) +
         parts_.capacity() * sizeof(CellPart) + part_begin_.capacity() * sizeof(std::uint32_t) +
         points_.capacity() * sizeof(CellPoint);
}

}  // namespace gibench::antiradiance
