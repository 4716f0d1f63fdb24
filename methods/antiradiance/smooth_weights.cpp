#include "methods/antiradiance/smooth_weights.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "methods/antiradiance/over_obstacles.h"
#include "methods/antiradiance/pull.h"
#include "methods/antiradiance/representatives.h"

namespace gibench::antiradiance {

namespace {

constexpr float hill_reach = 1.6F;     // of an element's size, to where its values reach
constexpr float roundness = 0.25F;     // of the square of a disc's radius, added to the cell's own extents
constexpr float least_cosine = 0.3F;   // between a vertex's normal and an element's, from which the latter counts
constexpr float least_of_own = 0.02F;  // height of its own element's hill at every vertex
constexpr int corrections = 2;
constexpr std::size_t element_chunk = 64;

/// An element as its neighbours see it.
struct Hill {
  Vec3 centre{0.0F}, normal{0.0F};
  glm::mat3 to_unit{0.0F};  ///< inverse of the squared extents: the hill ends where dᵀ to_unit d = 1
  float support = 0.0F;     ///< metres from the centre to the furthest end
  Lookout lookout;

  /// Height at an offset from the centre.
  float height(const Vec3& offset) const {
    const float squared = glm::dot(offset, to_unit * offset);
    return squared < 1.0F ? (1.0F - squared) * (1.0F - squared) : 0.0F;
  }
};

/// Four times the covariance of the cell's points is the square of a disc's radius, along each axis of it.
Hill hill_of(const Elements& elements, std::uint32_t element, RayStream& rays) {
  const Disc& disc = elements.disc(element);
  Hill made;
  made.centre = disc.centre, made.normal = disc.normal;
  glm::mat3 squares(0.0F);
  float count = 0.0F, least = 0.0F;
  const CellPoint* middle = nullptr;
  for (const CellPoint& point : elements.points(element)) {
    if (!point.exposed) continue;
    const Vec3 d = 0.5F * (point.origin + point.behind) - disc.centre;
    squares += glm::outerProduct(d, d);
    count += 1.0F;
    if (middle == nullptr || glm::dot(d, d) < least) middle = &point, least = glm::dot(d, d);
  }
  if (middle == nullptr) return made;
  const float radius_squared = disc.area / pi;
  const glm::mat3 extents = (squares * (4.0F / count) + glm::mat3(roundness * radius_squared)) * (hill_reach * hill_reach);
  made.support = std::sqrt(extents[0][0] + extents[1][1] + extents[2][2]);
  made.to_unit = glm::inverse(extents);
  made.lookout = Lookout(middle->origin, middle->normal, std::sqrt(radius_squared), rays);
  return made;
}

}  // namespace

class SmoothWeights::Maker {
 public:
  Maker(const World& world, const SamplingMesh& mesh, const Elements& elements, const Hierarchy& hierarchy, Task& task)
      : world_(world), mesh_(mesh), elements_(elements), hierarchy_(hierarchy), hills_(elements.size()) {
    task.parallel_chunks(elements.size(), element_chunk, [&](const ChunkRange& range) {
      RayStream rays = task.rays(world);
      for (std::size_t e = range.begin; e < range.end; ++e)
        if (elements.disc(static_cast<std::uint32_t>(e)).area > 0.0F)
          hills_[e] = hill_of(elements, static_cast<std::uint32_t>(e), rays);
    });
    supports_.assign(hierarchy.size(), 0.0F);
    from_leaves_up(
        hierarchy, [&](std::size_t node, std::size_t leaf) { supports_[node] = hills_[hierarchy.order()[leaf]].support; },
        [&](std::size_t node, std::size_t left, std::size_t right, float) {
          supports_[node] = std::max(supports_[left], supports_[right]);
        });
  }

  /// The elements whose hills may reach one of the vertices that `vertex` stands for, `reach` metres around it, and that nothing
  /// hides from it. Empty where its element takes no part.
  void find_neighbours(std::uint32_t vertex, float reach, RayStream& rays, std::vector<std::uint32_t>& found) const {
    found.clear();
    const std::uint32_t own = elements_.of_vertex(vertex);
    if (!(elements_.disc(own).area > 0.0F)) return;
    const MeshVertex& at = mesh_.vertices()[vertex];
    const Lookout lookout(world_, mesh_, vertex, std::sqrt(elements_.disc(own).area / pi), rays);
    for (const std::uint32_t root : hierarchy_.roots())
      visit_down(hierarchy_.nodes(), root, [&](std::uint32_t index) {
        const Node& node = hierarchy_.nodes()[index];
        const Vec3 d = node.centre - at.position;
        const float furthest = node.reach + supports_[index] + reach;
        if (glm::dot(d, d) > furthest * furthest) return false;
        if (!node.is_leaf()) return true;
        const std::uint32_t element = hierarchy_.element(node);
        if (element == own ||
            (may_reach(element, at, reach) && alike(element, own) && lookout.sees(hills_[element].lookout, rays)))
          found.push_back(element);
        return false;
      });
  }

  /// The weights of one vertex, which sum to one.
  void weigh(std::uint32_t vertex, std::span<const std::uint32_t> neighbours, std::vector<Entry>& row) const {
    const std::size_t first = row.size();
    const std::uint32_t own = elements_.of_vertex(vertex);
    const MeshVertex& at = mesh_.vertices()[vertex];
    float sum = 0.0F;
    for (const std::uint32_t element : neighbours) {
      const float weight = element == own ? std::max(least_of_own, weight_of(element, at)) : weight_of(element, at);
      if (!(weight > 0.0F)) continue;
      row.push_back({element, weight});
      sum += weight;
    }
    for (std::size_t i = first; i < row.size(); ++i) row[i].weight /= sum;
  }

