#include "bench/study/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <thread>

#include "bench/measure/cancellation.h"
#include "common/core/atomic_file.h"
#include "common/core/error.h"

namespace gibench {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds shortest_pause{1}, longest_pause{20};
constexpr double grace_seconds = 5.0;  // from being asked to stop to being killed

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  for (std::string& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

std::vector<std::string> child_environment(const std::filesystem::path& error_file) {
  std::vector<std::string> variables;
  const std::string parent = std::string(parent_variable) + "=", error = std::string(error_file_variable) + "=";
  for (char** variable = environ; *variable; ++variable)
    if (const std::string_view text(*variable); !text.starts_with(parent) && !text.starts_with(error))
      variables.emplace_back(text);
  variables.push_back(parent + std::to_string(getpid()));
  if (!error_file.empty()) variables.push_back(error + error_file.string());
  return variables;
}

/// posix_spawn_file_actions_t that is always given back.
struct FileActions {
  posix_spawn_file_actions_t actions;
  FileActions() { posix_spawn_file_actions_init(&actions); }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  void send(int descriptor, const std::filesystem::path& file) {
    posix_spawn_file_actions_addopen(&actions, descriptor, file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  }
};

pid_t spawn(const std::vector<std::string>& arguments, const ChildFiles& redirected) {
  std::vector<std::string> texts{"gibench"};
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = child_environment(redirected.error_record);
  FileActions files;
  posix_spawn_file_actions_addopen(&files.actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  files.send(STDOUT_FILENO, redirected.out);
  files.send(STDERR_FILENO, redirected.error);
  pid_t process = 0;
  const int failed =
      posix_spawn(&process, "/proc/self/exe", &files.actions, nullptr, pointers(texts).data(), pointers(variables).data());
  if (failed != 0) throw WorkError(std::string("no process can be started: ") + std::strerror(failed));
  return process;
}

/// Resident bytes now; 0 for a process that is gone.
std::uint64_t resident_bytes(pid_t process) {
  std::ifstream in(fmt::format("/proc/{}/statm", process));
  std::uint64_t total = 0, resident = 0;
  in >> total >> resident;
  return in ? resident * static_cast<std::uint64_t>(sysconf(_SC_PAGE_SIZE)) : 0;
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of("\r\n ");
  if (end == std::string::npos) return {};
  const std::size_t begin = text.find_last_of('\n', end);
  return text.substr(begin == std::string::npos ? 0 : begin + 1, end - (begin == std::string::npos ? 0 : begin + 1) + 1);
}

/// Watches a child until it ends, and ends it where it passes a limit or the user asks to stop.
class Watch {
 public:
  Watch(pid_t process, const ChildLimits& limits) : process_(process), limits_(limits) {}

  ChildResult until_end() {
    std::chrono::milliseconds pause = shortest_pause;
    int status = 0;
    rusage usage{};
    while (wait4(process_, &status, WNOHANG, &usage) == 0) {
      act(std::chrono::duration<double>(Clock::now() - start_).count());
      std::this_thread::sleep_for(pause);
      pause = std::min(2 * pause, longest_pause);
    }
    ChildResult result;
    result.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    result.peak_bytes = static_cast<std::uint64_t>(std::max(0L, usage.ru_maxrss)) * 1024;
    if (WIFSIGNALED(status)) result.end = ChildEnd::signalled, result.signal = WTERMSIG(status);
    else result.exit_code = WEXITSTATUS(status);
    if (why_ && (*why_ == ChildEnd::cancelled || WIFSIGNALED(status))) result.end = *why_;
    return result;
  }

 private:
  void act(double seconds) {
    if (!why_ && cancellation()->load()) end(ChildEnd::cancelled, SIGTERM, seconds);
    if (!why_ && limits_.seconds && seconds > *limits_.seconds) end(ChildEnd::timed_out, SIGKILL, seconds);
    if (!why_ && limits_.bytes && resident_bytes(process_) > *limits_.bytes) end(ChildEnd::over_memory, SIGKILL, seconds);
    if (why_ && seconds > asked_at_ + grace_seconds) kill(process_, SIGKILL);
  }

  void end(ChildEnd why, int signal, double seconds) {
    why_ = why;
    asked_at_ = seconds;
    kill(process_, signal);
  }

  pid_t process_;
  ChildLimits limits_;
  Clock::time_point start_ = Clock::now();
  std::optional<ChildEnd> why_;
  double asked_at_ = 0.0;
};

}  // namespace

ChildResult run_child(const std::vector<std::string>& arguments, const ChildLimits& limits, const ChildFiles& files) {
  std::error_code ignored;
  std::filesystem::remove(files.error_record, ignored);
  ChildResult result = Watch(spawn(arguments, files), limits).until_end();
  result.out = read_file(files.out);
  result.last_line = last_line(read_file(files.error));
  result.error = read_error_record(files.error_record);
  return result;
}

ChildResult run_child(const std::vector<std::string>& arguments, const ChildLimits& limits, const std::filesystem::path& scratch,
                      const std::string& name) {
  return run_child(arguments, limits,
                   ChildFiles{scratch / (name + ".out"), scratch / (name + ".err"), scratch / (name + ".error")});
}

std::string describe_signal(int signal) {
  const char* description = sigdescr_np(signal);
  return description ? description : fmt::format("signal {}", signal);
}

}  // namespace gibench
