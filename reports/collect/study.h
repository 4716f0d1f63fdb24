/// A study as the report sees it: what the manifest, the run records and the references say. What was not measured
/// is absent.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/record/process_record.h"
#include "bench/record/relight_economics.h"
#include "bench/record/stage.h"
#include "common/effects/component.h"
#include "common/effects/scene_effects.h"
#include "common/method/stage_report.h"
#include "common/metrics/domain.h"

namespace gibench::report {

/// Name and value as text, in the order of the file.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// Which error; the metric by its name.
struct ErrorKey {
  Domain domain = Domain::surface;
  Component component = Component::indirect;
  std::string metric;
  auto operator<=>(const ErrorKey&) const = default;
};

struct MeasuredError {
  double value = 0.0;
  std::optional<double> low, high;  ///< 95% interval
  std::optional<double> noise_floor;
  bool resolved = true;  ///< the interval leaves out "no error"; otherwise its far end is all that is known
};

struct StudyRun {
  std::string id, label, scene, method;
  Facts parameters;
  RunStatus status = RunStatus::failed;
  std::optional<int> exit_code;
  std::string message;                      ///< why it did not come to its end; empty for a run that did
  std::filesystem::path folder;             ///< holds result.json, image.exr, log.txt
  std::optional<double> wall_seconds;       ///< of the whole process
  std::optional<std::uint64_t> peak_bytes;  ///< of the whole process

  // From result.json.
  std::string machine;         ///< processor, cores, compiler and build: seconds of different ones do not compare
  std::string surface_domain;  ///< of its surface samples: seen, all, whole or names of objects
  std::size_t surface_samples = 0;
  std::optional<std::uint64_t> seed, threads;
  std::optional<EffectPlan> effects;
  std::map<Stage, double> seconds;  ///< of those that were recorded
  std::optional<std::uint64_t> method_bytes;
  std::map<std::string, std::uint64_t> counters;
  std::vector<std::string> warnings;
  std::optional<Termination> termination;
  std::string light_paths;  ///< what it simulated; empty where its record does not say
  /// All light paths of the scene: no model error, and all error is discretisation error. Empty where the record does not say.
  std::optional<bool> complete;
  std::map<ErrorKey, MeasuredError> errors;
  std::string pair_checksum;  ///< of the terms by which its errors are compared with others'; empty where there are none
  std::map<ErrorKey, MeasuredError> model_errors, discretisation_errors;  ///< empty where they were not measured
  /// By number of reflections; of a bounce that is complete the model errors are empty.
  struct Bounce {
    int number = 0;
    bool complete = false;
    std::map<ErrorKey, MeasuredError> model_errors, discretisation_errors;
  };
  std::vector<Bounce> bounces;
  Facts details;  ///< what else its record says: where it was measured, what the shared evaluator answered, the reference

  const MeasuredError* error(const ErrorKey& key) const;
  const MeasuredError* model_error(const ErrorKey& key) const;
  /// The error itself for a run that has all light paths.
  const MeasuredError* discretisation_error(const ErrorKey& key) const;
  std::optional<double> seconds_of(Stage stage) const;
  /// Of shading the domain, or of all shading where the stages are not recorded separately.
  std::optional<double> shade_seconds(Domain domain) const;
  /// Seconds that the answer of a domain cost: preparing, lighting and shading. Reading the scene is the same for every method
  /// and left out.
  std::optional<double> transport_seconds(Domain domain) const;
};

/// A method prepared once and lit by moving lights.
struct StudyRelight {
  std::string id, label, scene, method, lights;
  Facts parameters;
  RunStatus status = RunStatus::failed;
  std::string message;
  std::optional<std::uint64_t> frames;
  std::optional<double> prepare_seconds;
  std::optional<double> relight_seconds, shade_seconds;  ///< medians over the frames
  std::optional<Bounded> path_tracing_seconds;           ///< to the frame's error in the indirect light
  std::optional<Bounded> times_cheaper;                  ///< than path tracing
  std::optional<Bounded> frames_that_pay;                ///< for preparing

  struct Frame {
    double at = 0.0;  ///< 0 for the first, 1 for the last
    std::vector<std::string> switched;
    std::optional<double> relight_seconds, shade_seconds;
    std::map<Component, MeasuredError> relative_rmse;  ///< at the surface samples
  };
  std::vector<Frame> all_frames;

  std::optional<double> frame_seconds() const {
    return relight_seconds && shade_seconds ? std::optional(*relight_seconds + *shade_seconds) : std::nullopt;
  }
};

/// The error of one run minus that of another against the same reference, at the same points.
struct Comparison {
  std::size_t run = 0, other = 0;  ///< positions in the study's runs
  double difference = 0.0;         ///< in the metric's unit
  double low = 0.0, high = 0.0;    ///< its 95% interval

  /// Whether the interval leaves out zero: one of the two is the better one.
  bool told_apart() const { return low > 0.0 || high < 0.0; }
  /// Seen from the other run.
  Comparison reversed() const { return {other, run, -difference, -high, -low}; }
};

struct StudyScene {
  std::string name;
  std::optional<std::string> skipped;   ///< why the study left the scene out
  float exposure = 0.0F;                ///< stops at which its pictures are shown
  std::vector<EffectEvidence> effects;  ///< what it calls for, and why
  std::string bounces, bounce_bound;    ///< how many reflections its light needs, and the evidence
  Facts facts;                          ///< camera, resolution, geometry, …
  std::filesystem::path reference_folder;
  Facts reference;  ///< reference.json; empty where there is none
  /// Of every two of the runs whose errors are smallest, as they are shown; empty where they cannot be compared.
  std::map<ErrorKey, std::vector<Comparison>> comparisons;

  /// Null where the two were not compared. The comparison of `run` with `other`.
  std::optional<Comparison> comparison(const ErrorKey& key, std::size_t run, std::size_t other) const;
};

struct Study {
  std::filesystem::path folder;
  std::string name, version, commit, created;
  Facts machine;
  Facts settings;  ///< the rest of the manifest's own entries: seed, threads, …
  std::vector<StudyScene> scenes;
  std::vector<StudyRun> runs;
  std::vector<StudyRelight> relights;
  std::vector<std::string> warnings;  ///< what could not be read, a line each

  /// Those that runs with a result were measured on, in the order of the runs.
  std::vector<std::string> machines() const;
  /// Positions in `runs`, in the order of the manifest.
  std::vector<std::size_t> runs_of(const std::string& scene) const;
};

/// The message with the study folder's path left out: the report is read elsewhere.
std::string without_folder(const Study& study, std::string message);

}  // namespace gibench::report
