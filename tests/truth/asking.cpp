#include "asking.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "common/core/error.h"
#include "common/core/random.h"
#include "common/core/sampling.h"
#include "common/effects/scene_effects.h"
#include "common/geometry/surface_lookup.h"
#include "common/method/method_session.h"

namespace gibench::truth {

namespace {

constexpr std::uint64_t mean_stage = 0x6d65616eULL;

/// The scene in which the named objects alone emit, radiance 1.
Scene with_emitters(Scene scene, const std::vector<std::string>& emitters) {
  for (Material& material : scene.materials) material.emission = Rgb();
  for (Object& object : scene.objects) {
    if (std::find(emitters.begin(), emitters.end(), object.name) == emitters.end()) continue;
    Material lamp = scene.materials[object.material];
    lamp.emission = Rgb(1.0F);
    object.material = static_cast<std::uint32_t>(scene.materials.size());
    scene.materials.push_back(lamp);
  }
  return scene;
}

SurfaceSample point_sample(const World& world, const Question& question) {
  const Vec3 point(question.point - world.scene().origin);
  const Vec3 normal(question.normal);
  if (question.place == Place::sensor) {
    SurfaceSample sensor;
    sensor.position = point;
    sensor.normal = normal;
    return sensor;
  }
  const auto found = find_surface_point(world, point, normal, 1e-4F * world.diagonal());
  if (!found) throw WorkError(fmt::format("{}: no surface at the point", question.id));
  SurfaceSample sample = *found;
  if (question.smooth) sample.normal = normal;
  return sample;
}

/// Points uniform by area over the named objects' fronts, stratified.
std::vector<SurfaceSample> mean_samples(const World& world, const Question& question, int count, std::uint64_t seed) {
  std::vector<std::uint32_t> triangles;
  std::vector<double> up_to;
  double total = 0.0;
  for (const Object& object : world.scene().objects) {
    if (std::find(question.surfaces.begin(), question.surfaces.end(), object.name) == question.surfaces.end()) continue;
    for (std::uint32_t t = object.triangle_begin; t < object.triangle_end; ++t) {
      triangles.push_back(t);
      up_to.push_back(total += static_cast<double>(world.area(t)));
    }
  }
  std::vector<SurfaceSample> samples;
  for (int i = 0; i < count; ++i) {
    RandomStream random(seed, mean_stage, static_cast<std::uint64_t>(i));
    const double target = total * (i + random.next_double()) / count;
    const auto found = std::upper_bound(up_to.begin(), up_to.end() - 1, target) - up_to.begin();
    const std::uint32_t triangle = triangles[static_cast<std::size_t>(found)];
    const Vec2 place{random.next_float(), random.next_float()};
    samples.push_back(world.sample_at(triangle, uniform_triangle(place), world.normal(triangle)));
  }
  return samples;
}

/// The case's world under the lights that the questions call for.
class QuestionsWorld {
 public:
  QuestionsWorld(const World& world, const Question& question) : world_(&world) {
    if (question.emitters.empty()) return;
    other_lights_.emplace(with_emitters(world.scene(), question.emitters), world);
    world_ = &*other_lights_;
  }
  QuestionsWorld(const QuestionsWorld&) = delete;
  QuestionsWorld& operator=(const QuestionsWorld&) = delete;
  const World& world() const { return *world_; }

 private:
  const World* world_;
  std::optional<World> other_lights_;
};

/// A method that has seen the scene and its lights.
class Asked {
 public:
  Asked(const MethodEntry& entry, const World& world, std::optional<int> bounces, const Run& run)
      : world_(world), run_(run), method_(make_session(entry, Parameters(entry.schema, run.settings))) {
    Task task(settings_of(0));
    const EffectPlan plan = plan_effects(analyse_effects(world, bounces), method_->capabilities().effects);
    require(method_->prepare(world, plan, task));
    require(method_->light(Lighting::of(world.scene()), task));
  }

  std::vector<Answer> points(const std::vector<Question>& questions) {
    std::vector<SurfaceSample> samples;
    for (const Question& question : questions) samples.push_back(point_sample(world_, question));
    const Quantity quantity = questions.front().quantity;
    std::vector<Vec3> toward_viewer;
    if (quantity == Quantity::radiance)
      for (const Question& question : questions) toward_viewer.emplace_back(glm::normalize(question.direction));
    return shade(quantity, questions.front().component, samples, toward_viewer);
  }

