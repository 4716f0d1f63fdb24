/// A study as it is asked for: scenes × method variants, all checked before anything runs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bench/measure/measuring.h"
#include "bench/measure/plan_options.h"
#include "bench/measure/relight_options.h"
#include "common/method/parameters.h"

namespace gibench {

/// The text of scenes/study.schema.json (JSON Schema draft 7) as it was when the program was built.
const char* study_schema_text();

struct StudyScene {
  std::string name;            ///< file name without its extension, unique in the study
  std::filesystem::path file;  ///< as the loader takes it
};

/// One method with one set of parameters.
struct StudyVariant {
  std::string method, label;                                      ///< the label is unique in the study
  std::vector<std::string> settings;                              ///< "name=value", those that differ from nothing: as given
  std::map<std::string, ParameterValue, std::less<>> parameters;  ///< all of them, defaults included
  PlanOptions plan;                                               ///< what it may simulate
  std::set<std::size_t> scenes;                                   ///< places of the scenes on which it runs; empty: all

  bool runs_on(std::size_t scene) const { return scenes.empty() || scenes.contains(scene); }
};

/// A method prepared once and lit by moving lights.
struct StudyRelight {
  std::size_t scene = 0;  ///< place in the study
  std::filesystem::path lights;
  std::string method, label;                                      ///< the label is unique among those of the scene
  std::vector<std::string> settings;                              ///< "name=value"
  std::map<std::string, ParameterValue, std::less<>> parameters;  ///< all of them, defaults included
  RelightOptions options;
};

struct StudyReference {
  std::optional<std::uint64_t> samples_per_replica, picture_samples;  ///< paths for each value; at most so many for each pixel
  std::optional<double> target_error;
  int replicas = 8;
  std::optional<double> time_limit_seconds;
};

struct Study {
  std::string name;
  std::shared_ptr<const nlohmann::json> json;  ///< as read
  std::vector<StudyScene> scenes;
  std::vector<StudyVariant> variants;
  std::vector<StudyRelight> relights;
  std::optional<StudyReference> reference;
  MeasuringOptions measuring;
  int method_seeds = 1;  ///< with which each run is made, for its intervals
  std::optional<double> time_limit_seconds;
  std::optional<std::uint64_t> memory_limit_bytes;
};

/// The name of a run's folder as its scene and label make it: one that every file system takes.
std::string folder_name(const StudyScene& scene, const std::string& label);
/// As it stands in the name of a relighting's folder.
std::string relight_label(const std::string& label);
/// Of a folder's name: file systems take 255, and what is made beside it has up to 32 more in its name
/// (".99999", ".new-99999.partial").
inline constexpr std::size_t most_name_bytes = 223;

/// Reads, validates and expands the sweeps. Throws InputError with file, JSON path and how to fix it: unknown keys, methods and
/// parameters (the known ones listed), values out of range, labels or scenes that appear twice, labels that
/// make too long a name, scenes that do not exist.
Study read_study(const std::filesystem::path& file);

}  // namespace gibench
