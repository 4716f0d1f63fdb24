#include "methods/pathtracer/path_batch.h"

#include <algorithm>
#include <cmath>

#include "common/core/sampling.h"

namespace gibench::pathtracer {

namespace {

constexpr int lossless_reflections = 256;  // after so many, even a path that lost nothing may end at random …
constexpr float most_survival = 0.998F;    // … with this probability to go on: a closed world of mirrors comes to an end

}  // namespace

PathBatch::PathBatch(const PathScene& scene, const SceneLights& lights, const PathRules& rules, const Settings& settings,
                     const PathBounds& bounds, RayStream& rays)
    : scene_(scene),
      lights_(lights),
      rules_(rules),
      settings_(settings),
      bounds_(bounds),
      next_event_(lights, static_cast<float>(settings.light_samples)),
      rays_(rays) {
  paths_.reserve(capacity);
  ray_.reserve(capacity);
  pending_.reserve(capacity);
  pending_number_.reserve(capacity);
  hit_.resize(capacity);
  occluded_.resize(capacity);
}

void PathBatch::trace(const AskedSurface& asked, std::span<const PathRandom> random, std::span<PathLight> light) {
  random_ = random;
  light_ = light;
  std::fill(light.begin(), light.end(), PathLight());
  if (!asked.lit || lights_.empty() || rules_.nothing()) return;
  start(asked);
  const int last = bounds_.indirect ? bounds_.most_reflections : 0;
  for (int reflection = 0; reflection <= last && !paths_.empty(); ++reflection) {
    if (reflection > 0 || bounds_.direct)
      for (std::uint32_t sample = 0; sample < settings_.light_samples; ++sample)
        for (const LightGroup group : lights_.groups()) sample_lights(reflection, group, sample);
    if (reflection == last && !lights_.can_be_hit()) return;
    scatter(reflection);
    arrive(reflection);
  }
}

void PathBatch::trace_openness(const AskedSurface& asked, std::span<const PathRandom> random, std::span<PathLight> light) {
  std::fill(light.begin(), light.end(), PathLight());
  if (!asked.lit) return;
  ray_.clear();
  const Frame frame(asked.normal);
  for (const PathRandom& path : random)
    ray_.push_back({asked.origin, 0.0F, frame.to_world(cosine_hemisphere(path.pair(0, Use::direction).unit()))});
  rays_.occlusions(ray_, {occluded_.data(), ray_.size()});
  for (std::size_t i = 0; i < random.size(); ++i) light[i].direct = Rgb(occluded_[i] ? 0.0F : 1.0F);
}

void PathBatch::start(const AskedSurface& asked) {
  paths_.clear();
  for (std::uint32_t number = 0; number < random_.size(); ++number) {
    Path path{asked.position,    asked.normal, asked.origin, asked.out, &asked.bsdf,
              Rgb(asked.factor), 1.0F,         0.0F,         number,    PathAutomaton::start};
    if (asked.draws_out) path.out = Frame(asked.normal).to_world(cosine_hemisphere(random_[number].pair(0, Use::out).unit()));
    paths_.push_back(path);
  }
}

/// Next-event estimation: one way to a light of the group from every path's newest vertex.
void PathBatch::sample_lights(int reflection, LightGroup group, std::uint32_t light_sample) {
  ray_.clear();
  pending_.clear();
  pending_number_.clear();
  for (const Path& path : paths_) {
    if (path.bsdf->is_delta()) continue;
    const PathRandom& random = random_[path.number];
    const std::uint32_t choice =
        lights_.has_choice(group) ? random.light_pair(reflection, LightUse::choice, group, light_sample).x : 0U;
    add_light_sample(path, lights_.sample(group, path.position, path.normal, choice,
                                          random.light_pair(reflection, LightUse::place, group, light_sample).unit()));
  }
  if (rules_.tests_visibility()) rays_.occlusions(ray_, {occluded_.data(), ray_.size()});
  else std::fill_n(occluded_.begin(), ray_.size(), std::uint8_t{0});
  for (std::size_t i = 0; i < ray_.size(); ++i) {
    if (occluded_[i]) continue;
    PathLight& light = light_[pending_number_[i]];
    (reflection == 0 ? light.direct : light.indirect) += pending_[i];
  }
}

/// Each lobe's light counts where the path that it ends does; both weigh against a walk by the lobes that may walk.
void PathBatch::add_light_sample(const Path& path, const LightSample& light) {
  if (!(light.pdf > 0.0F)) return;
  const PathEvent event = light.delta ? PathEvent::light : light.at_infinity ? PathEvent::background : PathEvent::emitter;
  const Lobes lit = rules_.lit_lobes(path.state, *path.bsdf, event);
  if (lit == Lobes::none) return;
  const Frame frame(path.normal);
  const Vec3 in = frame.to_local(light.direction), out = frame.to_local(path.out);
  const Lobes walking = rules_.walking_lobes(path.state, *path.bsdf);
  LobeValues values = path.bsdf->evaluate_lobes(out, in, walking | lit);
  if (!contains(lit, Lobes::diffuse)) values.diffuse = Rgb();
  if (!contains(lit, Lobes::specular)) values.specular = Rgb();
  // A light that rays can meet counts by no lobe that may not walk, so that the density is that of the walk.
  const float factor = in.z * next_event_.weight(light, values.pdf) / next_event_.density(light);
  const Rgb contribution = path.throughput * (values.diffuse + values.specular) * light.radiance * factor;
  if (is_black(contribution)) return;
  ray_.push_back(light.shadow_ray(path.origin));
  pending_.push_back(contribution);
  pending_number_.push_back(path.number);
}

/// Draws the ray that leaves every path's newest vertex; paths that carry nothing any more end.
void PathBatch::scatter(int reflection) {
  ray_.clear();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    Path path = paths_[i];
    const PathRandom& random = random_[path.number];
    const Vec2 choices = random.pair(reflection, Use::lobe_and_roulette).unit();
    const Frame frame(path.normal);
    const Vec3 out = frame.to_local(path.out);
    const Lobes lobes = rules_.walking_lobes(path.state, *path.bsdf);
    const BsdfSample sample = path.bsdf->sample(out, choices.x, random.pair(reflection, Use::direction).unit(), lobes);
    if (is_black(sample.weight)) continue;
    const auto state = path.state;
    const bool tell_apart = lobes == Lobes::both && rules_.after_diffuse(state) != rules_.after_specular(state, *path.bsdf);
    take_lobe(path, sample, lobes, out, tell_apart ? random.pair(reflection, Use::lobe_class).unit().x : 0.0F);
    if (is_black(path.throughput)) continue;
    if (reflection == 0) path.scale = largest(path.throughput);
    if (!survives(path, reflection, choices.y)) continue;
    path.pdf = sample.pdf;
    ray_.push_back({path.origin, 0.0F, frame.to_world(sample.in)});
    paths_[kept++] = path;
  }
  paths_.resize(kept);
}

