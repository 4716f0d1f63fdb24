#include "methods/spectral/vertex_light.h"

#include "common/core/random.h"
#include "common/core/sampling.h"
#include "common/core/sobol.h"

namespace gibench::spectral {

namespace {

constexpr std::uint64_t point_stage = 0x706f696e74ULL, light_stage = 0x6c69676874ULL;
constexpr std::size_t triangle_chunk = 64;

/// What a triangle's points bring to its corners.
struct Share {
  std::array<Rgb, 3> light;
  std::array<float, 3> weight{};
};

class TriangleLight {
 public:
  TriangleLight(const World& world, const Transfer& transfer, const DirectLight& light, const Settings& settings,
                std::uint64_t seed)
      : world_(world), transfer_(transfer), light_(light), settings_(settings), seed_(seed) {}

  /// Of triangles [begin, end).
  void find_shares(std::uint32_t begin, std::uint32_t end, RayStream& rays, std::vector<Share>& shares) const {
    std::vector<MeshPoint> points;
    std::vector<SurfaceSample> samples;
    std::vector<std::uint64_t> keys;
    for (std::uint32_t triangle = begin; triangle < end; ++triangle) {
      const SobolSequence places(mix_keys(seed_, point_stage, triangle));
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(settings_.direct_points); ++i) {
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
      const float area = area_of(triangle) / static_cast<float>(settings_.direct_points);
      const MeshPoint seen = transfer_.interpolation.seen(world_, *transfer_.mesh, points[i], samples[i].position, rays);
      Share& share = shares[triangle];
      for (std::size_t c = 0; c < 3; ++c) {
        share.light[c] += arriving[i] * (seen.weights[c] * area);
        share.weight[c] += seen.weights[c] * area;
      }
    }
  }

 private:
  Vec3 corner(std::uint32_t triangle, std::size_t i) const {
    return transfer_.mesh->vertices()[transfer_.mesh->triangles()[triangle].corners[i]].position;
  }
  float area_of(std::uint32_t triangle) const {
    return 0.5F * glm::length(glm::cross(corner(triangle, 1) - corner(triangle, 0), corner(triangle, 2) - corner(triangle, 0)));
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
  task.parallel_chunks(shares.size(), triangle_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    source.find_shares(static_cast<std::uint32_t>(range.begin), static_cast<std::uint32_t>(range.end), rays, shares);
  });
  std::vector<Rgb4> sum(transfer.basis.slots());
  std::vector<float> weight(sum.size(), 0.0F);
  for (std::size_t t = 0; t < shares.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t slot = transfer.slot_of_vertex[mesh.triangles()[t].corners[c]];
      sum[slot] = Rgb(sum[slot]) + shares[t].light[c];
      weight[slot] += shares[t].weight[c];
    }
  for (std::size_t slot = 0; slot < sum.size(); ++slot)
    if (weight[slot] > 0.0F) sum[slot] = Rgb(sum[slot]) / weight[slot];
  return sum;
}

}  // namespace gibench::spectral
