#include "bench/app/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gibench {

namespace {

constexpr double seconds_before_shown = 2.0, seconds_between_drawings = 0.1;
constexpr int bar_width = 24;  // characters

}  // namespace

std::string describe_seconds(double seconds) {
  const auto whole = static_cast<long>(std::ceil(std::max(0.0, seconds)));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

ProgressBar::ProgressBar(std::string title) : title_(std::move(title)), shown_(isatty(STDERR_FILENO) == 1) {}

void ProgressBar::update(const std::string& step, double done) {
  if (!shown_) return;
  const Clock::time_point now = Clock::now();
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  if (elapsed < seconds_before_shown) return;
  if (drawn_ && std::chrono::duration<double>(now - last_).count() < seconds_between_drawings) return;
  last_ = now;
  drawn_ = true;
  done = std::clamp(done, 0.0, 1.0);
  const int filled = static_cast<int>(std::lround(done * bar_width));
  const std::string left = done > 0.0 ? describe_seconds(elapsed * (1.0 - done) / done) + " left" : "";
  fmt::print(stderr, "\r\033[K{} [{:#>{}}{:.>{}}] {:3.0f}% {} {}", title_, "", filled, "", bar_width - filled, 100.0 * done, left,
             step);
  std::fflush(stderr);
}

void ProgressBar::note(const std::string& line) {
  wipe();
  fmt::print(stderr, "{}\n", line);
}

void ProgressBar::wipe() {
  if (drawn_) std::fputs("\r\033[K", stderr);
  drawn_ = false;
}

std::shared_ptr<Progress> show_on_terminal(const std::string& title) { return std::make_shared<ProgressBar>(title); }

}  // namespace gibench
