/// Checks that every method answers what the program asks, asked as the program does.
#include <fmt/format.h>

#include <memory>
#include <utility>

#include "common/scene/tessellate.h"
#include "tests/contract/compare.h"
#include "tests/contract/contract.h"
#include "tests/contract/run.h"
#include "tests/contract/scenes.h"

namespace gibench::contract {

namespace {

std::vector<Vec3> directions_for(Quantity quantity, const std::vector<SurfaceSample>& samples) {
  std::vector<Vec3> toward_viewer;
  if (quantity == Quantity::radiance)
    for (const SurfaceSample& sample : samples) toward_viewer.push_back(sample.normal);
  return toward_viewer;
}

/// As a run asks: both components, and the variance of their sum alone where it is known.
void ask_as_a_run_does(const Run& run, Quantity quantity, const std::vector<SurfaceSample>& samples, const std::string& what) {
  const std::vector<Vec3> toward_viewer = directions_for(quantity, samples);
  std::vector<Rgb> direct(samples.size()), indirect(direct), variance;
  if (run.method().knows_variance(quantity)) variance.resize(samples.size());
  Task task = run.task();
  require_success(run.method().shade({quantity, samples, toward_viewer}, {direct, indirect, {}, {}, variance}, task), what);
}

/// One component, the other not asked for.
Answer ask_for_part(const Run& run, Quantity quantity, const std::vector<SurfaceSample>& samples, bool for_direct) {
  const std::vector<Vec3> toward_viewer = directions_for(quantity, samples);
  Answer answer;
  (for_direct ? answer.direct : answer.indirect).resize(samples.size());
  Task task = run.task();
  require_success(run.method().shade({quantity, samples, toward_viewer}, {answer.direct, answer.indirect, {}, {}, {}}, task),
                  "shade");
  return answer;
}

/// The plain box after an edit, and the edit.
struct Edited {
  std::string what;
  SceneEdit edit;
  Scene after;
};

Edited with_another_material() {
  Scene scene = plain_box();
  Material& white = scene.materials.front();
  white.diffuse = {0.2F, 0.3F, 0.7F};
  return {"of a material", MaterialEdit{white.name, white}, scene};
}

Edited with_another_light() {
  Scene scene = plain_box();
  scene.lights.front() = PointLight{{0.6F, 0.5F, 0.8F}, {0.2F, 1.0F, 0.5F}};
  return {"of a light", LightEdit{0, scene.lights.front()}, scene};
}

Edited with_a_block_moved() {
  const Vec3d by{0.0, 0.2, 0.25};
  Scene scene = plain_box();
  for (const Object& object : scene.objects)
    for (std::uint32_t i = object.vertex_begin; object.name == "tall" && i < object.vertex_end; ++i)
      scene.vertices[i] += Vec3(by);
  tessellate(scene);
  return {"of a block's place", MoveEdit{"tall", by, Vec3d(0.0)}, scene};
}

/// The world before the edit is gone when the answer is asked for, as it is once a program has gone on.
void verify_edit(const MethodEntry& entry, Edited edited) {
  auto before = std::make_unique<World>(plain_box());
  const World after(std::move(edited.after));
  const auto samples = samples_of(after);
  const Quantity quantity = plainest_quantity(entry);
  Run run(entry, *before);
  run.prepare().light().edit(edited.edit, after);
  before.reset();
  const Answer answer = run.shade(quantity, samples);
  require_same_means(fresh_answer(entry, after, quantity, samples), answer, samples, slack_of(entry),
                     "a fresh run against an edited one, an edit " + edited.what);
  require_same_bits(answer, run.light().shade(quantity, samples),
                    "an edited run and the same once lit again, an edit " + edited.what);
}

}  // namespace

void verify_every_question_is_answered(const MethodEntry& entry) {
  const World world(plain_box());
  Run run(entry, world);
  run.prepare().light();
  const auto samples = samples_of(world);
  for (const Quantity quantity : {Quantity::irradiance, Quantity::radiance, Quantity::radiosity}) {
    if (!run.method().answers(quantity)) throw Violation(fmt::format("{} is not answered", to_string(quantity)));
    ask_as_a_run_does(run, quantity, samples, fmt::format("shade ({})", to_string(quantity)));
    // A camera may see nothing of the scene: the session spares the method the question.
    ask_as_a_run_does(run, quantity, {}, fmt::format("shade ({}) without samples", to_string(quantity)));
  }
}

void verify_parts_are_those_of_the_whole(const MethodEntry& entry) {
  const World world(plain_box());
  Run run(entry, world);
  run.prepare().light();
  const auto samples = samples_of(world);
  for (const Quantity quantity : light_quantities(entry)) {
    const Answer whole = run.shade(quantity, samples);
    require_same_bits({whole.direct, {}}, ask_for_part(run, quantity, samples, true),
                      fmt::format("{}, both components and direct light alone", to_string(quantity)));
    require_same_bits({{}, whole.indirect}, ask_for_part(run, quantity, samples, false),
                      fmt::format("{}, both components and indirect light alone", to_string(quantity)));
  }
}

void verify_editing_equals_a_fresh_run(const MethodEntry& entry) {
  verify_edit(entry, with_another_material());
  verify_edit(entry, with_another_light());
  verify_edit(entry, with_a_block_moved());
}

}  // namespace gibench::contract
