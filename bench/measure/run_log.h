/// The log of a run, line by line, with times: log.txt, and warnings on stderr.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace spdlog {
class logger;
}

namespace gibench {

class RunLog {
 public:
  /// Lines go to `file` (empty: none); warnings also to stderr unless `quiet`.
  RunLog(const std::filesystem::path& file, bool quiet);
  ~RunLog();

  void info(const std::string& line);
  void warn(const std::string& line);

 private:
  std::unique_ptr<spdlog::logger> logger_;
};

}  // namespace gibench
