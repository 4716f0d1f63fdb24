/// A line on stderr that says how far work is and how long it may still take.
#pragma once

#include <chrono>
#include <string>

namespace gibench {

/// Shown only on a terminal, only after two seconds of work; its line is wiped at the end. From one thread.
class ProgressBar {
 public:
  /// `quiet` keeps it hidden.
  ProgressBar(std::string title, bool quiet);
  ~ProgressBar() { wipe(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `done`: share of the whole work, [0, 1].
  void update(const std::string& step, double done);
  /// Takes the line off the terminal so that other text may be printed.
  void wipe();

 private:
  using Clock = std::chrono::steady_clock;
  std::string title_;
  bool shown_, drawn_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

/// "8 s", "3 min 20 s", "2 h 5 min".
std::string describe_seconds(double seconds);

}  // namespace gibench
