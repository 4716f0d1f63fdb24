#include "methods/pathtracer/path_batch.h"

#include <algorithm>
#include <cmath>

#include "common/core/sampling.h"
#include "common/ray/ray_offset.h"

namespace gibench::pathtracer {

namespace {

constexpr int lossless_reflections = 256;    // after so many, even a path that lost nothing may end at random …
constexpr float most_survival = 0.998F;      // … with this probability to go on: a closed world of mirrors comes to an end
constexpr std::size_t prefetched_ahead = 8;  // paths

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
  keys_.reserve(capacity);
  indices_.reserve(capacity);
  ray_.reserve(capacity);
  pending_.reserve(capacity);
  pending_number_.reserve(capacity);
  x_.resize(capacity);
  y_.resize(capacity);
  x_bits_.resize(capacity);
  y_bits_.resize(capacity);
  hit_.resize(capacity);
  occluded_.resize(capacity);
}

void PathBatch::trace(std::span<const PathStart> starts, std::span<PathLight> light) {
  light_ = light;
  std::fill(light.begin(), light.end(), PathLight());
  if (lights_.empty() || rules_.nothing()) return;
  start(starts);
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

void PathBatch::trace_openness(std::span<const PathStart> starts, std::span<PathLight> light) {
  std::fill(light.begin(), light.end(), PathLight());
  start(starts);
  draw({0, Use::direction});
  ray_.clear();
  for (std::size_t i = 0; i < paths_.size(); ++i)
    ray_.push_back({paths_[i].origin, 0.0F, Frame(paths_[i].normal).to_world(cosine_hemisphere({x_[i], y_[i]}))});
  rays_.occlusions(ray_, {occluded_.data(), ray_.size()});
  for (std::size_t i = 0; i < paths_.size(); ++i) light[paths_[i].number].direct = Rgb(occluded_[i] ? 0.0F : 1.0F);
}

/// Paths of values that are zero anyway do not begin.
void PathBatch::start(std::span<const PathStart> starts) {
  paths_.clear();
  keys_.clear();
  indices_.clear();
  for (std::uint32_t number = 0; number < starts.size(); ++number) {
    const AskedSurface& asked = *starts[number].asked;
    if (!asked.lit) continue;
    const PathRandom& random = starts[number].random;
    Path path{asked.position,    asked.normal, asked.origin, asked.out, asked.bsdf,
              Rgb(asked.factor), 1.0F,         0.0F,         number,    PathAutomaton::start};
    if (asked.draws_out) path.out = Frame(asked.normal).to_world(cosine_hemisphere(random.pair({0, Use::out}).unit()));
    paths_.push_back(path);
    keys_.push_back(random.key);
    indices_.push_back(random.index);
  }
}

/// Moves a path up to the place behind those that are kept already.
void PathBatch::keep(std::size_t path, std::size_t kept) {
  if (path == kept) return;
  paths_[kept] = paths_[path];
  keys_[kept] = keys_[path];
  indices_[kept] = indices_[path];
}

void PathBatch::end_all_but(std::size_t kept) {
  paths_.resize(kept);
  keys_.resize(kept);
  indices_.resize(kept);
}

/// A pair of numbers for every path.
void PathBatch::draw(Dimension dimension) {
  draw_pairs(keys_, indices_, dimension, {x_.data(), keys_.size()}, {y_.data(), keys_.size()});
}

/// Next-event estimation: one way to a light of the group from every path's newest vertex.
void PathBatch::sample_lights(int reflection, LightGroup group, std::uint32_t light_sample) {
  ray_.clear();
  pending_.clear();
  pending_number_.clear();
  if (lights_.has_choice(group) || has_places(group))
    draw_pairs(keys_, indices_, {reflection, group, light_sample}, {x_bits_.data(), keys_.size()},
               {y_bits_.data(), keys_.size()});
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    const Path& path = paths_[i];
    if (!path.bsdf->is_delta())
      add_light_sample(path, lights_.sample(group, path.position, path.normal, SobolPair{x_bits_[i], y_bits_[i]}));
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
  const float cosine = glm::dot(path.normal, light.direction);
  if (!(cosine > 0.0F)) return;
  const LobeValues values = reflected(path, light.direction, cosine, lit);
  // A light that rays can meet counts by no lobe that may not walk, so that the density is that of the walk.
  const float factor = cosine * next_event_.weight(light, values.pdf) / next_event_.density(light);
  const Rgb contribution = path.throughput * (values.diffuse + values.specular) * light.radiance * factor;
  if (is_black(contribution)) return;
  ray_.push_back(light.shadow_ray(path.origin));
  pending_.push_back(contribution);
  pending_number_.push_back(path.number);
}

/// What the lit lobes reflect from a direction above the horizon, and the density of the walk in that direction.
LobeValues PathBatch::reflected(const Path& path, const Vec3& direction, float cosine, Lobes lit) const {
  if (path.bsdf->is_diffuse()) {
    if (!contains(lit, Lobes::diffuse)) return {};
    return {path.bsdf->diffuse_albedo() * (1.0F / pi), Rgb(), cosine_hemisphere_pdf(cosine)};
  }
  const Frame frame(path.normal);
  const Lobes walking = rules_.walking_lobes(path.state, *path.bsdf);
  LobeValues values = path.bsdf->evaluate_lobes(frame.to_local(path.out), frame.to_local(direction), walking | lit);
  if (!contains(lit, Lobes::diffuse)) values.diffuse = Rgb();
  if (!contains(lit, Lobes::specular)) values.specular = Rgb();
  return values;
}

/// Draws the ray that leaves every path's newest vertex; paths that carry nothing any more end.
void PathBatch::scatter(int reflection) {
  draw({reflection, Use::direction});
  ray_.clear();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < paths_.size(); ++i)
    if (scatter(i, reflection)) keep(i, kept++);
  end_all_but(kept);
}

bool PathBatch::scatter(std::size_t number, int reflection) {
  Path& path = paths_[number];
  const PathRandom random{keys_[number], indices_[number]};
  const Frame frame(path.normal);
  const Vec2 u{x_[number], y_[number]};
  const Vec3 in = path.bsdf->is_diffuse() ? scatter_evenly(path, u) : scatter_by_lobe(path, frame, u, reflection, random);
  if (is_black(path.throughput)) return false;
  if (reflection == 0) path.scale = largest(path.throughput);
  if (!survives(path, reflection, random)) return false;
  ray_.push_back({path.origin, 0.0F, frame.to_world(in)});
  return true;
}

/// From a diffuse surface; the path carries nothing any more where it may not walk.
Vec3 PathBatch::scatter_evenly(Path& path, Vec2 u) const {
  const Vec3 in = DiffuseLobe::sample(u);
  path.pdf = DiffuseLobe::pdf(in);
  const bool walks = path.pdf > 0.0F && contains(rules_.walking_lobes(path.state, *path.bsdf), Lobes::diffuse);
  path.throughput *= walks ? path.bsdf->diffuse_albedo() : Rgb();
  path.state = rules_.after_diffuse(path.state);
  return in;
}

/// From any other surface, likewise.
Vec3 PathBatch::scatter_by_lobe(Path& path, const Frame& frame, Vec2 u, int reflection, const PathRandom& random) const {
  const Vec3 out = frame.to_local(path.out);
  const Lobes lobes = rules_.walking_lobes(path.state, *path.bsdf);
  const float choice = path.bsdf->is_delta() ? 0.0F : random.pair({reflection, Use::lobe_and_roulette}).unit().x;
  const BsdfSample sample = path.bsdf->sample(out, choice, u, lobes);
  path.pdf = sample.pdf;
  if (is_black(sample.weight)) {
    path.throughput = Rgb();
    return sample.in;
  }
  const bool tell_apart =
      lobes == Lobes::both && rules_.after_diffuse(path.state) != rules_.after_specular(path.state, *path.bsdf);
  take_lobe(path, sample, lobes, out, tell_apart ? random.pair({reflection, Use::lobe_class}).unit().x : 0.0F);
  return sample.in;
}

/// Weighs the path and tells it which lobe scattered. Where that makes a difference, it is drawn for the direction that was
/// sampled, each lobe with its share of the value there: the walk by either is estimated without bias.
void PathBatch::take_lobe(Path& path, const BsdfSample& sample, Lobes lobes, const Vec3& out, float random) const {
  const auto diffuse = rules_.after_diffuse(path.state), specular = rules_.after_specular(path.state, *path.bsdf);
  if (lobes != Lobes::both || diffuse == specular || sample.delta) {
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
bool PathBatch::survives(Path& path, int reflection, const PathRandom& random) const {
  if (reflection < settings_.roulette_start) return true;
  float survival = largest(path.throughput) / (path.scale * settings_.roulette_below);
  if (reflection >= lossless_reflections) survival = std::min(survival, most_survival);
  if (survival >= 1.0F) return true;
  if (random.pair({reflection, Use::lobe_and_roulette}).unit().y >= survival) return false;
  path.throughput *= 1.0F / survival;
  return true;
}

/// Follows the rays to what they meet, takes its light, and makes it the paths' newest vertex.
void PathBatch::arrive(int reflection) {
  rays_.closest_hits(ray_, {hit_.data(), ray_.size()});
  const bool wanted = reflection > 0 || bounds_.direct;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    if (i + prefetched_ahead < paths_.size()) scene_.prefetch_triangle(hit_[i + prefetched_ahead]);
    Path& path = paths_[i];
    const Vec3& direction = ray_[i].direction;
    if (wanted && rules_.accepts(path.state, hit_[i] ? PathEvent::emitter : PathEvent::background)) {
      const Rgb met =
          hit_[i] ? emission_met(path, hit_[i], direction) : next_event_.environment(path.normal, direction, path.pdf);
      PathLight& light = light_[path.number];
      (reflection == 0 ? light.direct : light.indirect) += path.throughput * met;
    }
    if (hit_[i] && rules_.goes_on(path.state) && reach(path, hit_[i], direction)) keep(i, kept++);
  }
  end_all_but(kept);
}

/// False where the path meets a back: it is black.
bool PathBatch::reach(Path& path, const Hit& hit, const Vec3& direction) const {
  const PathTriangle& triangle = scene_.triangles[hit.triangle];
  const bool front = glm::dot(triangle.normal, direction) <= 0.0F;
  if (!front && triangle.two_sided == 0U) return false;
  path.position = triangle.position(hit);
  path.normal = front ? triangle.normal : -triangle.normal;
  path.origin = path.position + ray_offset(max_abs(path.position), triangle.extent) * path.normal;
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
