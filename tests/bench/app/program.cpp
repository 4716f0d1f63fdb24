#include "tests/bench/app/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace gibench::test {

namespace {

using Json = nlohmann::ordered_json;

std::string quoted(const std::string& text) {
  std::string shell = "'";
  for (const char c : text) {
    if (c == '\'') shell.append("'\\''");
    else shell.push_back(c);
  }
  return shell.append("'");
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Six quads of the unit cube, fronts inwards.
Json room_object(const std::string& material) {
  return {{"name", "room"},
          {"material", material},
          {"vertices", {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}, {0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}}},
          {"faces", {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 4, 7, 3}, {1, 2, 6, 5}}}};
}

Json small_camera() {
  return {{"name", "main"},  {"position", {0.5, 0.5, 0.95}}, {"look_at", {0.5, 0.4, 0}},
          {"up", {0, 1, 0}}, {"vertical_fov_degrees", 70},   {"resolution", {8, 8}}};
}

}  // namespace

Json Outcome::json() const {
  const Json parsed = Json::parse(out, nullptr, false);
  EXPECT_FALSE(parsed.is_discarded()) << "not JSON: " << out << error;
  return parsed.is_discarded() ? Json() : parsed;
}

std::size_t Outcome::error_lines() const { return static_cast<std::size_t>(std::count(error.begin(), error.end(), '\n')); }

Workshop::Workshop() {
  write("room.scene.json", room_scene());
  write("furnace.scene.json", furnace_scene());
}

Outcome Workshop::gibench(const std::vector<std::string>& arguments, const std::string& before) const {
  std::string command = "cd ";
  command.append(quoted(path().string()))
      .append("; ulimit -c 0; ")
      .append(before)
      .append(" exec ")
      .append(quoted(GIBENCH_PROGRAM));
  for (const std::string& argument : arguments) command.append(" ").append(quoted(argument));
  command.append(" >").append(quoted((folder_ / "stdout.txt").string()));
  command.append(" 2>").append(quoted((folder_ / "stderr.txt").string()));
  Outcome outcome;
  const int status = std::system(command.c_str());
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.out = text_of(folder_ / "stdout.txt");
  outcome.error = text_of(folder_ / "stderr.txt");
  return outcome;
}

std::filesystem::path Workshop::write(const std::string& name, const std::string& text) const {
  std::filesystem::create_directories((folder_ / name).parent_path());
  std::ofstream(folder_ / name, std::ios::binary) << text;
  return folder_ / name;
}

std::string Workshop::read(const std::string& name) const { return text_of(folder_ / name); }

bool is_installed(const std::string& command) { return std::system(("command -v " + command + " >/dev/null 2>&1").c_str()) == 0; }

Json room_scene(double albedo) {
  return {{"gibench_scene", 1},
          {"name", "room"},
          {"materials",
           {{"wall", {{"bsdf", "diffuse"}, {"albedo", albedo}}},
            {"lamp", {{"bsdf", "diffuse"}, {"albedo", 0.0}, {"emission", {10, 9, 8}}}}}},
          {"objects",
           {room_object("wall"),
            {{"name", "lamp"},
             {"material", "lamp"},
             {"vertices", {{0.3, 0.99, 0.3}, {0.7, 0.99, 0.3}, {0.7, 0.99, 0.7}, {0.3, 0.99, 0.7}}},
             {"faces", {{0, 1, 2, 3}}}}}},
          {"cameras", {small_camera()}}};
}

Json furnace_scene(double albedo) {
  return {{"gibench_scene", 1},
          {"name", "furnace"},
          {"materials", {{"wall", {{"bsdf", "diffuse"}, {"albedo", albedo}, {"emission", 1.0}}}}},
          {"objects", {room_object("wall")}},
          {"cameras", {small_camera()}}};
}

void expect_bad_input(const Outcome& outcome, const std::vector<std::string>& words) {
  EXPECT_EQ(outcome.status, 2) << outcome.error;
  EXPECT_EQ(outcome.error_lines(), 1U) << outcome.error;
  EXPECT_EQ(outcome.out, "");
  for (const std::string& word : words) EXPECT_THAT(outcome.error, testing::HasSubstr(word));
}

}  // namespace gibench::test
