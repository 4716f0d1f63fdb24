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
constexpr double least_share = 0.01;  // of all that is lit or arrives: less is not worth a word
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

class Warnings {
 public:
  explicit Warnings(const SpaceReport& report) : report_(report) {
    for (const ObjectSides& object : report.objects) {
      all_power_ += object.front.power + object.back.power;
      all_lit_ += object.front.lit_area + object.back.lit_area;
      has_seen_ = has_seen_ || object.front.seen_area + object.back.seen_area > 0.0;
    }
  }

  std::vector<std::string> all() const {
    std::vector<std::string> warnings;
    if (report_.nothing_reached) warnings.emplace_back("no light reaches any side that can reflect it: all of them count as lit");
    for (const Model& model : models_of(report_.objects)) {
      std::string warning = model.two_sided ? two_sided(model) : one_sided(model);
      if (!warning.empty()) warnings.push_back(std::move(warning));
    }
    return warnings;
  }

 private:
  std::string two_sided(const Model& model) const {
    const double fronts = model.front.lit_area, backs = model.back.lit_area;
    if (report_.nothing_reached || fronts + backs < least_share * all_lit_) return {};
    const double percent = 100.0 * std::max(share(fronts, backs), share(backs, fronts));
    if (share(fronts, backs) >= nearly_all) {
      const std::string turned = listed(turned_parts(model));
      return fmt::format("object {} is two-sided, but {:.1f}% of what light reaches of it are fronts: is it needed?{}",
                         in_quotes(model.name), percent, turned.empty() ? "" : " Mostly backs are lit of " + turned);
    }
    if (share(backs, fronts) < nearly_all) return {};
    return fmt::format("object {} is two-sided, and {:.1f}% of what light reaches of it are backs: is it inside out?",
                       in_quotes(model.name), percent);
  }

  /// Of which one-sided fronts would show black backs.
  static std::vector<std::string> turned_parts(const Model& model) {
    std::vector<std::string> names;
    for (const ObjectSides* object : model.objects)
      if (share(object->back.lit_area, object->front.lit_area) > 0.5) names.push_back(in_quotes(object->name));
    return names;
  }

  /// Black backs are lit, and where there are cameras seen, and hardly any fronts.
  std::string one_sided(const Model& model) const {
    std::vector<std::string> names;
    double backs = 0.0, fronts = 0.0;
    for (const ObjectSides* object : model.objects) {
      if (!is_inside_out(object->front, object->back)) continue;
      names.push_back(in_quotes(object->name));
      backs += object->back.power, fronts += object->front.power;
    }
    if (names.empty()) return {};
    return fmt::format("{:.1f}% of the light that reaches {} {} meets its black back: is it inside out, or two-sided?",
                       100.0 * share(backs, fronts), names.size() == 1 ? "object" : "each of the objects", listed(names));
  }
  bool is_inside_out(const SideFacts& front, const SideFacts& back) const {
    return back.power >= least_share * all_power_ && share(back.power, front.power) >= nearly_all &&
           (!has_seen_ || share(back.seen_area, front.seen_area) >= nearly_all);
  }

  const SpaceReport& report_;
  double all_power_ = 0.0, all_lit_ = 0.0;
  bool has_seen_ = false;
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
  report.warnings = Warnings(report).all();
  return report;
}

}  // namespace gibench
