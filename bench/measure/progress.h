/// The progress of work, for whoever shows it: the program shows it on a terminal.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace gibench {

/// One piece of work with a title; this one shows nothing. From one thread.
class Progress {
 public:
  Progress() = default;
  virtual ~Progress() = default;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done`: share of the whole work, [0, 1].
  virtual void update([[maybe_unused]] const std::string& step, [[maybe_unused]] double done) {}
  /// A line that stays.
  virtual void note([[maybe_unused]] const std::string& line) {}
  /// Nothing is left shown but the notes, so that other text may be printed.
  virtual void hide() {}
};

/// Begins to show a piece of work of this title.
using ShowProgress = std::function<std::shared_ptr<Progress>(const std::string& title)>;

}  // namespace gibench
