/// The record of a study: manifest.json, its scenes, runs and relightings, written and read here.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/record/check_record.h"
#include "bench/record/machine.h"
#include "bench/record/process_record.h"
#include "bench/record/run_record.h"

namespace gibench {

inline constexpr const char* manifest_file = "manifest.json";

struct StudySceneRecord {
  std::string name, file;
  std::optional<std::string> skipped;            ///< why its runs are left out; nothing else is known then
  std::optional<SceneAnalysis> analysis;         ///< empty: not checked yet
  std::optional<std::string> camera;             ///< name of the one that pictures are taken with
  std::optional<Exposure> exposure;              ///< at which its pictures are shown
  std::optional<std::array<int, 2>> resolution;  ///< of its reference's picture, pixels
  std::optional<std::string> reference;          ///< folder of its reference within the study's
  std::string message;                           ///< why there is none
};

/// One run, or one relighting.
struct StudyRunRecord {
  std::string id, label, scene, method;
  ParameterValues parameters;
  std::optional<std::string> lights;  ///< of a relighting: its file of moving lights
  ProcessRecord process;
  std::string folder;  ///< of its records within the study's
};

struct StudyRecord {
  std::string name;
  Origin origin;
  std::string created;  ///< UTC
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all cores
  int jobs = 1;
  std::shared_ptr<const nlohmann::json> study;  ///< the study file as it was read; empty: not recorded
  std::vector<StudySceneRecord> scenes;
  std::vector<StudyRunRecord> runs, relights;
  bool damaged = false;  ///< as it was read: its checksum does not fit what it says
};

nlohmann::ordered_json to_json(const StudySceneRecord& scene);
nlohmann::ordered_json to_json(const StudyRunRecord& run);
/// Without the checksum that the file has.
nlohmann::ordered_json to_json(const StudyRecord& record);
/// Throws InputError that names the file.
StudyRecord read_study_record(const std::filesystem::path& file);

}  // namespace gibench
