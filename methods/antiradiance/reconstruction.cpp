#include "methods/antiradiance/reconstruction.h"

#include <algorithm>
#include <cmath>

namespace gibench::antiradiance {

namespace {

constexpr float beside = 0.1F;         // of the cell's extent: a mean further than that from the vertex is not the vertex's
constexpr float fewest_of_own = 0.5F;  // of a mean's weights, below which the vertex cannot be derived from it
constexpr int sweeps = 4;

/// Barycentrics of the second and third corner of a point in the plane of a scene triangle.
Vec2 barycentrics_of(const Scene& scene, std::uint32_t triangle, const Vec3& point) {
  const auto& [i, j, k] = scene.triangles[triangle].corners;
  const Vec3d a = scene.vertices[i], b = Vec3d(scene.vertices[j]) - a, c = Vec3d(scene.vertices[k]) - a, p = Vec3d(point) - a;
  const double bb = glm::dot(b, b), bc = glm::dot(b, c), cc = glm::dot(c, c), pb = glm::dot(p, b), pc = glm::dot(p, c);
  const double determinant = bb * cc - bc * bc;
  if (!(determinant > 0.0)) return {0.0F, 0.0F};
  return {static_cast<float>((pb * cc - pc * bc) / determinant), static_cast<float>((pc * bb - pb * bc) / determinant)};
}

bool outside(const Vec2& at) { return at.x < -1e-4F || at.y < -1e-4F || at.x + at.y > 1.0F + 1e-4F; }

/// A point of a cell as a sample; a part of a quad names the first of its two triangles.
SurfaceSample sample_of(const World& world, const CellPoint& point) {
  const Scene& scene = world.scene();
  SurfaceSample sample;
  sample.position = 0.5F * (point.origin + point.behind);
  sample.normal = point.normal;
  sample.triangle = point.triangle;
  sample.barycentrics = barycentrics_of(scene, sample.triangle, sample.position);
  const std::uint32_t next = sample.triangle + 1;
  if (outside(sample.barycentrics) && next < scene.triangles.size() &&
      scene.triangle_face[next] == scene.triangle_face[sample.triangle])
    sample.triangle = next, sample.barycentrics = barycentrics_of(scene, next, sample.position);
  sample.barycentrics = glm::clamp(sample.barycentrics, 0.0F, 1.0F);
  return sample;
}

float within(float value, float mean) {
  return mean >= 0.0F ? std::clamp(value, 0.0F, 2.0F * mean) : std::clamp(value, 2.0F * mean, 0.0F);
}

}  // namespace

Reconstruction::Place Reconstruction::place(const World& world, const SamplingMesh& mesh, const Elements& elements,
                                            const SurfaceSample& sample) {
  Place result;
  const bool front = glm::dot(sample.normal, world.normal(sample.triangle)) >= 0.0F;
  if (!mesh.covers(sample.triangle, front)) return result;
  const MeshPoint at = mesh.locate(sample.triangle, sample.barycentrics, front);
  result.elements = mesh.triangles()[at.triangle].corners;
  float sum = 0.0F;
  for (std::size_t k = 0; k < 3; ++k) {
    result.weights[k] = elements.exposed_share(result.elements[k]) > 0.0F ? at.weights[k] : 0.0F;
    result.in_doubt |= elements.exposed_share(result.elements[k]) < 1.0F;
    sum += result.weights[k];
  }
  for (float& weight : result.weights) weight = sum > 1e-6F ? weight / sum : 0.0F;
  return result;
}

Reconstruction::Reconstruction(const World& world, const SamplingMesh& mesh, const Elements& elements) {
  for (std::uint32_t element = 0; element < elements.size(); ++element) {
    if (!(elements.exposed_share(element) > 0.0F)) continue;
    const float offset = glm::length(elements.disc(element).centre - mesh.vertices()[element].position);
    if (offset <= beside * elements.reach(element)) continue;
    Row row{element, static_cast<std::uint32_t>(weights_.size()), 0, 0.0F};
    float count = 0.0F;
    for (const CellPoint& point : elements.points(element)) {
      if (!point.exposed) continue;
      const Place at = place(world, mesh, elements, sample_of(world, point));
      count += 1.0F;
      for (std::size_t k = 0; k < 3; ++k) {
        if (at.elements[k] == element) {
          row.own += at.weights[k];
          continue;
        }
        const auto known = std::find_if(weights_.begin() + row.begin, weights_.end(),
                                        [&](const Weight& weight) { return weight.element == at.elements[k]; });
        if (known == weights_.end()) weights_.push_back({at.elements[k], at.weights[k]});
        else known->share += at.weights[k];
      }
    }
    if (!(row.own > fewest_of_own * count)) {
      weights_.resize(row.begin);
      continue;
    }
    row.end = static_cast<std::uint32_t>(weights_.size());
    row.own /= count;
    for (std::uint32_t i = row.begin; i < row.end; ++i) weights_[i].share /= count;
    rows_.push_back(row);
  }
}

std::vector<Rgb> Reconstruction::vertex_values(std::span<const Rgb> means) const {
  std::vector<Rgb> values(means.begin(), means.end());
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const Row& row : rows_) {
      Rgb others;
      for (std::uint32_t i = row.begin; i < row.end; ++i) others += values[weights_[i].element] * weights_[i].share;
      const Rgb& mean = means[row.element];
      for (int c = 0; c < 3; ++c) values[row.element][c] = within((mean[c] - others[c]) / row.own, mean[c]);
    }
  return values;
}

}  // namespace gibench::antiradiance
