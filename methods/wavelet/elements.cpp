#include "methods/wavelet/elements.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/core/random.h"
#include "common/core/sampling.h"
#include "common/finite_elements/inside_geometry.h"
#include "common/finite_elements/surface_point.h"
#include "methods/wavelet/flat_pieces.h"

namespace gibench::wavelet {

namespace {

constexpr std::uint64_t point_stage = 0x77706f696e74ULL, exposure_stage = 0x777261797aULL;
constexpr std::size_t leaf_chunk = 16;
constexpr int most_levels = 12;

std::uint32_t side_number(std::uint32_t triangle, bool front) { return 2 * triangle + (front ? 0U : 1U); }

Patch turned_over(const Patch& patch) {
  const auto& [a, b, c, d] = patch.corners;
  return patch.is_quad() ? Patch{{a, d, c, b}} : Patch{{a, c, b, b}};
}

/// Barycentrics of the second and third corner.
Vec2 barycentrics_in(const World& world, std::uint32_t triangle, const Vec3& position) {
  const auto& [a, b, c] = world.scene().triangles[triangle].corners;
  const auto& vertices = world.scene().vertices;
  const Vec3 first = vertices[b] - vertices[a], second = vertices[c] - vertices[a], to = position - vertices[a];
  const Vec3 normal = glm::cross(first, second);
  const float squared = glm::dot(normal, normal);
  if (!(squared > 0.0F)) return Vec2(1.0F / 3.0F);
  return {glm::dot(glm::cross(to, second), normal) / squared, glm::dot(glm::cross(first, to), normal) / squared};
}

bool is_in_triangle(Vec2 at) { return at.x >= 0.0F && at.y >= 0.0F && at.x + at.y <= 1.0F; }

/// The largest distance from the edges that a point keeps inside the patch; negative outside.
float depth_inside(const Patch& patch, const Vec3& normal, const Vec3& point) {
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < patch.corner_count(); ++i) {
    const Vec3 &a = patch.corners[i], &b = patch.corners[(i + 1) % patch.corner_count()];
    const float length = glm::length(b - a);
    if (length > 0.0F) least = std::min(least, glm::dot(glm::cross(b - a, point - a), normal) / length);
  }
  return least;
}

std::size_t sides_of(const World& world, const FlatPieces& flat) {
  std::size_t sides = 0;
  for (const FlatPiece& piece : flat.pieces)
    sides += world.scene().objects[world.scene().triangle_object[piece.triangle]].two_sided ? std::size_t{2} : std::size_t{1};
  return sides;
}

}  // namespace

Elements::Elements(const World& world, const ElementOptions& options, Task& task) {
  const FlatPieces flat = flat_pieces(world, options.cuts);
  task.count("quads_by_triangle", flat.quads_by_triangle);
  task.count("faces_without_area", flat.faces_without_area);
  if (const std::size_t count = sides_of(world, flat); count > options.most_elements) {
    refused_ = count;
    return;
  }
  for (const FlatPiece& piece : flat.pieces) {
    Element element;
    element.triangle = piece.triangle;
    element.object = world.scene().triangle_object[piece.triangle];
    for (const bool front : {true, false}) {
      if (!front && !world.scene().objects[element.object].two_sided) continue;
      element.front = front;
      element.normal = front ? piece.normal : -piece.normal;
      element.offset = 0.0F;
      for (const Vec3& corner : piece.patch.corners)
        element.offset = std::max(element.offset, world.offset(surface_sample(world, piece.triangle, corner, element.normal)));
      add_element(front ? piece.patch : turned_over(piece.patch), element, options.leaf_area);
    }
  }
  find_sides(world);
  leaf_of_node_.assign(nodes_.size(), none);
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
    if (!nodes_[node].is_leaf()) continue;
    leaf_of_node_[node] = static_cast<std::uint32_t>(leaves_.size());
    leaves_.push_back(node);
  }
  find_points(world, options, task);
  gather_areas();
  add_groups();
}

