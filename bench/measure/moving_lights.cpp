#include "bench/measure/moving_lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bench/measure/cancellation.h"
#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/core/overloaded.h"
#include "common/json/json_schema.h"
#include "common/json/json_text.h"
#include "common/scene_io/native/read_edit.h"
#include "common/scene_io/native/scene_schema.h"

namespace gibench {

namespace {

using nlohmann::json;

constexpr int default_frames = 30;

/// The lights as the scene's file writes them; a model file's cannot be given in its terms.
json written_lights(const Scene& scene) {
  if (scene.file.extension() != ".json") return json::array();
  const json document = parse_json(read_file(scene.file), scene.file.string());
  const auto lights = document.find("lights");
  return lights != document.end() ? *lights : json::array();
}

json part_or_empty(const json& document, const char* key) {
  const auto found = document.find(key);
  return found != document.end() ? *found : json::array();
}

/// Between two values of one key: numbers linearly, of one number and three each as three; anything else is the earlier's.
json between(const json& a, const json& b, double share) {
  if (a.is_number() && b.is_number()) return a.get<double>() + share * (b.get<double>() - a.get<double>());
  const auto part = [](const json& value, std::size_t i) -> const json& { return value.is_array() ? value[i] : value; };
  if (!a.is_array() && !b.is_array()) return a;
  json result = json::array();
  for (std::size_t i = 0; i < (a.is_array() ? a : b).size(); ++i) result.push_back(between(part(a, i), part(b, i), share));
  return result;
}

class MovingLights {
 public:
  MovingLights(const std::filesystem::path& file, const Scene& scene)
      : top_(file.string()), scene_(scene), written_lights_(written_lights(scene)) {
    document_ = parse_json(read_file(file), file.string());
    check_against_json_schema(document_, json::parse(moving_lights_schema_text()), top_, "see scenes/light-path.schema.json");
    tracks_ = part_or_empty(document_, "lights");
    switches_ = part_or_empty(document_, "switches");
    check();
  }

  int own_frames() const { return document_.value("frames", default_frames); }

  LightsFrame frame(double before, double at) const {
    LightsFrame frame{at, scene_.lights, scene_.materials, {}};
    json edits = json::array();
    for (const json& track : tracks_) edits.push_back(light_at(track, at));
    for (const SceneEdit& edit : read(edits, top_["lights"])) change(frame, edit, true);
    const std::vector<SceneEdit> switched = read(without_times(switches_), top_["switches"]);
    for (std::size_t i = 0; i < switched.size(); ++i) {
      const double time = switches_[i]["at"].get<double>();
      if (time > at) break;
      change(frame, switched[i], time > before);
    }
    return frame;
  }

 private:
  /// `is_new`: it was not yet made in the frame before.
  static void change(LightsFrame& frame, const SceneEdit& edit, bool is_new) {
    std::visit(Overloaded{[&](const LightEdit& light) { frame.lights[light.light] = light.after; },
                          [&](const MaterialEdit& switched) {
                            for (Material& material : frame.materials)
                              if (material.name == switched.material) material = switched.after;
                            if (is_new) frame.switched.push_back(switched);
                          },
                          [](const MoveEdit&) { GIBENCH_CHECK(false, "the schema admits lights and materials alone"); },
                          [](const DeformEdit&) { GIBENCH_CHECK(false, "the schema admits lights and materials alone"); }},
               edit);
  }

  void check() const {
    check_times(switches_, top_["switches"]);
    check_against_edits(switches_, top_["switches"]);
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      const JsonPlace keys = top_["lights"][i]["keys"];
      check_times(tracks_[i]["keys"], keys);
      json edits = tracks_[i]["keys"];
      for (json& edit : edits) edit["light"] = tracks_[i]["light"];
      check_index(tracks_[i]["light"].get<std::size_t>(), top_["lights"][i]["light"]);
      check_against_edits(edits, keys);
    }
  }

  void check_index(std::size_t light, const JsonPlace& place) const {
    if (light < written_lights_.size()) return;
    throw InputError(place.text(), fmt::format("there is no light {}", light),
                     written_lights_.empty() ? "the scene's file has no lights; switch the emission of a material"
                                             : fmt::format("write an index from 0 to {}", written_lights_.size() - 1));
  }

  static void check_times(const json& list, const JsonPlace& place) {
    for (std::size_t i = 1; i < list.size(); ++i)
      if (list[i]["at"].get<double>() < list[i - 1]["at"].get<double>())
        throw InputError(place[i]["at"].text(), "is earlier than the one before it", "write the times in ascending order");
  }

  void check_against_edits(const json& list, const JsonPlace& place) const {
    const json edits = without_times(list);
    for (std::size_t i = 0; i < edits.size(); ++i) check_against_scene_schema(edits[i], "edit", place[i]);
    read(edits, place);
  }

  static json without_times(json list) {
    for (json& item : list) item.erase("at");
    return list;
  }

  std::vector<SceneEdit> read(const json& edits, const JsonPlace& place) const {
    Scene scene;
    scene.origin = scene_.origin;
    scene.materials = scene_.materials;
    SceneAssembler assembler(scene);
    read_edits(edits, written_lights_, place, scene_.file.parent_path(), assembler);
    return scene.edits;
  }

  /// An edit that makes the light what its keys say of this time.
  static json light_at(const json& track, double at) {
    json edit{{"light", track["light"]}};
    const json& keys = track["keys"];
    for (const json& key : keys)
      for (const auto& [name, value] : key.items())
        if (name != "at" && !edit.contains(name)) edit[name] = value_at(keys, name, at);
    return edit;
  }
  static json value_at(const json& keys, const std::string& name, double at) {
    const json *before = nullptr, *after = nullptr;
    for (const json& key : keys) {
      if (!key.contains(name)) continue;
      if (key["at"].get<double>() <= at || before == nullptr) before = &key;
      if (key["at"].get<double>() > at && after == nullptr) after = &key;
    }
    if (after == nullptr || after == before) return (*before)[name];
    const double from = (*before)["at"].get<double>(), to = (*after)["at"].get<double>();
    return between((*before)[name], (*after)[name], std::clamp((at - from) / (to - from), 0.0, 1.0));
  }

  JsonPlace top_;
  const Scene& scene_;
  json document_, tracks_, switches_, written_lights_;
};

}  // namespace

std::vector<LightsFrame> read_moving_lights(const std::filesystem::path& file, const Scene& scene, std::optional<int> frames) {
  const MovingLights lights(file, scene);
  const int count = frames.value_or(lights.own_frames());
  std::vector<LightsFrame> result;
  double before = -1.0;
  for (int i = 0; i < count; ++i) {
    stop_if_cancelled();
    const double at = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
    result.push_back(lights.frame(before, at));
    before = at;
  }
  return result;
}

}  // namespace gibench
