#include "methods/spectral/vertex_light.h"

#include <algorithm>

#include "common/core/random.h"
#include "common/core/sampling.h"
#include "common/core/sobol.h"

namespace gibench::spectral {

namespace {

constexpr std::uint64_t point_stage = 0x706f696e74ULL, light_stage = 0x6c69676874ULL, site_stage = 0x73697465ULL;
constexpr std::size_t triangle_chunk = 64, slot_chunk = 256;

/// What a triangle's points bring to its corners.
struct Share {
  std::array<Rgb, 3> light;
  std::array<float, 3> weight{};
};

/// How many points triangles have. Those of less than `unit` m² have their share of a whole triangle's: what is left over is
/// handed on to the next.
class PointCounts {
 public:
  template <class AreaOf>
  PointCounts(std::size_t triangles, int points, float unit, const AreaOf& area_of)
      : counts_(triangles), points_(static_cast<float>(points)), unit_(unit) {
    float left_over = 0.5F;
    for (std::uint32_t t = 0; t < triangles; ++t) {
      const float area = area_of(t);
      if (area >= unit) {
        counts_[t] = static_cast<std::uint32_t>(points);
        continue;
      }
      left_over += points_ * area / unit;
      counts_[t] = static_cast<std::uint32_t>(left_over);
      left_over -= static_cast<float>(counts_[t]);
    }
  }
  std::uint32_t of(std::uint32_t triangle) const { return counts_[triangle]; }
  /// m², that one of its points stands for.
  float area_of_point(float area_of_triangle) const { return std::max(unit_, area_of_triangle) / points_; }

 private:
  std::vector<std::uint32_t> counts_;
  float points_, unit_;
};

/// m²: half of what a node of a mesh in clusters covers; 0 where every vertex is a node.
float unit_of(const Nodes& nodes) {
  if (nodes.are_vertices()) return 0.0F;
  double area = 0.0, count = 0.0;
  for (std::uint32_t node = 0; node < nodes.size(); ++node)
    if (nodes[node].reached) area += static_cast<double>(nodes[node].area), ++count;
  return count > 0.0 ? static_cast<float>(0.5 * area / count) : 0.0F;
}

class TriangleLight {
 public:
  TriangleLight(const World& world, const Transfer& transfer, const DirectLight& light, const Settings& settings,
                std::uint64_t seed)
      : world_(world), transfer_(transfer), light_(light), settings_(settings), seed_(seed) {}

  /// Of triangles [begin, end).
  void find_shares(std::uint32_t begin, std::uint32_t end, const PointCounts& counts, RayStream& rays,
                   std::vector<Share>& shares) const {
    std::vector<MeshPoint> points;
    std::vector<SurfaceSample> samples;
    std::vector<std::uint64_t> keys;
    for (std::uint32_t triangle = begin; triangle < end; ++triangle) {
      const SobolSequence places(mix_keys(seed_, point_stage, triangle));
      for (std::uint32_t i = 0; i < counts.of(triangle); ++i) {
        const Vec2 at = uniform_triangle(places.pair(i, 0).unit());
        points.push_back({triangle, {1.0F - at.x - at.y, at.x, at.y}});
        samples.push_back(sample_at(points.back()));
        keys.push_back(mix_keys(mix_keys(seed_, light_stage), triangle, i));
      }
    }
    std::vector<Rgb> arriving(samples.size());
    light_.irradiance(samples, keys, settings_.direct_samples, rays, arriving);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::uint32_t triangle = points[i].triangle;
      const float area = counts.area_of_point(area_of(triangle));
      const MeshPoint seen = transfer_.interpolation.seen(world_, *transfer_.mesh, points[i], samples[i].position, rays);
      Share& share = shares[triangle];
      for (std::size_t c = 0; c < 3; ++c) {
        share.light[c] += arriving[i] * (seen.weights[c] * area);
        share.weight[c] += seen.weights[c] * area;
      }
    }
  }

  /// At the sites of a node.
  Rgb light_at_sites(std::uint32_t node, RayStream& rays) const {
    std::vector<SurfaceSample> samples;
    std::vector<std::uint64_t> keys;
    for (const auto& [vertex, site] : transfer_.nodes.sites(node)) {
      if (samples.size() == static_cast<std::size_t>(settings_.direct_points)) break;
      samples.push_back(transfer_.mesh->sample(world_, vertex, site));
      keys.push_back(mix_keys(mix_keys(seed_, site_stage), node, samples.size()));
    }
    std::vector<Rgb> arriving(samples.size());
    light_.irradiance(samples, keys, settings_.direct_samples, rays, arriving);
    Rgb sum;
    for (const Rgb& each : arriving) sum += each / static_cast<float>(arriving.size());
    return sum;
  }

  float area_of(std::uint32_t triangle) const {
    return 0.5F * glm::length(glm::cross(corner(triangle, 1) - corner(triangle, 0), corner(triangle, 2) - corner(triangle, 0)));
  }

 private:
  Vec3 corner(std::uint32_t triangle, std::size_t i) const {
    return transfer_.mesh->vertices()[transfer_.mesh->triangles()[triangle].corners[i]].position;
  }
  SurfaceSample sample_at(const MeshPoint& point) const {
    const MeshFace& face = transfer_.mesh->faces()[transfer_.mesh->triangles()[point.triangle].face];
    const Vec3& front = world_.normal(face.scene_triangle);
    // Any point of the triangle's plane will do as its barycentrics; the position is that of the mesh point.
    SurfaceSample sample = world_.sample_at(face.scene_triangle, Vec2(1.0F / 3.0F), face.front ? front : -front);
    sample.position = Vec3(0.0F);
    for (std::size_t i = 0; i < 3; ++i) sample.position += point.weights[i] * corner(point.triangle, i);
    return sample;
  }

  const World& world_;
  const Transfer& transfer_;
  const DirectLight& light_;
  const Settings& settings_;
  std::uint64_t seed_;
};

}  // namespace

std::vector<Rgb4> direct_irradiance(const World& world, const Transfer& transfer, const DirectLight& light,
                                    const Settings& settings, Task& task) {
  const SamplingMesh& mesh = *transfer.mesh;
  std::vector<Share> shares(mesh.triangles().size());
  const TriangleLight source(world, transfer, light, settings, task.seed());
  const PointCounts counts(shares.size(), settings.direct_points, unit_of(transfer.nodes),
                           [&](std::uint32_t triangle) { return source.area_of(triangle); });
  task.parallel_chunks(shares.size(), triangle_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    source.find_shares(static_cast<std::uint32_t>(range.begin), static_cast<std::uint32_t>(range.end), counts, rays, shares);
  });
  std::vector<Rgb4> sum(transfer.basis.slots());
  std::vector<float> weight(sum.size(), 0.0F);
  for (std::uint32_t t = 0; t < shares.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      if (!(shares[t].weight[c] > 0.0F)) continue;
      transfer.weights.each(mesh.triangles()[t].corners[c], [&](std::uint32_t slot, float part) {
        sum[slot] = Rgb(sum[slot]) + shares[t].light[c] * part;
        weight[slot] += shares[t].weight[c] * part;
      });
    }
  task.parallel_chunks(sum.size(), slot_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    for (std::size_t slot = range.begin; slot < range.end; ++slot) {
      if (weight[slot] > 0.0F) sum[slot] = Rgb(sum[slot]) / weight[slot];
      else if (!transfer.nodes.are_vertices()) sum[slot] = source.light_at_sites(transfer.node_of_slot[slot], rays);
    }
  });
  return sum;
}

}  // namespace gibench::spectral