void Elements::add_element(const Patch& patch, Element element, double leaf_area) {
  const auto number = static_cast<std::uint32_t>(elements_.size());
  element.root = static_cast<std::uint32_t>(nodes_.size());
  int levels = 0;
  for (double area = static_cast<double>(patch.area()); area > 2.0 * leaf_area && levels < most_levels; area /= 4.0) ++levels;
  nodes_.push_back({patch, 0.0F, 0, none, number, none});
  std::uint32_t begin = element.root;
  for (int level = 0; level < levels; ++level) {
    const auto end = static_cast<std::uint32_t>(nodes_.size());
    for (std::uint32_t parent = begin; parent < end; ++parent) {
      nodes_[parent].first_child = static_cast<std::uint32_t>(nodes_.size());
      for (const Patch& part : nodes_[parent].patch.parts()) nodes_.push_back({part, 0.0F, 0, parent, number, none});
    }
    begin = end;
  }
  element.end = static_cast<std::uint32_t>(nodes_.size());
  elements_.push_back(element);
}

void Elements::find_sides(const World& world) {
  const Scene& scene = world.scene();
  const std::size_t triangles = scene.triangles.size();
  std::vector<std::uint8_t> named(triangles, 0);
  std::vector<std::uint32_t> sides;
  for (const Element& element : elements_) {
    named[element.triangle] = 1;
    sides.push_back(side_number(element.triangle, element.front));
  }
  for (std::uint32_t t = 0; t < triangles; ++t)
    first_triangle_.push_back(t > 0 && named[t] == 0 && scene.triangle_face[t] == scene.triangle_face[t - 1] ? t - 1 : t);
  by_side_.emplace(sides, 2 * triangles);
}

void Elements::find_points(const World& world, const ElementOptions& options, Task& task) {
  points_.resize(nodes_.size() * points_a_node);
  task.parallel_chunks(leaves_.size(), leaf_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf)
      place_points(world, leaves_[leaf], options.exposure_rays, task.seed(), rays);
  });
}

/// A random point in each part of each part, so that rays between two leaves keep no pattern.
void Elements::place_points(const World& world, std::uint32_t leaf, int exposure_rays, std::uint64_t seed, RayStream& rays) {
  const Element& element = element_of(leaf);
  const auto parts = nodes_[leaf].patch.parts();
  for (std::size_t i = 0; i < points_a_node; ++i) {
    const Patch cell = parts[i / child_count].parts()[i % child_count];
    NodePoint& point = points_[leaf * points_a_node + i];
    RandomStream random(seed, point_stage, leaf * points_a_node + i);
    const float across = random.next_float(), along = random.next_float();
    point.position = cell.at({across, along});
    const SurfaceSample at = sample(world, leaf, point);
    if (!world.coincident().empty() &&
        !world.coincident().shows(at.triangle, at.barycentrics.x, at.barycentrics.y, -element.normal))
      continue;
    RandomStream directions(seed, exposure_stage, leaf * points_a_node + i);
    const auto direction_of = [&](int) {
      const float x = directions.next_float(), y = directions.next_float();
      return Frame(element.normal).to_world(cosine_hemisphere({x, y}));
    };
    if (exposure_rays > 0 && all_meet_black_backs(world, origin(leaf, point), 0, exposure_rays, rays, direction_of)) continue;
    point.area = cell.area();
  }
}

/// From the leaves up: a node takes of each child four points, one of every four.
void Elements::gather_areas() {
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    Node& node = nodes_[i];
    const std::span own = std::span(points_).subspan(i * points_a_node, points_a_node);
    for (std::size_t p = 0; p < points_a_node && !node.is_leaf(); ++p) {
      const std::span four = std::span(points_).subspan(
          (node.first_child + p / child_count) * points_a_node + p % child_count * child_count, child_count);
      std::size_t chosen = mix_keys(i, p) % child_count;
      for (std::size_t k = 0; k < child_count && !(four[chosen].area > 0.0F); ++k) chosen = (chosen + 1) % child_count;
      own[p].position = four[chosen].position;
      own[p].area = four[0].area + four[1].area + four[2].area + four[3].area;
    }
    double area = 0.0;
    for (const NodePoint& point : own) area += static_cast<double>(point.area);
    node.area = static_cast<float>(area);
  }
}