  Answer mean(const Question& question) {
    const auto groups = static_cast<std::size_t>(run_.mean_groups), points = static_cast<std::size_t>(run_.mean_points);
    std::vector<SurfaceSample> samples;
    for (std::size_t group = 0; group < groups; ++group)
      for (const SurfaceSample& sample : mean_samples(world_, question, run_.mean_points, mix_keys(run_.seed, mean_stage, group)))
        samples.push_back(sample);
    const std::vector<Answer> answers = shade(question.quantity, question.component, samples, {});
    RgbDouble sum, squares;
    for (std::size_t group = 0; group < groups; ++group) {
      RgbDouble mean;
      for (std::size_t i = 0; i < points; ++i) mean += answers[group * points + i].value;
      mean *= question.factor / static_cast<double>(points);
      sum += mean;
      squares += mean * mean;
    }
    const auto count = static_cast<double>(groups);
    const RgbDouble value = sum / count;
    Answer answer{value, {}};
    for (int c = 0; c < 3; ++c)
      answer.standard_error[c] = std::sqrt(std::max(0.0, squares[c] / count - value[c] * value[c]) / (count - 1.0));
    return answer;
  }

 private:
  /// A seed of its own for each call, so that no two answers share random numbers.
  TaskSettings settings_of(std::uint64_t call) const {
    TaskSettings settings;
    settings.seed = mix_keys(run_.seed, call);
    settings.threads = 1;  // cases run beside one another
    return settings;
  }

  static void require(const StageReport& report) {
    if (!succeeded(report.termination)) throw WorkError(fmt::format("{}: {}", to_string(report.termination), report.message));
  }

  std::vector<Answer> shade(Quantity quantity, Component component, const std::vector<SurfaceSample>& samples,
                            const std::vector<Vec3>& toward_viewer) {
    const std::size_t count = samples.size();
    const bool whole = quantity == Quantity::accessibility;  // written to `direct`
    const bool variance = method_->capabilities().variance;
    std::vector<Rgb> direct(component == Component::indirect ? 0 : count),
        indirect(component == Component::direct || whole ? 0 : count);
    std::vector<Rgb> spread(variance ? count : 0);
    ShadeAnswer answer{direct, indirect, {}, {}, {}};
    (component == Component::indirect          ? answer.indirect_variance
     : component == Component::direct || whole ? answer.direct_variance
                                               : answer.total_variance) = spread;
    Task task(settings_of(++calls_));
    require(method_->shade({quantity, samples, toward_viewer}, answer, task));
    std::vector<Answer> answers(count);
    for (std::size_t i = 0; i < count; ++i) {
      if (!direct.empty()) answers[i].value += RgbDouble(direct[i]);
      if (!indirect.empty()) answers[i].value += RgbDouble(indirect[i]);
      if (variance)
        for (int c = 0; c < 3; ++c) answers[i].standard_error[c] = std::sqrt(static_cast<double>(spread[i][c]));
    }
    return answers;
  }

  const World& world_;
  const Run& run_;
  std::unique_ptr<MethodSession> method_;
  std::uint64_t calls_ = 0;
};

bool asked_together(const Question& a, const Question& b) {
  return a.place != Place::mean && b.place != Place::mean && a.quantity == b.quantity && a.component == b.component;
}

}  // namespace

std::string tell(const Answer& a, const Question& q) {
  return fmt::format("{}: ({:.7g}, {:.7g}, {:.7g}) ± ({:.2g}, {:.2g}, {:.2g}), truth ({:.7g}, {:.7g}, {:.7g})", q.id, a.value.r,
                     a.value.g, a.value.b, a.standard_error.r, a.standard_error.g, a.standard_error.b, q.value.r, q.value.g,
                     q.value.b);
}

std::optional<std::string> beyond(const MethodEntry& entry, const World& world, const std::vector<Question>& questions,
                                  const std::vector<std::pair<std::string, std::string>>& settings) {
  const QuestionsWorld lit(world, questions.front());
  const auto method = make_session(entry, Parameters(entry.schema, settings));
  if (auto why = method->refusal(lit.world().scene())) return why;
  const EffectPlan plan = plan_effects(analyse_effects(lit.world(), questions.front().bounces), method->capabilities().effects);
  if (plan.missing.empty()) return std::nullopt;
  return fmt::format("cannot do: {}", to_string(*plan.missing.begin()));
}

std::vector<Answer> ask(const MethodEntry& entry, const World& world, const std::vector<Question>& questions, const Run& run) {
  if (questions.empty()) return {};
  const QuestionsWorld lit(world, questions.front());
  Asked asked(entry, lit.world(), questions.front().bounces, run);
  std::vector<Answer> answers;
  for (std::size_t begin = 0; begin < questions.size();) {
    std::size_t end = begin + 1;
    while (end < questions.size() && asked_together(questions[begin], questions[end])) ++end;
    const auto first = questions.begin() + static_cast<std::ptrdiff_t>(begin),
               last = questions.begin() + static_cast<std::ptrdiff_t>(end);
    if (questions[begin].place == Place::mean) answers.push_back(asked.mean(questions[begin]));
    else
      for (const Answer& answer : asked.points({first, last})) answers.push_back(answer);
    begin = end;
  }
  return answers;
}

}  // namespace gibench::truth
