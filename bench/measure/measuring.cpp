#include "bench/measure/measuring.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/measure/cancellation.h"
#include "common/core/error.h"

namespace gibench {

namespace {

Answers shade(const MethodSession& method, Quantity quantity, std::span<const SurfaceSample> samples,
              std::span<const Vec3> toward_viewer, Task& task) {
  Answers answers;
  answers.direct.resize(samples.size());
  answers.indirect.resize(samples.size());
  if (method.knows_variance(quantity)) answers.total_variance.resize(samples.size());
  answers.report =
      method.shade({quantity, samples, toward_viewer}, {answers.direct, answers.indirect, {}, {}, answers.total_variance}, task);
  return answers;
}

}  // namespace

std::optional<Camera> chosen_camera(const Scene& scene, const MeasuringOptions& options) {
  if (!options.pictures) return std::nullopt;
  std::optional<Camera> camera;
  std::string known;
  for (const Camera& candidate : scene.cameras) {
    if (!camera && (options.camera.empty() || candidate.name == options.camera)) camera = candidate;
    known += (known.empty() ? "" : ", ") + candidate.name;
  }
  if (!camera && !options.camera.empty())
    throw InputError("--camera", fmt::format("the scene has no camera '{}'", options.camera),
                     known.empty() ? "it has none" : "known: " + known);
  if (camera && options.image_width > 0) {
    const double scale = static_cast<double>(options.image_width) / camera->width;
    camera->width = options.image_width;
    camera->height = std::max(1, static_cast<int>(std::lround(scale * camera->height)));
  }
  return camera;
}

std::string path_class(std::optional<int> bounces) {
  // The surface that the camera sees reflects once itself, so n reflections before it make n + 1 events.
  return bounces ? fmt::format("C.{{0,{}}}[LOB]", *bounces + 1) : "C.*[LOB]";
}

ReferenceQuestion question_of(const Scene& scene, const MeasuringOptions& options) {
  ReferenceQuestion question{
      path_class(options.bounces), options.reference_seed,
      options.surface_samples,     chosen_camera(scene, options),
      options.pixel_samples,       to_string(surface_domain_of(options.surface_domain, scene, "--surface-domain"))};
  if (!options.light_paths.empty()) question.path_class = options.light_paths;
  // An expression and a bound together are written as both.
  if (!options.light_paths.empty() && options.bounces) question.path_class += " & " + path_class(options.bounces);
  return question;
}

ReferenceQuestion restricted_to(ReferenceQuestion question, const std::string& light_paths) {
  question.path_class = light_paths;
  return question;
}

MeasuringPoints measuring_points(const World& world, const ReferenceQuestion& question, int threads) {
  MeasuringPoints points;
  const SurfaceDomain domain = surface_domain_of(question.surface_domain, world.scene(), "--surface-domain");
  points.surface = domain_samples(world, domain, question.surface_samples, question.seed, threads, &points.domain);
  if (points.surface.empty() && world.total_area() > 0.0)
    throw InputError(
        "--surface-domain", "no camera sees a surface that light can leave",
        "turn a camera to the scene, or give all or names of objects; where a model is inside out, the camera sees black "
        "backs (gibench check tells)");
  if (question.camera) {
    const DirectLight light(world, Lighting::of(world.scene()));
    points.camera = camera_points(world, light, *question.camera, question.pixel_samples, question.seed, threads);
  }
  return points;
}

std::vector<Rgb> Answers::total() const {
  std::vector<Rgb> sum = direct;
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += indirect[i];
  return sum;
}

Answers shade_surface(const MethodSession& method, const MeasuringPoints& points, Task& task) {
  return shade(method, Quantity::irradiance, points.surface, {}, task);
}

Answers shade_image(const MethodSession& method, const MeasuringPoints& points, bool background, Task& task) {
  const CameraPoints& camera = *points.camera;
  Answers answers = shade(method, Quantity::radiance, camera.samples, camera.toward_viewer, task);
  answers.direct = camera.pixel_means(answers.direct);
  answers.indirect = camera.pixel_means(answers.indirect);
  if (!answers.total_variance.empty()) answers.total_variance = camera.pixel_variances(answers.total_variance);
  for (std::size_t i = 0; background && i < camera.pixel_count(); ++i) answers.direct[i] += camera.background[i];
  return answers;
}

void require_success(const StageReport& report, const std::string& method, const std::string& stage) {
  if (succeeded(report.termination)) return;
  stop_if_cancelled();
  throw WorkError(fmt::format("{}, {}: {}{}{}", method, stage, to_string(report.termination), report.message.empty() ? "" : ": ",
                              report.message));
}

}  // namespace gibench
