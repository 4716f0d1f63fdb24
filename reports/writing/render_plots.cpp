#include "reports/writing/render_plots.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <optional>

#include "reports/writing/resources.h"

extern char** environ;

namespace gibench::report {
namespace {

namespace fs = std::filesystem;

/// Exit status of a program found on PATH, its output going to a file; empty if it could not be started.
std::optional<int> run_program(std::vector<std::string> arguments, const fs::path& output) {
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  constexpr int write_anew = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), write_anew, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, pointers.front(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) return std::nullopt;
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return std::nullopt;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::vector<std::string> lines;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

}  // namespace

std::vector<std::string> render_plots(const fs::path& report_folder) {
  const fs::path resources = resources_folder();
  if (!fs::exists(resources / "node_modules" / "vega" / "package.json"))
    return {"the plots are left out: the packages of " + (resources / "package.json").string() +
            " are not installed (npm ci --omit=dev in that folder)"};
  const fs::path log = report_folder / "plots" / "render.log";
  const auto status = run_program({"node", (resources / "render.mjs").string(), report_folder.string()}, log);
  if (!status || *status == 127) {
    fs::remove(log);
    return {"the plots are left out as SVG and PDF: Node.js is not installed (package nodejs)"};
  }
  std::vector<std::string> lacking = lines_of(log);
  fs::remove(log);
  if (*status != 0 && lacking.empty()) lacking.push_back("exit status " + std::to_string(*status));
  if (*status != 0) return {"the plots are left out as SVG and PDF: render.mjs failed: " + lacking.front()};
  return lacking;
}

}  // namespace gibench::report
