/// The built program, called as a user would, and the small files that it is called with.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/scratch_folder.h"

namespace gibench::test {

struct Outcome {
  int status = -1;  ///< exit status; 128 + signal where a signal ended it
  std::string out, error;

  /// stdout as JSON; a test failure and null where it is not JSON.
  nlohmann::ordered_json json() const;
  /// Lines on stderr.
  std::size_t error_lines() const;
};

/// A folder with scenes in it, in which the program runs.
class Workshop {
 public:
  Workshop();

  /// Runs gibench with the arguments in this folder; `before` is shell text put before it ("ulimit -t 1;").
  Outcome gibench(const std::vector<std::string>& arguments, const std::string& before = {}) const;
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
  const std::filesystem::path& path() const { return folder_.path(); }
  std::filesystem::path write(const std::string& name, const std::string& text) const;
  std::filesystem::path write(const std::string& name, const nlohmann::ordered_json& json) const {
    return write(name, json.dump(1));
  }
  std::string read(const std::string& name) const;
  nlohmann::ordered_json read_json(const std::string& name) const { return nlohmann::ordered_json::parse(read(name)); }
  bool has(const std::string& name) const { return std::filesystem::exists(folder_ / name); }

 private:
  ScratchFolder folder_;
};

/// Whether a command of this name is there on this machine.
bool is_installed(const std::string& command);

/// A unit room of white walls, lamp under the ceiling, camera of 8 × 8 pixels.
nlohmann::ordered_json room_scene(double albedo = 0.5);
/// The inside of a cube whose every face emits radiance 1 and reflects `albedo`: radiance 1 / (1 − albedo) everywhere.
nlohmann::ordered_json furnace_scene(double albedo = 0.5);

/// Expects exit status 2 and one line on stderr that holds every one of `words`; nothing on stdout.
void expect_bad_input(const Outcome& outcome, const std::vector<std::string>& words);

}  // namespace gibench::test
