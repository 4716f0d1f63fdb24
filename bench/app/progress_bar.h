/// A line on stderr that says how far work is and how long it may still take.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "bench/measure/progress.h"

namespace gibench {

/// Shown only on a terminal, only after two seconds of work; its line is wiped at the end. From one thread.
class ProgressBar : public Progress {
 public:
  explicit ProgressBar(std::string title);
  ~ProgressBar() override { wipe(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void update(const std::string& step, double done) override;
  /// To stderr, terminal or not.
  void note(const std::string& line) override;
  void hide() override { wipe(); }

 private:
  void wipe();

  using Clock = std::chrono::steady_clock;
  std::string title_;
  bool shown_, drawn_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

/// A bar of this title.
std::shared_ptr<Progress> show_on_terminal(const std::string& title);

/// "8 s", "3 min 20 s", "2 h 5 min".
std::string describe_seconds(double seconds);

}  // namespace gibench
