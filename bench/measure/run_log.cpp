#include "bench/measure/run_log.h"

#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include "common/core/atomic_file.h"

namespace gibench {

RunLog::RunLog(const std::filesystem::path& file, bool quiet) {
  std::vector<spdlog::sink_ptr> sinks;
  if (!file.empty()) {
    write_file_atomically(file, {});  // says why where it cannot be written
    sinks.push_back(std::make_shared<spdlog::sinks::basic_file_sink_st>(file.string(), true));
    sinks.back()->set_pattern("%Y-%m-%d %H:%M:%S.%e %l %v");
  }
  if (!quiet) {
    sinks.push_back(std::make_shared<spdlog::sinks::stderr_sink_st>());
    sinks.back()->set_pattern("gibench: %l: %v");
    sinks.back()->set_level(spdlog::level::warn);
  }
  logger_ = std::make_unique<spdlog::logger>("run", sinks.begin(), sinks.end());
  logger_->flush_on(spdlog::level::warn);
  logger_->set_error_handler([](const std::string&) {});  // a disk that is full by now ends the run at its result
}

RunLog::~RunLog() = default;

void RunLog::info(const std::string& line) { logger_->info("{}", line); }
void RunLog::warn(const std::string& line) { logger_->warn("{}", line); }

}  // namespace gibench
