/// What surfaces do to light does not depend on units or axes, and ends where they reflect nothing.
#include <fmt/format.h>

#include <optional>

#include "common/effects/scene_effects.h"
#include "common/method/method_session.h"
#include "common/scene/made_scenes.h"
#include "tests/contract/compare.h"
#include "tests/contract/contract.h"
#include "tests/contract/run.h"
#include "tests/contract/scenes.h"

namespace gibench::contract {

namespace {

/// The plain box, against itself moved at the same points of its surfaces.
class StillBox {
 public:
  explicit StillBox(const MethodEntry& entry)
      : entry_(entry),
        quantities_(light_quantities(entry)),
        samples_(samples_of(world_)),
        answers_(fresh_answers(entry, world_, quantities_, samples_)) {}

  void require_unmoved_by(float scale, const Vec3& axis, float degrees, const std::string& what) const {
    const World moved(made::transformed(plain_box(), scale, axis, degrees));
    const std::vector<Answer> answers = fresh_answers(entry_, moved, quantities_, carried_over(moved, samples_));
    for (std::size_t q = 0; q < quantities_.size(); ++q)
      require_same_means(answers_[q], answers[q], samples_, slack_of(entry_),
                         fmt::format("{} {}", to_string(quantities_[q]), what));
  }

 private:
  const MethodEntry& entry_;
  World world_{plain_box()};
  std::vector<Quantity> quantities_;
  std::vector<SurfaceSample> samples_;
  std::vector<Answer> answers_;
};

/// Every value that can be asked for on both sides of every surface of an odd scene.
void verify_odd_scene(const MethodEntry& entry, const OddScene& odd) {
  const World world(odd.scene);
  Run run(entry, world);
  if (run.method().refusal(odd.scene)) {
    if (odd.ordinary_surfaces) throw Violation("'" + odd.name + "' is refused: " + *run.method().refusal(odd.scene));
    return;
  }
  run.prepare().light();
  const auto lit = samples_of(world), turned = other_sides(world, lit);
  std::vector<Quantity> quantities = light_quantities(run.method());
  for (const Quantity quantity : {Quantity::radiosity, Quantity::accessibility})
    if (run.method().answers(quantity)) quantities.push_back(quantity);
  for (const Quantity quantity : quantities) {
    const std::string what = fmt::format("{} in '{}'", to_string(quantity), odd.name);
    for (const auto& samples : {lit, turned}) {
      const Answer answer = run.shade(quantity, samples);
      require_sane(answer.direct, what + ", direct light");
      require_sane(answer.indirect, what + ", indirect light");
      if (quantity == Quantity::accessibility) continue;
      for (std::size_t i = 0; i < samples.size(); ++i)
        if (!samples[i].lit_side) {
          require_black({answer.direct[i]}, what + ", direct light on a back");
          require_black({answer.indirect[i]}, what + ", indirect light on a back");
        }
    }
  }
}

/// Variances of the values themselves, from methods that know them.
void verify_variances(const MethodEntry& entry) {
  const World world(plain_box());
  Run run(entry, world);
  const Quantity quantity = plainest_quantity(entry);
  if (!run.method().knows_variance(quantity)) return;
  run.prepare().light();
  const auto samples = samples_of(world);
  std::vector<Vec3> toward_viewer;
  if (quantity == Quantity::radiance)
    for (const SurfaceSample& sample : samples) toward_viewer.push_back(sample.normal);
  std::vector<Rgb> direct(samples.size()), indirect(direct), first(direct), second(direct), total(direct);
  Task task = run.task();
  require_success(run.method().shade({quantity, samples, toward_viewer}, {direct, indirect, first, second, total}, task),
                  "shade with variances");
  for (const auto& variance : {first, second, total})
    for (const Rgb& value : variance)
      if (!is_finite(value) || smallest(value) < 0.0F) throw Violation("a variance is not finite or below zero");
}

}  // namespace

void verify_scale_invariance(const MethodEntry& entry) {
  const StillBox box(entry);
  box.require_unmoved_by(1e-3F, {0.0F, 1.0F, 0.0F}, 0.0F, "in a room of a millimetre");
  box.require_unmoved_by(1e4F, {0.0F, 1.0F, 0.0F}, 0.0F, "in a room of ten kilometres");
}

void verify_rotation_invariance(const MethodEntry& entry) {
  StillBox(entry).require_unmoved_by(1.0F, {1.0F, 2.0F, 3.0F}, 77.0F, "in a room that was turned");
}

void verify_black_walls_give_no_indirect_light(const MethodEntry& entry) {
  const World world(black_box());
  const auto samples = samples_of(world);
  const std::vector<Quantity> quantities = light_quantities(entry);
  const std::vector<Answer> answers = fresh_answers(entry, world, quantities, samples);
  // The plan spares the method the question: put to it all the same.
  const std::vector<Answer> own = fresh_answers(entry, world, quantities, samples, {.forced = {Effect::diffuse_indirect}});
  for (std::size_t q = 0; q < quantities.size(); ++q) {
    const std::string what = fmt::format("indirect {} between black walls", to_string(quantities[q]));
    require_black(answers[q].indirect, what);
    require_black(own[q].indirect, what + ", asked for");
    if (quantities[q] == Quantity::irradiance && is_black(mean_of(answers[q].direct)))
      throw Violation("direct irradiance is black although the lights are on");
  }
}

void verify_bounce_bounds(const MethodEntry& entry) {
  const World world(plain_box());
  const auto samples = samples_of(world);
  const Quantity quantity = plainest_quantity(entry);
  const Slack slack = slack_of(entry);
  const bool indirect = make_session(entry, Parameters(entry.schema, entry.quick))->capabilities().indirect;
  std::optional<Answer> before;
  for (const std::optional<int> bounces : {std::optional(0), std::optional(1), std::optional(3), std::optional<int>()}) {
    const Answer now = fresh_answer(entry, world, quantity, samples, {.bounces = bounces});
    const std::string what = bounces ? fmt::format("at most {} bounces", *bounces) : "any number of bounces";
    if (bounces == 0) {
      require_black(now.indirect, "indirect light of " + what);
      const RunOptions asked_all_the_same{.bounces = 0, .forced = {Effect::diffuse_indirect}};
      require_black(fresh_answer(entry, world, quantity, samples, asked_all_the_same).indirect, "indirect light of " + what);
    }
    if (bounces == 1 && indirect && !(luminance(mean_of(now.indirect)) > 0.0))
      throw Violation("indirect light of a bright box is black with one bounce allowed");
    if (before) {
      require_no_less(before->indirect, now.indirect, samples, slack.indirect, "indirect light of " + what);
      require_same_means({before->direct, before->direct}, {now.direct, now.direct}, samples, slack, "direct light of " + what);
    }
    before = now;
  }
}

void verify_every_value_is_written_and_finite(const MethodEntry& entry) {
  for (const OddScene& odd : odd_scenes()) verify_odd_scene(entry, odd);
  verify_variances(entry);
}

void verify_refusals_are_texts(const MethodEntry& entry) {
  const auto method = make_session(entry, Parameters(entry.schema, entry.quick));
  for (const OddScene& odd : odd_scenes()) {
    const std::optional<std::string> refusal = method->refusal(odd.scene);
    if (refusal != method->refusal(odd.scene)) throw Violation("'" + odd.name + "' is refused once and not the same again");
    // A sentence, not a code: it is all that the user will see.
    if (refusal && (refusal->find(' ') == std::string::npos || refusal->find('\n') != std::string::npos))
      throw Violation(fmt::format("'{}' is refused without one line that says why: '{}'", odd.name, *refusal));
  }
}

}  // namespace gibench::contract
