#include "common/spaces/space_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <span>

#include "common/core/names.h"
#include "common/spaces/side_light.h"

namespace gibench {

namespace {

constexpr double nearly_all = 0.95;   // of what is lit or seen
constexpr double least_share = 0.01;  // of all that arrives: less is not worth a word
constexpr std::size_t most_named = 5;

/// A model file, of the objects "name/…" that it was split into, is spoken of as one.
std::string model_of(const std::string& object) { return object.substr(0, object.find('/')); }

SideFacts operator+(const SideFacts& a, const SideFacts& b) {
  return {a.lit_area + b.lit_area, a.seen_area + b.seen_area, a.power + b.power};
}

double share(double part, double rest) { return part + rest > 0.0 ? part / (part + rest) : 0.0; }

/// The objects of one model that are alike in being two-sided or not.
struct Model {
  std::string name;
  bool two_sided = false;
  SideFacts front, back;
  std::vector<const ObjectSides*> objects;
};

std::vector<Model> models_of(std::span<const ObjectSides> objects) {
  std::map<std::pair<std::string, bool>, Model> models;
  for (const ObjectSides& object : objects) {
    Model& model = models[{model_of(object.name), object.two_sided}];
    model.name = model_of(object.name), model.two_sided = object.two_sided;
    model.front = model.front + object.front, model.back = model.back + object.back;
    model.objects.push_back(&object);
  }
  std::vector<Model> list;
  for (auto& [key, model] : models) list.push_back(std::move(model));
  return list;
}

/// "name, name and 3 more"; empty where there are none.
std::string listed(std::vector<std::string> names) {
  const std::size_t more = names.size() > most_named ? names.size() - most_named : 0;
  names.resize(names.size() - more);
  std::string text = fmt::format("{}", fmt::join(names, ", "));
  if (more > 0) text += fmt::format(" and {} more", more);
  return text;
}

/// Names of models, and the light that reaches them.
struct Suspects {
  std::vector<std::string> names;
  double fronts = 0.0, backs = 0.0;  ///< W

  void add(const std::string& name, const SideFacts& front, const SideFacts& back) {
    names.push_back(in_quotes(name));
    fronts += front.power, backs += back.power;
  }
};

class Warnings {
 public:
  explicit Warnings(const SpaceReport& report) {
    for (const ObjectSides& object : report.objects) {
      all_power_ += object.front.power + object.back.power;
      has_seen_ = has_seen_ || object.front.seen_area + object.back.seen_area > 0.0;
    }
    if (report.nothing_reached)
      sentences_.emplace_back("no light reaches any side that can reflect it: all of them count as lit");
    for (const Model& model : models_of(report.objects)) {
      if (model.two_sided) judge_two_sided(model);
      else judge_one_sided(model);
    }
  }

  std::vector<std::string> take() {
    add("two-sided for nothing? Of the light that reaches", needless_, "fronts", share(needless_.fronts, needless_.backs));
    if (!turned_.empty()) sentences_.back() += "; but it meets mostly backs of " + listed(turned_);
    add("inside out? Of the light that reaches two-sided", turned_round_, "backs",
        share(turned_round_.backs, turned_round_.fronts));
    add("inside out, or two-sided? Of the light that reaches", inside_out_, "black backs",
        share(inside_out_.backs, inside_out_.fronts));
    return std::move(sentences_);
  }

 private:
  void add(const char* question, const Suspects& suspects, const char* sides, double part) {
    if (suspects.names.empty()) return;
    sentences_.push_back(fmt::format("{} {} {:.1f}% meets {}", question, listed(suspects.names), 100.0 * part, sides));
  }
  bool counts(const SideFacts& front, const SideFacts& back) const {
    return front.power + back.power > 0.0 && front.power + back.power >= least_share * all_power_;
  }

  void judge_two_sided(const Model& model) {
    if (!counts(model.front, model.back)) return;
    if (share(model.back.power, model.front.power) >= nearly_all) turned_round_.add(model.name, model.front, model.back);
    if (share(model.front.power, model.back.power) < nearly_all) return;
    needless_.add(model.name, model.front, model.back);
    for (const ObjectSides* object : model.objects)  // whose one-sided fronts would show black backs
      if (counts(object->front, object->back) && object->back.power > object->front.power)
        turned_.push_back(in_quotes(object->name));
  }

  /// Black backs are lit, and where there are cameras seen, and hardly any fronts.
  void judge_one_sided(const Model& model) {
    for (const ObjectSides* object : model.objects) {
      const SideFacts &front = object->front, &back = object->back;
      if (counts(front, back) && share(back.power, front.power) >= nearly_all &&
          (!has_seen_ || share(back.seen_area, front.seen_area) >= nearly_all))
        inside_out_.add(object->name, front, back);
    }
  }

  double all_power_ = 0.0;
  bool has_seen_ = false;
  Suspects needless_, turned_round_, inside_out_;
  std::vector<std::string> turned_, sentences_;
};

/// Black backs are compared with what fronts get; where these get nothing, with the mean of the backs.
float least_lit(const SideLight& light) {
  if (!light.nothing_reached()) return SideLight::sealed_share * light.mean();
  double sum = 0.0, squares = 0.0;
  for (std::uint32_t cell = 0; cell < light.cells().size(); ++cell) {
    const auto value = static_cast<double>(light.cell_irradiance(cell)), area = static_cast<double>(light.cells().area(cell));
    sum += value * area, squares += value * value * area;
  }
  return sum > 0.0 ? SideLight::sealed_share * static_cast<float>(squares / sum) : 0.0F;
}

}  // namespace

SpaceReport report_spaces(const World& world, Task& task) {
  const Scene& scene = world.scene();
  const SideLight light(world, task, {CellSides::all});
  SpaceReport report;
  report.nothing_reached = light.nothing_reached();
  for (const Object& object : scene.objects) report.objects.push_back({object.name, object.two_sided, 0.0, {}, {}});
  const float least = least_lit(light);
  const SideCells& cells = light.cells();
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    ObjectSides& object = report.objects[scene.triangle_object[cells.triangle(cell)]];
    const bool front = cells.front(cell), leaves = front || object.two_sided;
    const auto area = static_cast<double>(cells.area(cell));
    const bool lit = light.cell_irradiance(cell) > least, counts_as_lit = light.is_cell_reached(cell);
    SideFacts& side = front ? object.front : object.back;
    if (front) object.area += area;
    side.power += area * static_cast<double>(light.cell_irradiance(cell));
    if (lit) side.lit_area += area;
    if (light.is_cell_seen(cell)) side.seen_area += area;
    if (!leaves) continue;
    report.area += area;
    if (counts_as_lit) (front ? report.lit_fronts : report.lit_backs) += area;
    if (light.is_cell_seen(cell)) (front ? report.seen_fronts : report.seen_backs) += area;
    if (!counts_as_lit && !light.is_cell_seen(cell)) report.sealed += area;
  }
  report.warnings = Warnings(report).take();
  return report;
}

}  // namespace gibench
