#include "methods/pathtracer/path_estimator.h"

#include <algorithm>

#include "common/core/sampling.h"

namespace gibench::pathtracer {

namespace {

// A path of a lossless scene would never end: one in two hundred is stopped, the others stand in for it.
constexpr float most_survival = 0.995F;

}  // namespace

/// Where a path scatters.
struct PathEstimator::Vertex {
  SurfaceSample at;
  const Scattering* surface;
  Frame frame;
  Vec3 outgoing;  // local, unit
};

/// The state of a path between two vertices.
struct PathEstimator::Walk {
  SobolSampler& random;
  RayStream& rays;
  Rgb throughput{1.0F};
  int bounce = 0;  // reflections between the current vertex and the surface asked about
  PathLight light{};

  void collect(const Rgb& radiance) { (bounce == 0 ? light.direct : light.indirect) += throughput * radiance; }
};

PathEstimator::PathEstimator(const World& world, const LightSampler& lights, std::optional<int> max_bounces, int roulette_bounce)
    : world_(world), lights_(lights), max_bounces_(max_bounces), roulette_bounce_(roulette_bounce) {
  for (const Material& material : world.scene().materials) scattering_.emplace_back(material);
  for (const Object& object : world.scene().objects) material_of_object_.push_back(object.material);
}

/// Next-event estimate: each lobe's share weighed against that lobe's own sampling.
void PathEstimator::collect_by_light(Walk& walk, const Vertex& vertex) const {
  const Vec2 choice = walk.random.next_pair();
  const auto sample = lights_.sample(vertex.at, choice.x, walk.random.next_pair());
  if (!sample) return;
  const Vec3 incoming = vertex.frame.to_local(sample->direction);
  Rgb weight;
  for (const Lobe lobe : {Lobe::diffuse, Lobe::glossy}) {
    const float probability = vertex.surface->probability(lobe);
    if (!(probability > 0.0F)) continue;
    const float own = sample->delta ? 0.0F : probability * vertex.surface->pdf(lobe, vertex.outgoing, incoming);
    weight += vertex.surface->times_cosine(lobe, vertex.outgoing, incoming) * power_heuristic(sample->pdf, own);
  }
  if (is_black(weight) || walk.rays.occluded(sample->shadow)) return;
  walk.collect(weight * sample->radiance / sample->pdf);
}

/// Follows a direction of one lobe to the next vertex and collects the emission met there. False: the path ends.
bool PathEstimator::extend(Walk& walk, Vertex& vertex) const {
  const Vec2 choice = walk.random.next_pair();
  const Lobe lobe = vertex.surface->choose(choice.x);
  const LobeSample sample = vertex.surface->sample(lobe, vertex.outgoing, walk.random.next_pair());
  if (is_black(sample.weight)) return false;
  const float probability = vertex.surface->probability(lobe);
  walk.throughput *= sample.weight / probability;
  const Vec3 direction = vertex.frame.to_world(sample.incoming);
  const Hit hit = walk.rays.closest_hit({world_.ray_origin(vertex.at), 0.0F, direction});
  const auto share = [&](float light_pdf) {
    return lobe == Lobe::mirror ? 1.0F : power_heuristic(probability * sample.pdf, light_pdf);
  };
  if (!hit) {
    if (lights_.has_environment())
      walk.collect(lights_.environment(direction) * share(lights_.pdf_of_environment(direction, vertex.at.normal)));
    return false;
  }
  const SurfaceSample next = world_.sample_of_hit(hit, direction);
  if (!next.lit_side) return false;
  if (const Rgb emitted = lights_.emission(next.triangle, true); !is_black(emitted))
    walk.collect(emitted * share(lights_.pdf_of_hit(vertex.at.position, next)));
  const Frame frame(next.normal);
  vertex = {next, &scattering_[material_of_object_[next.object]], frame, frame.to_local(-direction)};
  return true;
}

/// Russian roulette on the throughput; survivors carry what the others would have brought.
bool PathEstimator::survives(Walk& walk) const {
  if (walk.bounce < roulette_bounce_) return true;
  const float survival = std::min(most_survival, largest(walk.throughput));
  if (walk.random.next_pair().x >= survival) return false;
  walk.throughput /= survival;
  return true;
}

PathLight PathEstimator::trace(const SurfaceSample& at, const Scattering& surface, const Vec3& toward_viewer,
                               SobolSampler& random, RayStream& rays) const {
  Walk walk{random, rays};
  const Frame frame(at.normal);
  Vertex vertex{at, &surface, frame, frame.to_local(toward_viewer)};
  for (;; ++walk.bounce) {
    collect_by_light(walk, vertex);
    if (!extend(walk, vertex)) break;
    if (max_bounces_ && walk.bounce >= *max_bounces_) break;
    if (!survives(walk)) break;
  }
  return walk.light;
}

PathLight PathEstimator::irradiance(const SurfaceSample& at, SobolSampler& random, RayStream& rays) const {
  if (!at.lit_side) return {};
  // A receiver of irradiance is a white diffuse surface: E = π L.
  static const Scattering white = Scattering::diffuse_only(Rgb(1.0F));
  PathLight light = trace(at, white, at.normal, random, rays);
  light.direct *= pi;
  light.indirect *= pi;
  return light;
}

PathLight PathEstimator::radiance(const SurfaceSample& at, const Vec3& toward_viewer, SobolSampler& random,
                                  RayStream& rays) const {
  if (!at.lit_side) return {};
  PathLight light = trace(at, scattering_[material_of_object_[at.object]], toward_viewer, random, rays);
  light.direct += lights_.emission(at.triangle, true);
  return light;
}

PathLight PathEstimator::radiosity(const SurfaceSample& at, SobolSampler& random, RayStream& rays) const {
  const Vec3 toward_viewer = Frame(at.normal).to_world(square_to_cosine_hemisphere(random.next_pair()));
  PathLight light = radiance(at, toward_viewer, random, rays);
  light.direct *= pi;
  light.indirect *= pi;
  return light;
}

float PathEstimator::accessibility(const SurfaceSample& at, SobolSampler& random, RayStream& rays) const {
  const Vec3 direction = Frame(at.normal).to_world(square_to_cosine_hemisphere(random.next_pair()));
  return rays.occluded({world_.ray_origin(at), 0.0F, direction}) ? 0.0F : 1.0F;
}

}  // namespace gibench::pathtracer
