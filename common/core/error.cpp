#include "common/core/error.h"

namespace gibench {

namespace {

std::string one_line(const std::string& place, const std::string& problem, const std::string& remedy) {
  std::string text = place + ": " + problem;
  if (!remedy.empty()) text += "; " + remedy;
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

}  // namespace

InputError::InputError(const std::string& place, const std::string& problem, const std::string& remedy)
    : std::runtime_error(one_line(place, problem, remedy)) {}

void check_failed(const char* condition, const char* message, const char* file, int line) {
  throw CheckFailed(std::string(file) + ":" + std::to_string(line) + ": check failed: " + message + " (" + condition + ")");
}

}  // namespace gibench