 private:
  float weight_of(std::uint32_t element, const MeshVertex& at) const {
    const Hill& hill = hills_[element];
    const float cosine = glm::dot(hill.normal, at.normal);
    return cosine > least_cosine ? hill.height(at.position - hill.centre) * (cosine - least_cosine) : 0.0F;
  }
  /// Whether the element has any weight for some place and normal within `reach` metres; exact for a vertex by itself.
  bool may_reach(std::uint32_t element, const MeshVertex& at, float reach) const {
    if (!(reach > 0.0F)) return weight_of(element, at) > 0.0F;
    const float furthest = hills_[element].support + reach;
    const Vec3 d = at.position - hills_[element].centre;
    return glm::dot(d, d) < furthest * furthest && glm::dot(hills_[element].normal, at.normal) > -least_cosine;
  }
  bool alike(std::uint32_t a, std::uint32_t b) const {
    return elements_.sheet(a) == elements_.sheet(b) && elements_.reached(a) == elements_.reached(b);
  }

  const World& world_;
  const SamplingMesh& mesh_;
  const Elements& elements_;
  const Hierarchy& hierarchy_;
  std::vector<Hill> hills_;
  std::vector<float> supports_;  ///< of the nodes: the largest of their elements
};

SmoothWeights::SmoothWeights(const World& world, const SamplingMesh& mesh, const Elements& elements, const Hierarchy& hierarchy,
                             Task& task) {
  const std::size_t count = mesh.vertices().size();
  const Maker maker(world, mesh, elements, hierarchy, task);
  const Grouped members(elements.merging().of_vertex, elements.size());
  const Representatives representatives(mesh, members, task);
  std::vector<std::vector<Entry>> rows(chunk_count(elements.size(), element_chunk));
  std::vector<std::uint32_t> places(count, 0);  // of the vertices' rows in those of their chunk
  row_begin_.assign(count + 1, 0);
  task.parallel_chunks(elements.size(), element_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    std::vector<Entry>& own = rows[range.chunk];
    std::vector<std::uint32_t> neighbours;
    for (std::size_t e = range.begin; e < range.end; ++e)
      for (const std::uint32_t representative : representatives.of(e)) {
        const auto stands_for = [&](std::uint32_t v) { return representatives.of_vertex(v) == representative; };
        float squared = 0.0F;
        for (const std::uint32_t v : members.of(e)) {
          const Vec3 d = mesh.vertices()[v].position - mesh.vertices()[representative].position;
          if (stands_for(v)) squared = std::max(squared, glm::dot(d, d));
        }
        maker.find_neighbours(representative, std::sqrt(squared), rays, neighbours);
        for (const std::uint32_t v : members.of(e)) {
          if (!stands_for(v)) continue;
          places[v] = static_cast<std::uint32_t>(own.size());
          maker.weigh(v, neighbours, own);
          row_begin_[v + 1] = static_cast<std::uint32_t>(own.size()) - places[v];
        }
      }
  });
  for (std::size_t v = 0; v < count; ++v) row_begin_[v + 1] += row_begin_[v];
  entries_.resize(row_begin_.back());
  for (std::size_t v = 0; v < count; ++v) {
    const std::vector<Entry>& from = rows[elements.of_vertex(static_cast<std::uint32_t>(v)) / element_chunk];
    std::copy_n(from.begin() + places[v], row_begin_[v + 1] - row_begin_[v], entries_.begin() + row_begin_[v]);
  }
  std::vector<float> whole(elements.size(), 0.0F);
  for (std::uint32_t v = 0; v < count; ++v) {
    own_.push_back(elements.of_vertex(v));
    areas_.push_back(mesh.vertices()[v].area);
    whole[own_[v]] += areas_[v];
  }
  for (std::size_t v = 0; v < count; ++v) areas_[v] = whole[own_[v]] > 0.0F ? areas_[v] / whole[own_[v]] : 0.0F;
}

void SmoothWeights::add_blended(std::span<const Rgb> of_elements, std::vector<Rgb>& values) const {
  for (std::size_t v = 0; v < values.size(); ++v)
    for (std::uint32_t i = row_begin_[v]; i < row_begin_[v + 1]; ++i)
      values[v] += of_elements[entries_[i].element] * entries_[i].weight;
}

std::vector<Rgb> SmoothWeights::vertex_values(std::span<const Rgb> means) const {
  std::vector<Rgb> values(own_.size());
  add_blended(means, values);
  const std::vector<Rgb> blended = values;
  for (int step = 0; step < corrections; ++step) {
    std::vector<Rgb> lacking(means.begin(), means.end());
    for (std::size_t v = 0; v < values.size(); ++v) lacking[own_[v]] -= values[v] * areas_[v];
    add_blended(lacking, values);
  }
  for (std::size_t v = 0; v < values.size(); ++v)
    for (int c = 0; c < 3; ++c)
      values[v][c] = blended[v][c] >= 0.0F ? std::max(0.0F, values[v][c]) : std::min(0.0F, values[v][c]);
  return values;
}

}  // namespace gibench::antiradiance
