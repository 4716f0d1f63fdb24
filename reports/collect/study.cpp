#include "reports/collect/study.h"

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

std::optional<double> StudyRun::transport_seconds(Domain domain) const {
  const auto stage = [this](const std::string& name) -> std::optional<double> {
    const auto found = seconds.find(name);
    return found == seconds.end() ? std::nullopt : std::optional(found->second);
  };
  const auto of_domain = stage(std::string("shade_") + to_string(domain));
  const auto shade = of_domain ? of_domain : stage("shade");
  if (!shade) return std::nullopt;
  return stage("prepare").value_or(0.0) + stage("light").value_or(0.0) + *shade;
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