/// Weighs the path and tells it which lobe scattered. Where that makes a difference, it is drawn for the direction that was
/// sampled, each lobe with its share of the value there: the walk by either is estimated without bias.
void PathBatch::take_lobe(Path& path, const BsdfSample& sample, Lobes lobes, const Vec3& out, float random) const {
  const auto diffuse = rules_.after_diffuse(path.state), specular = rules_.after_specular(path.state, *path.bsdf);
  if (lobes != Lobes::both || diffuse == specular || path.bsdf->is_diffuse() || sample.delta) {
    const bool by_specular = lobes == Lobes::specular || sample.delta;
    path.throughput *= sample.weight;
    path.state = by_specular ? specular : diffuse;
    return;
  }
  const LobeValues values = path.bsdf->evaluate_lobes(out, sample.in, lobes);
  const float share = largest(values.diffuse) / (largest(values.diffuse) + largest(values.specular));
  const bool is_diffuse = random < share;
  const float probability = is_diffuse ? share : 1.0F - share;
  path.throughput *= (is_diffuse ? values.diffuse : values.specular) * (sample.in.z / (sample.pdf * probability));
  path.state = is_diffuse ? diffuse : specular;
}

/// Russian roulette on the throughput relative to the first vertex's (Arvo and Kirk 1990): a survivor carries more.
bool PathBatch::survives(Path& path, int reflection, float random) const {
  if (reflection < settings_.roulette_start) return true;
  float survival = largest(path.throughput) / (path.scale * settings_.roulette_below);
  if (reflection >= lossless_reflections) survival = std::min(survival, most_survival);
  if (survival >= 1.0F) return true;
  if (random >= survival) return false;
  path.throughput *= 1.0F / survival;
  return true;
}

/// Follows the rays to what they meet, takes its light, and makes it the paths' newest vertex.
void PathBatch::arrive(int reflection) {
  rays_.closest_hits(ray_, {hit_.data(), ray_.size()});
  const bool wanted = reflection > 0 || bounds_.direct;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    Path path = paths_[i];
    const Vec3& direction = ray_[i].direction;
    if (wanted && rules_.accepts(path.state, hit_[i] ? PathEvent::emitter : PathEvent::background)) {
      const Rgb met =
          hit_[i] ? emission_met(path, hit_[i], direction) : next_event_.environment(path.normal, direction, path.pdf);
      PathLight& light = light_[path.number];
      (reflection == 0 ? light.direct : light.indirect) += path.throughput * met;
    }
    if (hit_[i] && rules_.goes_on(path.state) && reach(path, hit_[i], direction)) paths_[kept++] = path;
  }
  paths_.resize(kept);
}

/// False where the path meets a back: it is black.
bool PathBatch::reach(Path& path, const Hit& hit, const Vec3& direction) {
  const PathTriangle& triangle = scene_.triangles[hit.triangle];
  const bool front = glm::dot(triangle.normal, direction) <= 0.0F;
  if (!front && triangle.two_sided == 0U) return false;
  SurfaceSample sample;
  sample.position = path.position = triangle.position(hit);
  sample.normal = path.normal = front ? triangle.normal : -triangle.normal;
  sample.triangle = hit.triangle;
  path.origin = scene_.world.ray_origin(sample);
  path.out = -direction;
  path.bsdf = &scene_.bsdfs[triangle.material];
  return true;
}

/// Emission of the surface that the ray met, weighed against the light samples that could have found it.
Rgb PathBatch::emission_met(const Path& path, const Hit& hit, const Vec3& direction) const {
  const PathTriangle& triangle = scene_.triangles[hit.triangle];
  const float cosine = -glm::dot(triangle.normal, direction);
  return next_event_.emission(path.position, path.normal,
                              {hit.triangle, triangle.material, hit.distance, cosine, triangle.two_sided != 0U}, path.pdf);
}

}  // namespace gibench::pathtracer
