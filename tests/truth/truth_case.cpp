#include "truth_case.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "common/scene_io/native/scene_file.h"
#include "inward_sphere.h"

namespace gibench::truth {

namespace {

using nlohmann::json;

std::filesystem::path folder() { return std::filesystem::path(GIBENCH_TEST_DATA) / "cases"; }

Vec3d vector_of(const json& j) { return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()}; }

RgbDouble rgb_of(const json& j) {
  if (j.is_number()) return RgbDouble(j.get<double>());
  return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()};
}

Quantity quantity_of(const std::string& name) {
  static const std::map<std::string, Quantity> all{{"radiance", Quantity::radiance},
                                                   {"irradiance", Quantity::irradiance},
                                                   {"radiosity", Quantity::radiosity},
                                                   {"accessibility", Quantity::accessibility}};
  return all.at(name);
}

Component component_of(const std::string& name) {
  return name == "direct" ? Component::direct : name == "indirect" ? Component::indirect : Component::total;
}

void read_truth(const json& j, Question& question) {
  question.id = j.at("id").get<std::string>();
  question.value = rgb_of(j.at("value"));
  question.uncertainty = rgb_of(j.at("abs_uncertainty"));
}

Question point_question(const json& j) {
  Question question;
  read_truth(j, question);
  question.quantity = quantity_of(j.at("quantity").get<std::string>());
  question.component = component_of(j.value("component", "total"));
  if (!j.at("bounces").is_null()) question.bounces = j["bounces"].get<int>();
  question.point = vector_of(j.at("point"));
  question.normal = vector_of(j.at("normal"));
  if (j.contains("direction")) question.direction = vector_of(j["direction"]);
  return question;
}

/// {"min", "max"}: from min to max reflections; the cases have min 0 (all of them) or 1 (indirect).
void read_bounce_range(const json& j, Question& question) {
  const json& range = j.at("bounces");
  question.component = range.at("min").get<int>() == 0 ? Component::total : Component::indirect;
  if (!range.at("max").is_null()) question.bounces = range["max"].get<int>();
}

double area_of(const World& world, const std::vector<std::string>& names) {
  double area = 0.0;
  for (const Object& object : world.scene().objects)
    if (std::find(names.begin(), names.end(), object.name) != names.end())
      for (std::uint32_t t = object.triangle_begin; t < object.triangle_end; ++t) area += static_cast<double>(world.area(t));
  return area;
}

/// What a point query cannot ask; empty for quantities of other kinds: a zonal radiosity is not the continuous
/// truth, a directional albedo is tested with the lobes (tests/common/reflectance/).
std::optional<Question> other_question(const json& j, const World& world) {
  const auto quantity = j.at("quantity").get<std::string>();
  Question question;
  if (quantity == "form_factor") {
    question.place = Place::mean;
    question.bounces = 0;
    question.emitters = j.at("from").get<std::vector<std::string>>();
    question.surfaces = j.at("to").get<std::vector<std::string>>();
    // F(from → to) = mean irradiance of `to` · its area / (π L · area of `from`).
    question.factor = area_of(world, question.surfaces) / (pi_double * area_of(world, question.emitters));
  } else if (quantity == "mean_irradiance" || quantity == "mean_radiosity") {
    question.place = Place::mean;
    question.quantity = quantity == "mean_irradiance" ? Quantity::irradiance : Quantity::radiosity;
    question.surfaces = j.at("surfaces").get<std::vector<std::string>>();
    read_bounce_range(j, question);
  } else if (quantity == "irradiance") {
    question.place = Place::sensor;
    question.point = vector_of(j.at("point"));
    question.normal = vector_of(j.at("normal"));
    read_bounce_range(j, question);
  } else {
    return std::nullopt;
  }
  read_truth(j, question);
  return question;
}

/// The indirect parts of the totals whose direct parts the case tells, too: in the sum a large direct part would hide them.
std::vector<Question> derived_indirect(const std::vector<Question>& questions) {
  std::vector<Question> result;
  for (const Question& total : questions) {
    if (total.place != Place::point || total.quantity != Quantity::irradiance || total.component != Component::total) continue;
    for (const Question& direct : questions) {
      if (direct.bounces != 0 || total.bounces == 0 || direct.place != Place::point || direct.quantity != total.quantity ||
          direct.point != total.point || direct.normal != total.normal)
        continue;
      Question indirect = total;
      indirect.id += "_indirect";
      indirect.component = Component::indirect;
      indirect.value = total.value - direct.value;
      indirect.uncertainty += direct.uncertainty;
      result.push_back(indirect);
    }
  }
  return result;
}

}  // namespace

bool TruthCase::has_tag(const std::string& tag) const { return std::find(tags.begin(), tags.end(), tag) != tags.end(); }

std::vector<std::string> case_ids() {
  std::vector<std::string> ids;
  for (const auto& entry : std::filesystem::directory_iterator(folder())) ids.push_back(entry.path().stem().string());
  std::sort(ids.begin(), ids.end());
  return ids;
}

TruthCase load_case(const std::string& id) {
  const std::filesystem::path path = folder() / (id + ".json");
  std::ifstream file(path);
  json j = json::parse(file);
  double relative_error = 0.0;  // of a tessellation that stands for a smooth shape
  if (j.contains("inward_sphere")) {
    const json& sphere = j["inward_sphere"];
    relative_error = sphere.at("relative_error").get<double>();
    j["scene"]["objects"].push_back(inward_sphere(sphere));
  }
  TruthCase result;
  result.id = id;
  result.title = j.at("title").get<std::string>();
  result.tags = j.at("tags").get<std::vector<std::string>>();
  result.world = std::make_shared<const World>(parse_scene(j.at("scene").dump(), id, folder()), 1);
  for (const json& query : j.at("queries")) result.questions.push_back(point_question(query));
  for (const json& other : j.value("other_quantities", json::array()))
    if (const auto question = other_question(other, *result.world)) result.questions.push_back(*question);
  for (const Question& question : derived_indirect(result.questions)) result.questions.push_back(question);
  for (Question& question : result.questions) {
    question.uncertainty += question.value * relative_error;
    question.smooth = relative_error > 0.0;
  }
  return result;
}

}  // namespace gibench::truth
