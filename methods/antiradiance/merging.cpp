#include "methods/antiradiance/merging.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/finite_elements/grouped.h"
#include "common/spaces/place_clusters.h"
#include "common/spaces/side_light.h"
#include "methods/antiradiance/over_obstacles.h"
#include "methods/antiradiance/representatives.h"

namespace gibench::antiradiance {

namespace {

constexpr float least_cosine = 0.5F;      // between normals of one disc
constexpr std::size_t discs_a_label = 4;  // fewer to an object in the mean: discs are by material instead
constexpr std::size_t sealed_share = 8;   // one disc in so many goes to what no light reaches
constexpr std::uint32_t most_parts = 4;   // that obstacles cut one disc into
constexpr std::size_t most_more = 2;      // times the discs wanted, after obstacles parted them
constexpr int most_attempts = 4;          // the last of which parts none
constexpr std::size_t cluster_chunk = 16;
constexpr std::uint8_t brightness_classes = 4;  // of what light reaches
constexpr float bright = 0.5F;                  // of the mean irradiance, from where on discs are smaller
constexpr float brighter = 4.0F;                // times the irradiance, and the discs, from class to class

/// What is known of the light at every vertex.
struct VertexLight {
  std::vector<Reached> reached;
  std::vector<std::uint8_t> brightness;  ///< class by irradiance: each has `brighter` times that of the one before
};

/// W/m², the most just beside a vertex on one side of its faces.
float irradiance_beside(const SideLight& light, std::span<const VertexSite> sites, bool front) {
  float most = 0.0F;
  for (const VertexSite& site : sites) most = std::max(most, light.irradiance(site.scene_triangle, front, site.barycentrics));
  return most;
}

std::uint8_t brightness_of(float irradiance, float mean) {
  std::uint8_t brightness = 0;
  float bound = bright * mean;
  for (; brightness + 1 < brightness_classes && irradiance > bound; bound *= brighter) ++brightness;
  return brightness;
}

VertexLight light_at_vertices(const World& world, const SamplingMesh& mesh, bool backs_count, Task& task) {
  const SideLight light(world, task, {backs_count ? CellSides::all : CellSides::lit});
  VertexLight result;
  for (std::uint32_t v = 0; v < mesh.vertices().size(); ++v) {
    const MeshVertex& vertex = mesh.vertices()[v];
    const auto sites = mesh.sites(v);
    const bool front = std::any_of(sites.begin(), sites.end(), [&](const VertexSite& site) {
      return light.is_reached(site.scene_triangle, vertex.front, site.barycentrics);
    });
    // Of a black back is_reached() says nothing, as nothing comes back from there.
    const bool back = backs_count && !front && !world.scene().objects[vertex.object].two_sided &&
                      irradiance_beside(light, sites, false) > SideLight::sealed_share * light.mean();
    result.reached.push_back(front ? Reached::front : back ? Reached::back : Reached::nowhere);
    result.brightness.push_back(brightness_of(irradiance_beside(light, sites, vertex.front), light.mean()));
  }
  return result;
}

/// The number of what may share a disc with the vertex.
std::vector<std::uint32_t> labels_of(const World& world, const SamplingMesh& mesh, std::span<const Reached> reached,
                                     std::size_t wanted) {
  const auto& objects = world.scene().objects;
  const bool by_material = objects.size() * discs_a_label > wanted;
  std::vector<std::uint32_t> labels;
  labels.reserve(mesh.vertices().size());
  for (std::size_t v = 0; v < reached.size(); ++v) {
    const MeshVertex& vertex = mesh.vertices()[v];
    const Object& object = objects[vertex.object];
    // The backs of one-sided and of two-sided surfaces are not alike.
    const std::uint32_t owner = by_material ? 2 * object.material + (object.two_sided ? 1U : 0U) : vertex.object;
    labels.push_back(4 * owner + (vertex.front ? 0U : 2U) + (reached[v] == Reached::back ? 1U : 0U));
  }
  return labels;
}

/// Clusters of some of the vertices, numbered from `first` on.
std::uint32_t cluster(const SamplingMesh& mesh, std::span<const std::uint32_t> labels, std::span<const std::uint32_t> members,
                      std::size_t wanted, std::uint32_t first, std::vector<std::uint32_t>& of_vertex, Task& task) {
  if (members.empty()) return first;
  std::vector<Place> places;
  places.reserve(members.size());
  for (const std::uint32_t vertex : members) {
    const MeshVertex& at = mesh.vertices()[vertex];
    places.push_back({at.position, at.normal, at.area, labels[vertex]});
  }
  const std::vector<std::uint32_t> found = cluster_places(places, {wanted, least_cosine}, task);
  for (std::size_t i = 0; i < members.size(); ++i) of_vertex[members[i]] = first + found[i];
  return first + static_cast<std::uint32_t>(cluster_count(found));
}

/// Numbers the parts of a disc that stands on both sides of an obstacle; one without. Those vertices that stand for the others
/// get theirs.
std::uint32_t find_parts(const World& world, const SamplingMesh& mesh, std::span<const std::uint32_t> members,
                         std::span<const std::uint32_t> representatives, std::vector<std::uint8_t>& part_of_vertex,
                         RayStream& rays) {
  const auto& vertices = mesh.vertices();
  Vec3 middle(0.0F);
  double area = 0.0;
  for (const std::uint32_t v : members) middle += vertices[v].position, area += static_cast<double>(vertices[v].area);
  middle /= static_cast<float>(members.size());
  const float height = static_cast<float>(std::sqrt(area / pi_double));
  std::vector<std::uint32_t> left(representatives.begin(), representatives.end());
  std::uint32_t parts = 0;
  while (!left.empty() && parts < most_parts) {
    const auto squared = [&](std::uint32_t v) {
      const Vec3 d = vertices[v].position - middle;
      return glm::dot(d, d);
    };
    const std::uint32_t from =
        *std::min_element(left.begin(), left.end(), [&](std::uint32_t a, std::uint32_t b) { return squared(a) < squared(b); });
    const Lookout at(world, mesh, from, height, rays);
    std::vector<std::uint32_t> beyond;
    for (const std::uint32_t v : left) {
      part_of_vertex[v] = static_cast<std::uint8_t>(parts);
      if (v != from && !at.sees(Lookout(world, mesh, v, height, rays), rays)) beyond.push_back(v);
    }
    left = std::move(beyond);
    ++parts;
  }
  for (const std::uint32_t v : left) part_of_vertex[v] = static_cast<std::uint8_t>(parts - 1);
  return parts;
}

/// Gives what obstacles part elements of their own.
void part(const World& world, const SamplingMesh& mesh, Merging& merging, Task& task) {
  const Grouped members(merging.of_vertex, merging.elements);
  const Representatives representatives(mesh, members, task);
  std::vector<std::uint8_t> part_of_vertex(merging.of_vertex.size(), 0);
  std::vector<std::uint32_t> parts(merging.elements, 1);
  task.parallel_chunks(merging.elements, cluster_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    for (std::size_t e = range.begin; e < range.end; ++e)
      if (merging.reached[e] != Reached::nowhere) {
        parts[e] = find_parts(world, mesh, members.of(e), representatives.of(e), part_of_vertex, rays);
        for (const std::uint32_t v : members.of(e)) part_of_vertex[v] = part_of_vertex[representatives.of_vertex(v)];
      }
  });
  std::vector<std::uint32_t> first(merging.elements, 0);
  std::vector<Reached> reached;
  for (std::size_t e = 0; e < merging.elements; ++e) {
    first[e] = static_cast<std::uint32_t>(reached.size());
    reached.insert(reached.end(), parts[e], merging.reached[e]);
  }
  for (std::uint32_t v = 0; v < merging.of_vertex.size(); ++v)
    merging.of_vertex[v] = first[merging.of_vertex[v]] + part_of_vertex[v];
  merging.elements = reached.size();
  merging.reached = std::move(reached);
}

/// The vertices of one kind, which are merged by themselves.
struct Kind {
  std::vector<std::uint32_t> members;
  double weight = 0.0;  ///< m², times how many more discs they are to have
};

/// All clusters of the vertices, not yet parted. Of what light reaches each class of brightness has its share of the discs.
Merging clustered(const SamplingMesh& mesh, const VertexLight& light, std::span<const std::uint32_t> labels, std::size_t wanted,
                  Task& task) {
  std::array<Kind, brightness_classes> lit;
  Kind sealed;
  double weight = 0.0;
  for (std::uint32_t v = 0; v < labels.size(); ++v) {
    if (light.reached[v] == Reached::nowhere) {
      sealed.members.push_back(v);
      continue;
    }
    Kind& kind = lit[light.brightness[v]];
    kind.members.push_back(v);
    const double own =
        static_cast<double>(mesh.vertices()[v].area) * std::pow(static_cast<double>(brighter), light.brightness[v]);
    kind.weight += own, weight += own;
  }
  const bool all_sealed = sealed.members.size() == labels.size();
  const std::size_t of_sealed = sealed.members.empty() ? 0
                                : all_sealed           ? wanted
                                                       : std::max<std::size_t>(1, wanted / sealed_share);
  Merging merging;
  merging.of_vertex.assign(labels.size(), 0);
  std::uint32_t first = 0;
  for (const Kind& kind : lit) {
    const double share = weight > 0.0 ? kind.weight / weight : 1.0;
    const auto own = static_cast<std::size_t>(share * static_cast<double>(wanted - of_sealed));
    first = cluster(mesh, labels, kind.members, std::max<std::size_t>(1, own), first, merging.of_vertex, task);
  }
  merging.elements = cluster(mesh, labels, sealed.members, of_sealed, first, merging.of_vertex, task);
  merging.reached.resize(merging.elements);
  for (std::size_t v = 0; v < labels.size(); ++v) merging.reached[merging.of_vertex[v]] = light.reached[v];
  return merging;
}

}  // namespace

Merging merge_discs(const World& world, const SamplingMesh& mesh, std::size_t wanted, bool backs_count, Task& task) {
  const VertexLight light = light_at_vertices(world, mesh, backs_count, task);
  const std::vector<std::uint32_t> labels = labels_of(world, mesh, light.reached, wanted);
  std::size_t clusters = wanted;
  for (int attempt = 1; !task.cancelled(); ++attempt) {
    Merging merging = clustered(mesh, light, labels, clusters, task);
    if (attempt == most_attempts) return merging;
    part(world, mesh, merging, task);
    if (merging.elements <= most_more * wanted) return merging;
    clusters = std::max<std::size_t>(1, clusters * wanted / merging.elements);
  }
  return {};
}

}  // namespace gibench::antiradiance
