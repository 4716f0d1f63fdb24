#include "bench/study/study_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <nlohmann/json.hpp>
#include <set>

#include "bench/measure/measuring_fields.h"
#include "bench/measure/run_method.h"
#include "bench/measure/scene_search.h"
#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/core/find_file.h"
#include "common/json/json_place.h"
#include "common/json/json_schema.h"
#include "common/json/json_text.h"

namespace gibench {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uint64_t usual_reference_samples = 64;  // of a relighting: in a study every frame is compared

/// As it would stand after --set name=.
std::string setting_text(const json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

const MethodEntry& method_at(const json& value, const JsonPlace& place) {
  return method_named(value.get<std::string>(), place.text());
}

using Setting = std::pair<std::string, std::string>;

/// The settings of the preset that the entry names, which its parameters override.
SettingTexts preset_of(const json& entry, const JsonPlace& place, const MethodEntry& method) {
  return with_preset(method.presets, entry.value("preset", ""), {}, place["preset"].text());
}

/// Every combination of one value from each list, the last list changing fastest.
std::vector<std::vector<Setting>> combinations(const json& sweep) {
  std::vector<std::vector<Setting>> all{{}};
  for (const auto& [name, values] : sweep.items()) {
    std::vector<std::vector<Setting>> longer;
    for (const std::vector<Setting>& begun : all)
      for (const json& value : values) {
        longer.push_back(begun);
        longer.back().emplace_back(name, setting_text(value));
      }
    all = std::move(longer);
  }
  return all;
}

PlanOptions plan_options_of(const json& entry, const JsonPlace& place, double tolerance) {
  PlanOptions plan;
  plan.tolerance = entry.value("tolerance", tolerance);
  if (!entry.contains("effects")) return plan;
  const auto names = entry["effects"].get<std::vector<std::string>>();
  effects_of_names(names, place["effects"].text());
  plan.effects = names.empty() ? "none" : fmt::format("{}", fmt::join(names, ","));
  return plan;
}

std::size_t scene_named(const std::string& name, const JsonPlace& place, const std::vector<StudyScene>& scenes) {
  std::string known;
  for (std::size_t s = 0; s < scenes.size(); ++s) {
    if (scenes[s].name == name) return s;
    known += (known.empty() ? "" : ", ") + scenes[s].name;
  }
  throw InputError(place.text(), fmt::format("the study has no scene '{}'", name), "its scenes: " + known);
}

/// Throws InputError for a run whose folder would have a name longer than file systems take. `place` is where to shorten it.
void check_length(const StudyScene& scene, const std::string& label, const JsonPlace& place) {
  const std::size_t bytes = folder_name(scene, label).size();
  if (bytes > most_name_bytes)
    throw InputError(place.text(),
                     fmt::format("with the scene '{}' it makes a folder name of {} bytes, and {} is the most", scene.name, bytes,
                                 most_name_bytes),
                     "shorten it, or the name of the scene's file");
}

std::set<std::size_t> scenes_of(const json& entry, const JsonPlace& place, const std::vector<StudyScene>& scenes) {
  std::set<std::size_t> chosen;
  const json names = entry.value("scenes", json::array());
  for (std::size_t i = 0; i < names.size(); ++i)
    chosen.insert(scene_named(names[i].get<std::string>(), place["scenes"][i], scenes));
  return chosen;
}

void add_variants(const json& entry, const JsonPlace& place, double tolerance, Study& study) {
  std::vector<StudyVariant>& variants = study.variants;
  const MethodEntry& method = method_at(entry["method"], place["method"]);
  const json parameters = entry.value("parameters", json::object()), sweep = entry.value("sweep", json::object());
  std::vector<Setting> fixed = preset_of(entry, place, method);
  for (const auto& [name, value] : parameters.items()) {
    fixed.emplace_back(name, setting_text(value));
    Parameters(method.schema, {fixed.back()}, place["parameters"].text());
  }
  for (const auto& [name, values] : sweep.items()) {
    if (parameters.contains(name))
      throw InputError(place["sweep"][name].text(), "the parameter is also in parameters", "remove one of them");
    for (const json& value : values) Parameters(method.schema, {{name, setting_text(value)}}, place["sweep"].text());
  }
  for (const std::vector<Setting>& swept : combinations(sweep)) {
    StudyVariant variant{method.name, entry.value("label", method.name),        {},
                         {},          plan_options_of(entry, place, tolerance), scenes_of(entry, place, study.scenes)};
    std::vector<Setting> settings = fixed;
    settings.insert(settings.end(), swept.begin(), swept.end());
    for (const auto& [name, text] : swept) variant.label.append(" ").append(name).append("=").append(text);
    for (const auto& [name, text] : settings) variant.settings.push_back(name + "=" + text);
    variant.parameters = Parameters(method.schema, settings, place.text()).values();
    for (const StudyVariant& other : variants)
      if (other.label == variant.label)
        throw InputError(place.text(), fmt::format("'{}' appears twice", variant.label), "give one of them another \"label\"");
    const JsonPlace named_at = entry.contains("label") ? place["label"] : swept.empty() ? place["method"] : place["sweep"];
    for (std::size_t s = 0; s < study.scenes.size(); ++s)
      if (variant.runs_on(s)) check_length(study.scenes[s], variant.label, named_at);
    variants.push_back(std::move(variant));
  }
}

std::string scene_name(const fs::path& file) {
  const std::string name = file.filename().string(), extension = ".scene.json";
  return name.ends_with(extension) ? name.substr(0, name.size() - extension.size()) : file.stem().string();
}

StudyScene scene_at(const json& value, const JsonPlace& place, const fs::path& folder) {
  const fs::path found = find_scene(value.get<std::string>(), folder);
  return {scene_name(found), find_file(found, ".", place.text())};
}

/// Beside the scene, beside the study file or in the working folder.
fs::path moving_lights_at(const json& value, const JsonPlace& place, const StudyScene& scene, const fs::path& folder) {
  const fs::path name = value.get<std::string>();
  for (const fs::path& base : {scene.file.parent_path(), folder})
    if (!name.is_absolute() && fs::exists(base / name)) return base / name;
  return find_file(name.string(), ".", place.text());
}

void read_value(const json& value, std::optional<int>& into) { into = value.get<int>(); }
template <class Value>
void read_value(const json& value, Value& into) {
  into = value.get<Value>();
}

/// Those that the file gives.
template <class Options>
void read_fields(const json& value, std::span<const OptionField<Options>> fields, Options& options) {
  for (const OptionField<Options>& field : fields)
    if (value.contains(field.key)) std::visit([&](auto member) { read_value(value[field.key], options.*member); }, field.member);
}

StudyRelight relight_at(const json& entry, const JsonPlace& place, const fs::path& folder, const Study& study) {
  const MethodEntry& method = method_at(entry["method"], place["method"]);
  StudyRelight relight;
  relight.scene = scene_named(entry["scene"].get<std::string>(), place["scene"], study.scenes);
  relight.lights = moving_lights_at(entry["lights"], place["lights"], study.scenes[relight.scene], folder);
  relight.method = method.name;
  relight.label = entry.value("label", method.name);
  std::vector<Setting> settings = preset_of(entry, place, method);
  const json given = entry.value("parameters", json::object());
  for (const auto& [name, value] : given.items()) settings.emplace_back(name, setting_text(value));
  for (const auto& [name, text] : settings) relight.settings.push_back(name + "=" + text);
  const Parameters parameters(method.schema, settings, place["parameters"].text());
  relight.parameters = parameters.values();
  require_relighting({&method, parameters}, place["method"].text());
  relight.options.surface_samples = study.measuring.surface_samples;
  relight.options.reference_samples = usual_reference_samples;
  read_fields(entry, relight_fields(), relight.options);
  return relight;
}

void read_relights(const json& list, const JsonPlace& place, const fs::path& folder, Study& study) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    StudyRelight relight = relight_at(list[i], place[i], folder, study);
    for (const StudyRelight& other : study.relights)
      if (other.scene == relight.scene && other.label == relight.label)
        throw InputError(place[i].text(), fmt::format("'{}' appears twice", relight.label), "give one of them another \"label\"");
    check_length(study.scenes[relight.scene], relight_label(relight.label),
                 list[i].contains("label") ? place[i]["label"] : place[i]["scene"]);
    study.relights.push_back(std::move(relight));
  }
}

