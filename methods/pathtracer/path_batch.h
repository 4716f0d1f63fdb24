/// Paths of any values, some thousands at a time, all advanced by one reflection before any is advanced by two: their rays
/// leave in full packets, whatever the number of paths that a value has.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/lighting/next_event.h"
#include "common/lighting/scene_lights.h"
#include "common/ray/ray_stream.h"
#include "methods/pathtracer/asked_surface.h"
#include "methods/pathtracer/path_random.h"
#include "methods/pathtracer/path_rules.h"
#include "methods/pathtracer/path_scene.h"
#include "methods/pathtracer/settings.h"

namespace gibench::pathtracer {

/// Which light is wanted.
struct PathBounds {
  bool direct = true, indirect = true;
  int most_reflections = 0;  ///< between a light and the asked surface; for indirect light
};

/// A path that is to be traced.
struct PathStart {
  const AskedSurface* asked = nullptr;
  PathRandom random;
};

/// What one path brought, in the value's unit.
struct PathLight {
  Rgb direct, indirect;
};

/// One thread's workspace.
class PathBatch {
 public:
  static constexpr std::size_t capacity = 2048;  ///< paths

  PathBatch(const PathScene& scene, const SceneLights& lights, const PathRules& rules, const Settings& settings,
            const PathBounds& bounds, RayStream& rays);

  /// Traces at most `capacity` paths; `light` is as long.
  void trace(std::span<const PathStart> starts, std::span<PathLight> light);
  /// Accessibility: one cosine-distributed ray for each path; 1 in `direct` where it meets no surface.
  void trace_openness(std::span<const PathStart> starts, std::span<PathLight> light);

 private:
  /// A path at its newest vertex.
  struct Path {
    Vec3 position, normal;  ///< of the lit side, in world space
    Vec3 origin;            ///< of rays that leave
    Vec3 out;               ///< unit, towards the vertex before
    const SurfaceBsdf* bsdf;
    Rgb throughput;      ///< from the light leaving along −out … to the value
    float scale = 1.0F;  ///< largest channel of the throughput after the first vertex
    float pdf = 0.0F;    ///< with which the ray that leaves was drawn, 1/sr; 0: by a mirror
    std::uint32_t number = 0;
    PathRules::State state = PathAutomaton::start;  ///< before the newest vertex scatters
  };

  void start(std::span<const PathStart> starts);
  void keep(std::size_t path, std::size_t kept);
  void end_all_but(std::size_t kept);
  void draw(Dimension dimension);
  void sample_lights(int reflection, LightGroup group, std::uint32_t light_sample);
  void add_light_sample(const Path& path, const LightSample& light);
  void scatter(int reflection);
  bool scatter(std::size_t number, int reflection);
  Vec3 scatter_evenly(Path& path, Vec2 u) const;
  Vec3 scatter_by_lobe(Path& path, const Frame& frame, Vec2 u, int reflection, const PathRandom& random) const;
  LobeValues reflected(const Path& path, const Vec3& direction, float cosine, Lobes lit) const;
  void take_lobe(Path& path, const BsdfSample& sample, Lobes lobes, const Vec3& out, float random) const;
  bool survives(Path& path, int reflection, const PathRandom& random) const;
  void arrive(int reflection);
  bool reach(Path& path, const Hit& hit, const Vec3& direction) const;
  Rgb emission_met(const Path& path, const Hit& hit, const Vec3& direction) const;

  const PathScene& scene_;
  const SceneLights& lights_;
  const PathRules& rules_;
  const Settings settings_;
  const PathBounds bounds_;
  const NextEvent next_event_;
  RayStream& rays_;

  std::span<PathLight> light_;
  // Columns of the paths still alive.
  std::vector<Path> paths_;
  std::vector<std::uint64_t> keys_;
  std::vector<std::uint32_t> indices_;
  std::vector<float> x_, y_;                    ///< a pair of random numbers each
  std::vector<std::uint32_t> x_bits_, y_bits_;  ///< likewise, as fractions
  std::vector<Ray> ray_;
  std::vector<Hit> hit_;
  std::vector<std::uint8_t> occluded_;
  std::vector<Rgb> pending_;  ///< what each shadow ray brings if it is free
  std::vector<std::uint32_t> pending_number_;
};

}  // namespace gibench::pathtracer
