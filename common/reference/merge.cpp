#include "common/reference/merge.h"

#include "common/core/error.h"

namespace gibench {

namespace {

void check_mergeable(bool agree, const std::string& problem) {
  if (!agree)
    throw InputError("reference", "two parts cannot be merged: " + problem, "make both parts from the same call and version");
}

bool same_view(const std::optional<Camera>& a, const std::optional<Camera>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->position == b->position && a->look_at == b->look_at && a->up == b->up &&
         a->vertical_fov_degrees == b->vertical_fov_degrees && a->width == b->width && a->height == b->height;
}

void check_same_question(const ReferenceQuestion& a, const ReferenceQuestion& b) {
  check_mergeable(a.path_class == b.path_class, "their path classes are " + a.path_class + " and " + b.path_class);
  check_mergeable(a.seed == b.seed && a.surface_samples == b.surface_samples && a.pixel_samples == b.pixel_samples,
                  "their seeds or numbers of samples differ");
  check_mergeable(a.surface_domain == b.surface_domain,
                  "their surface domains are " + a.surface_domain + " and " + b.surface_domain);
  check_mergeable(same_view(a.camera, b.camera), "their cameras differ");
}

void check_same_shape(const Replicas& a, const Replicas& b) {
  check_mergeable(a.count() == b.count(),
                  "they have " + std::to_string(a.count()) + " and " + std::to_string(b.count()) + " replicates");
  check_mergeable(a.size() == b.size(), "they have " + std::to_string(a.size()) + " and " + std::to_string(b.size()) + " values");
}

/// into ← (1 − share) into + share more, in double.
void blend(Replicas& into, const Replicas& more, double share) {
  for (std::size_t r = 0; r < into.count(); ++r)
    for (std::size_t i = 0; i < into.size(); ++i)
      into.replicas[r][i] = Rgb((1.0 - share) * RgbDouble(into.replicas[r][i]) + share * RgbDouble(more.replicas[r][i]));
}

/// Both components by the numbers of their samples, which are added up.
void blend(ReferenceValues& into, std::uint64_t& samples, const ReferenceValues& more, std::uint64_t more_samples) {
  if (more_samples == 0) return;
  samples += more_samples;
  const double share = static_cast<double>(more_samples) / static_cast<double>(samples);
  for (const auto component : {&ReferenceValues::direct, &ReferenceValues::indirect})
    blend(into.*component, more.*component, share);
}

}  // namespace

void merge(Reference& into, const Reference& more) {
  check_same_question(into.question, more.question);
  check_mergeable(into.points == 0 || more.points == 0 || into.points == more.points, "their surface samples differ");
  for (const auto component : {&ReferenceValues::direct, &ReferenceValues::indirect}) {
    if (more.samples_per_replica > 0) check_same_shape(into.surface.*component, more.surface.*component);
    if (more.image_samples_per_replica > 0) check_same_shape(into.image.*component, more.image.*component);
  }
  blend(into.surface, into.samples_per_replica, more.surface, more.samples_per_replica);
  blend(into.image, into.image_samples_per_replica, more.image, more.image_samples_per_replica);
  into.seconds += more.seconds;
}

}  // namespace gibench
