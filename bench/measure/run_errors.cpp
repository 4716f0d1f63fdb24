#include "bench/measure/run_errors.h"

#include <algorithm>

#include "common/core/error.h"
#include "common/metrics/automatic_exposure.h"
#include "common/metrics/errors.h"

namespace gibench {

namespace {

/// The replicates of one component.
Replicas component_of(const ReferenceValues& values, Component component) {
  if (component == Component::direct) return values.direct;
  if (component == Component::indirect) return values.indirect;
  return Replicas::sum(values.direct, values.indirect);
}

std::vector<Rgb> component_of(const Answers& answers, Component component) {
  if (component == Component::direct) return answers.direct;
  if (component == Component::indirect) return answers.indirect;
  return answers.total();
}

void check_sizes(const ReferenceValues& values, const Answers& answers, Domain where) {
  if (values.direct.size() != answers.direct.size() || values.indirect.size() != answers.indirect.size())
    throw InputError(std::string("the stored reference, ") + to_string(where), "holds more or fewer values than were asked for",
                     "it is damaged: remove its folder and make it again");
}

void check_comparable(const Replicas& all, const Replicas& some) {
  if (all.size() != some.size() || all.count() < 2 || some.count() < 2)
    throw InputError("the stored reference of the method's light paths", "does not fit that of all paths",
                     "remove its folder and make it again");
}

}  // namespace

namespace {

/// One component of the answers of every seed.
std::vector<std::vector<Rgb>> surface_values(const Answers& own, std::span<const SeedAnswers> other_seeds, Component component) {
  std::vector<std::vector<Rgb>> values{component_of(own, component)};
  for (const SeedAnswers& other : other_seeds) values.push_back(component_of(other.surface, component));
  return values;
}

std::vector<std::vector<Rgb>> image_values(const Answers& own, std::span<const SeedAnswers> other_seeds, Component component) {
  std::vector<std::vector<Rgb>> values{component_of(own, component)};
  for (const SeedAnswers& other : other_seeds) values.push_back(component_of(*other.image, component));
  return values;
}

}  // namespace

ComponentErrors errors_against(const Reference& reference, const Answers& surface, const std::optional<Answers>& image,
                               const Exposure& exposure, std::span<const SeedAnswers> other_seeds) {
  check_sizes(reference.surface, surface, Domain::surface);
  if (image) check_sizes(reference.image, *image, Domain::image);
  ComponentErrors errors;
  for (const Component component : all_components) {
    if (!surface.direct.empty())
      errors[component][Domain::surface] =
          value_errors(surface_values(surface, other_seeds, component), component_of(reference.surface, component));
    if (!image) continue;
    const Camera& camera = *reference.question.camera;
    errors[component][Domain::image] = image_errors(camera.width, camera.height, image_values(*image, other_seeds, component),
                                                    component_of(reference.image, component), exposure);
  }
  return errors;
}

namespace {

MetricPairs terms_of_metrics(std::span<const std::vector<Rgb>> values, const Replicas& reference) {
  MetricPairs terms;
  for (const char* metric : paired_metrics)
    if (auto found = pair_terms(metric, values, reference)) terms.emplace(metric, std::move(*found));
  return terms;
}

}  // namespace

PairRecord pairs_against(const Reference& reference, const RunOutcome& outcome) {
  const ReferenceFacts& facts = outcome.record.reference.value();
  PairRecord pairs{facts.key, facts.samples_per_replica, facts.replicas, {}};
  for (const Component component : all_components) {
    if (!outcome.surface.direct.empty())
      pairs.errors[component][Domain::surface] = terms_of_metrics(surface_values(outcome.surface, outcome.other_seeds, component),
                                                                  component_of(reference.surface, component));
    if (outcome.image)
      pairs.errors[component][Domain::image] = terms_of_metrics(image_values(*outcome.image, outcome.other_seeds, component),
                                                                component_of(reference.image, component));
  }
  return pairs;
}

namespace {

/// Replicates of all paths' values, moved so that the difference to `fixed` has the noise of all_r − some_r: their halves'
/// differences are then independent estimates of what is lacking, and their mean is that of all paths.
Replicas against_fixed(const Replicas& all, const Replicas& some, const std::vector<Rgb>& fixed) {
  Replicas moved;
  const std::size_t count = std::min(all.count(), some.count()) / 2 * 2;
  for (std::size_t r = 0; r < count; ++r) {
    moved.replicas.push_back(all.replicas[r]);
    for (std::size_t i = 0; i < fixed.size(); ++i) moved.replicas[r][i] += fixed[i] - some.replicas[r][i];
  }
  return moved;
}

}  // namespace

ComponentErrors model_errors(const Reference& all, const Reference& some, const Exposure& exposure) {
  ComponentErrors errors;
  for (const Component component : all_components) {
    if (const Replicas of_all = component_of(all.surface, component), of_some = component_of(some.surface, component);
        of_all.size() > 0) {
      check_comparable(of_all, of_some);
      const std::vector<Rgb> fixed = of_some.mean();
      errors[component][Domain::surface] = value_errors(fixed, against_fixed(of_all, of_some, fixed));
    }
    const Replicas of_all = component_of(all.image, component), of_some = component_of(some.image, component);
    if (of_all.size() == 0) continue;
    check_comparable(of_all, of_some);
    const std::vector<Rgb> fixed = of_some.mean();
    const Camera& camera = *all.question.camera;
    errors[component][Domain::image] =
        image_errors(camera.width, camera.height, fixed, against_fixed(of_all, of_some, fixed), exposure);
  }
  return errors;
}

Exposure exposure_for(const Scene& scene, std::span<const Rgb> total) {
  return scene.exposure ? *scene.exposure : automatic_exposure(total);
}

}  // namespace gibench