/// One child after the other, so that any four that are open lie in four children.
void Elements::keep_points(std::size_t of_leaf) {
  std::vector<NodePoint> kept;
  for (const std::uint32_t leaf : leaves_) {
    const std::size_t begin = kept.size();
    for (std::size_t turn = 0; turn < points_a_node && kept.size() < begin + of_leaf; ++turn) {
      const std::size_t child = turn % child_count, place = (turn / child_count + mix_keys(leaf, child)) % child_count;
      const NodePoint& point = points(leaf)[child * child_count + place];
      if (point.area > 0.0F) kept.push_back(point);
    }
    for (std::size_t i = begin; i < kept.size(); ++i) kept[i].area = nodes_[leaf].area / static_cast<float>(kept.size() - begin);
    kept.resize(begin + of_leaf);
  }
  points_ = std::move(kept);
  points_.shrink_to_fit();
  kept_points_ = of_leaf;
}

void Elements::add_groups() {
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    Node& node = nodes_[n];
    const bool root = node.parent == none;
    if (node.is_leaf() && !root) continue;
    node.group = static_cast<std::uint32_t>(groups_.size());
    groups_.push_back({n, static_cast<std::uint8_t>(root ? 0 : 1), static_cast<std::uint8_t>(node.is_leaf() ? 1 : 4)});
    functions_ += groups_.back().functions();
    std::array<double, child_count> areas{};
    for (std::size_t c = 0; c < child_count && !node.is_leaf(); ++c)
      areas[c] = static_cast<double>(nodes_[node.first_child + c].area);
    steps_.emplace_back(areas);
  }
}

SurfaceSample Elements::sample(const World& world, std::uint32_t node, const NodePoint& point) const {
  const Element& element = element_of(node);
  std::uint32_t triangle = element.triangle;
  Vec2 at = barycentrics_in(world, triangle, point.position);
  if (!is_in_triangle(at) && triangle + 1 < first_triangle_.size() && first_triangle_[triangle + 1] == triangle)
    at = barycentrics_in(world, ++triangle, point.position);
  SurfaceSample result = surface_sample(world, triangle, point.position, element.normal);
  result.barycentrics = at;
  return result;
}

std::uint32_t Elements::leaf_at(const World& world, const SurfaceSample& sample) const {
  const bool front = glm::dot(world.normal(sample.triangle), sample.normal) >= 0.0F;
  std::uint32_t found = none;
  float deepest = -std::numeric_limits<float>::infinity();
  for (const std::uint32_t element : by_side_->of(side_number(first_triangle_[sample.triangle], front))) {
    const Element& candidate = elements_[element];
    const float depth = depth_inside(nodes_[candidate.root].patch, candidate.normal, sample.position);
    if (depth > deepest) deepest = depth, found = candidate.root;
  }
  while (found != none && !nodes_[found].is_leaf())
    found = nodes_[found].first_child +
            static_cast<std::uint32_t>(nodes_[found].patch.part_at(sample.position, element_of(found).normal));
  return found;
}

std::size_t Elements::bytes() const {
  return elements_.capacity() * sizeof(Element) + nodes_.capacity() * sizeof(Node) + points_.capacity() * sizeof(NodePoint) +
         groups_.capacity() * sizeof(Group) + steps_.capacity() * sizeof(HaarStep) +
         (leaves_.capacity() + leaf_of_node_.capacity() + first_triangle_.capacity()) * sizeof(std::uint32_t) +
         (by_side_ ? (by_side_->begin.capacity() + by_side_->items.capacity()) * sizeof(std::uint32_t) : 0);
}

}  // namespace gibench::wavelet
