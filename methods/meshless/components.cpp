#include "methods/meshless/components.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "common/core/disjoint_sets.h"
#include "methods/meshless/box_tree.h"

namespace gibench::meshless {

namespace {

constexpr float on_an_edge = 1e-6F;  // of the diagonal: positions are floats

void join_coinciding(const std::vector<Vec3>& vertices, DisjointSets& sets) {
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t i) { return std::tie(vertices[i].x, vertices[i].y, vertices[i].z); };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t i = 1; i < order.size(); ++i)
    if (vertices[order[i]] == vertices[order[i - 1]]) sets.join(order[i], order[i - 1]);
}

/// An edge by its ends, places that stand for all vertices there, the smaller first.
struct Edge {
  std::uint32_t from, to, group;
  auto ends() const { return std::tie(from, to); }
};

/// The edges that belong to one triangle alone. `place`: of every vertex, the vertex that stands for all that coincide.
std::vector<Edge> open_edges(const Scene& scene, const std::vector<std::uint32_t>& place,
                             const std::vector<std::uint32_t>& group) {
  std::vector<Edge> edges;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = place[scene.triangles[t].corners[i]], b = place[scene.triangles[t].corners[(i + 1) % 3]];
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b), group[scene.triangle_object[t]]});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.ends() < b.ends(); });
  std::vector<Edge> open;
  for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
    for (next = i + 1; next < edges.size() && edges[next].ends() == edges[i].ends();) ++next;
    if (next == i + 1) open.push_back(edges[i]);
  }
  return open;
}

bool lies_on(const Vec3& point, const Vec3& from, const Vec3& to, float tolerance) {
  const Vec3 along = to - from;
  const float t = std::clamp(glm::dot(point - from, along) / glm::dot(along, along), 0.0F, 1.0F);
  const Vec3 apart = point - (from + t * along);
  return glm::dot(apart, apart) <= tolerance * tolerance;
}

/// Joins the ends of open edges that lie on another open edge of the same group.
void join_at_t_junctions(const World& world, const std::vector<Edge>& edges, DisjointSets& sets) {
  const std::vector<Vec3>& at = world.scene().vertices;
  const float tolerance = on_an_edge * world.diagonal();
  std::vector<Vec3> middles;
  for (const Edge& edge : edges) middles.push_back(0.5F * (at[edge.from] + at[edge.to]));
  const std::vector<std::uint32_t> order = compact_order(middles);
  std::vector<Box> boxes;
  for (const std::uint32_t e : order) {
    Box& box = boxes.emplace_back();
    box.add(at[edges[e].from], tolerance);
    box.add(at[edges[e].to], tolerance);
  }
  const BoxTree tree(boxes);
  for (const Edge& own : edges)
    for (const std::uint32_t end : {own.from, own.to})
      tree.visit_point(at[end], [&](std::uint32_t leaf) {
        if (leaf >= order.size()) return;
        const Edge& other = edges[order[leaf]];
        if (other.group == own.group && sets.find(other.from) != sets.find(end) &&
            lies_on(at[end], at[other.from], at[other.to], tolerance))
          sets.join(other.from, end);
      });
}

}  // namespace

std::vector<std::uint32_t> group_numbers(const Scene& scene) {
  std::unordered_map<std::string, std::uint32_t> numbers;
  std::vector<std::uint32_t> of_object;
  for (const Object& object : scene.objects)
    of_object.push_back(numbers.try_emplace(object.group, static_cast<std::uint32_t>(numbers.size())).first->second);
  return of_object;
}

std::vector<std::uint32_t> connected_components(const World& world) {
  const Scene& scene = world.scene();
  DisjointSets sets(scene.vertices.size());
  join_coinciding(scene.vertices, sets);
  std::vector<std::uint32_t> place(scene.vertices.size());
  for (std::uint32_t v = 0; v < place.size(); ++v) place[v] = sets.find(v);
  for (const Triangle& triangle : scene.triangles) {
    sets.join(triangle.corners[0], triangle.corners[1]);
    sets.join(triangle.corners[0], triangle.corners[2]);
  }
  join_at_t_junctions(world, open_edges(scene, place, group_numbers(scene)), sets);
  std::vector<std::uint32_t> components;
  components.reserve(scene.triangles.size());
  for (const Triangle& triangle : scene.triangles) components.push_back(sets.find(triangle.corners[0]));
  return components;
}

}  // namespace gibench::meshless
