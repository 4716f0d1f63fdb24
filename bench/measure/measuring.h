/// The points at which every method is asked for light, and its answers there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/measure/camera_points.h"
#include "common/method/method_session.h"
#include "common/reference/reference_store.h"
#include "common/spaces/surface_domain.h"

namespace gibench {

/// What is compared: the same for every method on a scene.
struct MeasuringOptions {
  std::size_t surface_samples = 2048;
  std::string surface_domain;        ///< seen, all, whole or names of objects; empty: seen where the scene has a camera, else all
  int pixel_samples = 4;             ///< camera rays per pixel, a square number
  std::string camera;                ///< name; empty: the scene's first
  std::optional<int> bounces;        ///< reflections between a light and the surface asked about; empty: all
  std::string light_paths;           ///< of a reference: only these paths; empty: all
  std::uint64_t reference_seed = 1;  ///< of the surface samples, the camera rays and the reference
  bool pictures = true;              ///< false: surface samples alone
  int image_width = 0;               ///< pixels, the camera's shape kept; 0: the camera's own resolution
};

/// The camera that the options name, scaled to the width that they ask for; empty for a scene without cameras and where no
/// pictures are wanted.
/// Throws InputError for an unknown name, the known ones listed.
std::optional<Camera> chosen_camera(const Scene& scene, const MeasuringOptions& options);

/// The question that the stored reference of these options answers.
ReferenceQuestion question_of(const Scene& scene, const MeasuringOptions& options);

/// OSL light-path expression of all paths with at most so many reflections before the surface that the camera sees.
std::string path_class(std::optional<int> bounces);
/// The question about these paths instead of all that `bounces` allows: an expression that keeps the bound itself.
ReferenceQuestion restricted_to(ReferenceQuestion question, const std::string& light_paths);

struct MeasuringPoints {
  std::vector<SurfaceSample> surface;  ///< irradiance is asked here, W/m²
  DomainFacts domain;                  ///< of the surface samples
  std::optional<CameraPoints> camera;  ///< radiance is asked here, W/(m² sr)
};
MeasuringPoints measuring_points(const World& world, const ReferenceQuestion& question, int threads);

/// Values at the surface samples or at the pixels.
struct Answers {
  std::vector<Rgb> direct, indirect;
  std::vector<Rgb> total_variance;  ///< empty where the method does not know it
  StageReport report;

  std::vector<Rgb> total() const;
};
/// A method that was lit, asked at the points; the report says whether the answers may be used.
Answers shade_surface(const MethodSession& method, const MeasuringPoints& points, Task& task);
/// `background`: light that comes straight from behind the scene belongs to the answer.
Answers shade_image(const MethodSession& method, const MeasuringPoints& points, bool background, Task& task);

/// Throws WorkError, method and stage named, for a stage whose answer may not be used.
void require_success(const StageReport& report, const std::string& method, const std::string& stage);

}  // namespace gibench
