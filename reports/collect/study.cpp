#include "reports/collect/study.h"

#include <algorithm>

namespace gibench::report {

namespace {

const MeasuredError* find(const std::map<ErrorKey, MeasuredError>& errors, const ErrorKey& key) {
  const auto found = errors.find(key);
  return found == errors.end() ? nullptr : &found->second;
}

}  // namespace

const MeasuredError* StudyRun::error(const ErrorKey& key) const { return find(errors, key); }
const MeasuredError* StudyRun::model_error(const ErrorKey& key) const { return find(model_errors, key); }
const MeasuredError* StudyRun::discretisation_error(const ErrorKey& key) const {
  return complete == true ? error(key) : find(discretisation_errors, key);
}

std::optional<double> StudyRun::seconds_of(Stage stage) const {
  const auto found = seconds.find(stage);
  return found == seconds.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> StudyRun::shade_seconds(Domain domain) const {
  const auto of_domain = seconds_of(shade_stage(domain));
  return of_domain ? of_domain : seconds_of(Stage::shade);
}

std::optional<double> StudyRun::transport_seconds(Domain domain) const {
  const auto shade = shade_seconds(domain);
  if (!shade) return std::nullopt;
  return seconds_of(Stage::prepare).value_or(0.0) + seconds_of(Stage::light).value_or(0.0) + *shade;
}

std::optional<Comparison> StudyScene::comparison(const ErrorKey& key, std::size_t run, std::size_t other) const {
  const auto of_key = comparisons.find(key);
  if (of_key == comparisons.end()) return std::nullopt;
  for (const Comparison& found : of_key->second) {
    if (found.run == run && found.other == other) return found;
    if (found.run == other && found.other == run) return found.reversed();
  }
  return std::nullopt;
}

std::vector<std::string> Study::machines() const {
  std::vector<std::string> known;
  for (const StudyRun& run : runs)
    if (!run.machine.empty() && std::ranges::find(known, run.machine) == known.end()) known.push_back(run.machine);
  return known;
}

std::vector<std::size_t> Study::runs_of(const std::string& scene) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (runs[i].scene == scene) found.push_back(i);
  return found;
}

std::string without_folder(const Study& study, std::string message) {
  const std::string prefix = study.folder.string() + "/";
  for (std::size_t at = message.find(prefix); at != std::string::npos; at = message.find(prefix, at))
    message.erase(at, prefix.size());
  return message;
}

}  // namespace gibench::report
