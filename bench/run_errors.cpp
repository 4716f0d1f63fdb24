#include "bench/run_errors.h"

#include "common/core/error.h"
#include "common/metrics/errors.h"

namespace gibench {

namespace {

/// The replicates of one component.
Replicas component_of(const ReferenceValues& values, const std::string& component) {
  if (component == "direct") return values.direct;
  if (component == "indirect") return values.indirect;
  return Replicas::sum(values.direct, values.indirect);
}

std::vector<Rgb> component_of(const Answers& answers, const std::string& component) {
  if (component == "direct") return answers.direct;
  if (component == "indirect") return answers.indirect;
  return answers.total();
}

void check_sizes(const ReferenceValues& values, const Answers& answers, const char* where) {
  if (values.direct.size() != answers.direct.size() || values.indirect.size() != answers.indirect.size())
    throw InputError(std::string("the stored reference, ") + where, "holds another number of values than were asked for",
                     "it is damaged: remove its folder and make it again");
}

}  // namespace

std::map<std::string, DomainErrors> errors_against(const Reference& reference, const RunOutcome& outcome,
                                                   const Exposure& exposure) {
  check_sizes(reference.surface, outcome.surface, "surface");
  if (outcome.image) check_sizes(reference.image, *outcome.image, "image");
  std::map<std::string, DomainErrors> errors;
  for (const char* component : {"direct", "indirect", "total"}) {
    if (!outcome.surface.direct.empty())
      errors[component]["surface"] =
          value_errors(component_of(outcome.surface, component), component_of(reference.surface, component));
    if (!outcome.image) continue;
    const Camera& camera = *outcome.record.question.camera;
    errors[component]["image"] = image_errors(camera.width, camera.height, component_of(*outcome.image, component),
                                              component_of(reference.image, component), exposure);
  }
  return errors;
}

Exposure exposure_for(const Scene& scene, std::span<const Rgb> total) {
  return scene.exposure ? *scene.exposure : automatic_exposure(total);
}

}  // namespace gibench
