#include "methods/antiradiance/reconstruction.h"

#include <algorithm>
#include <cmath>

#include "methods/antiradiance/cell_crossings.h"
#include "methods/antiradiance/parted_triangles.h"

namespace gibench::antiradiance {

namespace {

constexpr float beside = 0.1F;         // of the cell's extent: a mean further than that from the vertex is not the vertex's
constexpr float fewest_of_own = 0.5F;  // of a mean's weights, below which the vertex cannot be derived from it
constexpr int sweeps = 4;

/// Whether a sample sees the element of a corner, or of merged ones the corner.
class Seen {
 public:
  Seen(const World& world, const SamplingMesh& mesh, const Elements& elements, const SurfaceSample& sample, RayStream& rays)
      : world_(world), mesh_(mesh), elements_(elements), rays_(rays), face_{sample.face} {
    here_.origin = world.ray_origin(sample);
    here_.normal = sample.normal;
  }
  bool operator()(const Reconstruction::Place& place, std::size_t k) const {
    if (elements_.merging().merges())
      return nothing_between(world_, here_, corner_point(world_, mesh_, place.triangle, k), face_, rays_);
    const auto points = elements_.points(place.vertices[k]);
    return std::any_of(points.begin(), points.end(), [&](const CellPoint& point) {
      return point.exposed && nothing_between(world_, here_, point, face_, rays_);
    });
  }

 private:
  const World& world_;
  const SamplingMesh& mesh_;
  const Elements& elements_;
  RayStream& rays_;
  CellPoint here_;
  std::array<std::uint32_t, 1> face_;
};

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
  result.triangle = at.triangle;
  result.vertices = mesh.triangles()[at.triangle].corners;
  float sum = 0.0F;
  for (std::size_t k = 0; k < 3; ++k) {
    const float exposed = elements.exposed_share(elements.of_vertex(result.vertices[k]));
    result.weights[k] = exposed > 0.0F ? at.weights[k] : 0.0F;
    result.in_doubt |= exposed < 1.0F;
    sum += result.weights[k];
  }
  for (float& weight : result.weights) weight = sum > 1e-6F ? weight / sum : 0.0F;
  return result;
}

Reconstruction::Reconstruction(const World& world, const SamplingMesh& mesh, const Elements& elements, const Hierarchy& hierarchy,
                               std::span<const std::uint8_t> parted_triangles, Task& task) {
  if (elements.merging().merges()) {
    smooth_.emplace(world, mesh, elements, hierarchy, task);
    return;
  }
  for (std::uint32_t element = 0; element < elements.size(); ++element) {
    if (!(elements.exposed_share(element) > 0.0F)) continue;
    const float offset = glm::length(elements.disc(element).centre - mesh.vertices()[element].position);
    if (offset <= beside * elements.reach(element)) continue;
    Row row{element, static_cast<std::uint32_t>(weights_.size()), 0, 0.0F};
    float count = 0.0F;
    bool parted = false;
    for (const CellPoint& point : elements.points(element)) {
      if (!point.exposed) continue;
      const Place at = place(world, mesh, elements, sample_of(world, point));
      parted |= !parted_triangles.empty() && parted_triangles[at.triangle] != 0;
      count += 1.0F;
      for (std::size_t k = 0; k < 3; ++k) {
        if (at.vertices[k] == element) {
          row.own += at.weights[k];
          continue;
        }
        const auto known = std::find_if(weights_.begin() + row.begin, weights_.end(),
                                        [&](const Weight& weight) { return weight.element == at.vertices[k]; });
        if (known == weights_.end()) weights_.push_back({at.vertices[k], at.weights[k]});
        else known->share += at.weights[k];
      }
    }
    // Of a parted triangle not all corners are known to count: its elements keep their means.
    if (parted || !(row.own > fewest_of_own * count)) {
      weights_.resize(row.begin);
      continue;
    }
    row.end = static_cast<std::uint32_t>(weights_.size());
    row.own /= count;
    for (std::uint32_t i = row.begin; i < row.end; ++i) weights_[i].share /= count;
    rows_.push_back(row);
  }
}

bool Reconstruction::leave_hidden_out(const World& world, const SamplingMesh& mesh, const Elements& elements,
                                      const SurfaceSample& sample, RayStream& rays, Place& place) {
  const Seen sees(world, mesh, elements, sample, rays);
  std::array<float, 3> seen{};
  float sum = 0.0F;
  for (std::size_t k = 0; k < 3; ++k)
    if (place.weights[k] > 0.0F && sees(place, k)) seen[k] = place.weights[k], sum += seen[k];
  if (!(sum > 0.0F)) return false;
  for (std::size_t k = 0; k < 3; ++k) place.weights[k] = seen[k] / sum;
  return true;
}

std::optional<std::size_t> Reconstruction::heaviest_seen(const World& world, const SamplingMesh& mesh, const Elements& elements,
                                                         const SurfaceSample& sample, RayStream& rays, Place place) {
  const Seen sees(world, mesh, elements, sample, rays);
  while (place.covered()) {
    const auto k = static_cast<std::size_t>(std::max_element(place.weights.begin(), place.weights.end()) - place.weights.begin());
    if (sees(place, k)) return k;
    place.weights[k] = 0.0F;
  }
  return std::nullopt;
}

std::vector<Rgb> Reconstruction::vertex_values(std::span<const Rgb> means) const {
  if (smooth_) return smooth_->vertex_values(means);
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