void read_reference(const json& entry, Study& study) {
  StudyReference reference;
  if (entry.contains("samples")) reference.samples_per_replica = entry["samples"].get<std::uint64_t>();
  if (entry.contains("picture_samples")) reference.picture_samples = entry["picture_samples"].get<std::uint64_t>();
  if (entry.contains("target_error")) reference.target_error = entry["target_error"].get<double>();
  if (entry.contains("time_limit_seconds")) reference.time_limit_seconds = entry["time_limit_seconds"].get<double>();
  reference.replicas = entry.value("replicas", reference.replicas);
  study.measuring.reference_seed = entry.value("seed", study.measuring.reference_seed);
  study.reference = reference;
}

void read_measuring(const json& value, const JsonPlace& place, MeasuringOptions& measuring) {
  read_fields(value, measuring_fields(), measuring);
  strata_per_side(measuring.pixel_samples, place["pixel_samples"].text().c_str());
}

}  // namespace

std::string folder_name(const StudyScene& scene, const std::string& label) {
  std::string name = scene.name + "." + label;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '=' && c != '_' && c != '-') c = '-';
  return name;
}

std::string relight_label(const std::string& label) { return "relight." + label; }

Study read_study(const fs::path& file) {
  const JsonPlace top(file.string());
  auto value = std::make_shared<json>(parse_json(read_file(file), file.string()));
  check_against_json_schema(*value, json::parse(study_schema_text()), top, "see scenes/study.schema.json");
  Study study;
  study.name = (*value)["name"].get<std::string>();
  const json& scenes = (*value)["scenes"];
  std::set<std::string> names;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    study.scenes.push_back(scene_at(scenes[i], top["scenes"][i], file.parent_path()));
    if (!names.insert(study.scenes.back().name).second)
      throw InputError(top["scenes"][i].text(), "a scene of this name is already in the list", "remove one or rename its file");
  }
  const json& methods = (*value)["methods"];
  for (std::size_t i = 0; i < methods.size(); ++i)
    add_variants(methods[i], top["methods"][i], value->value("tolerance", 0.0), study);
  if (value->contains("reference")) read_reference((*value)["reference"], study);
  read_measuring(*value, top, study.measuring);
  study.method_seeds = value->value("method_seeds", study.method_seeds);
  read_relights(value->value("relights", json::array()), top["relights"], file.parent_path(), study);
  if (value->contains("time_limit_seconds")) study.time_limit_seconds = (*value)["time_limit_seconds"].get<double>();
  if (value->contains("memory_limit_mb"))
    study.memory_limit_bytes = static_cast<std::uint64_t>((*value)["memory_limit_mb"].get<double>() * 1024.0 * 1024.0);
  study.json = std::move(value);
  return study;
}

}  // namespace gibench
