/// The error channels: bad input throws InputError; work that could not be finished throws WorkError; a programmer's error
/// throws CheckFailed. The outcome of numerics goes into a StageReport, it is never thrown. Nothing ends the process.
#pragma once

#include <stdexcept>
#include <string>

namespace gibench {

/// The input or the call is wrong. `what()` is one line: place, what is wrong, how to fix it. Exit status 2.
class InputError : public std::runtime_error {
 public:
  /// place: file, JSON path or option; problem: what is wrong there; remedy: what to write instead (may be empty).
  InputError(const std::string& place, const std::string& problem, const std::string& remedy = {});
};

/// The work itself failed: out of time or memory, no convergence, a method that refused the scene. Exit status 4.
class WorkError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An invariant is broken, which is an error in the program that calls or in the library. `what()` is one line with file,
/// line, message and condition. Exit status 4.
class CheckFailed : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws CheckFailed; see GIBENCH_CHECK.
[[noreturn]] void check_failed(const char* condition, const char* message, const char* file, int line);

}  // namespace gibench

/// A programmer's error: checked in every build, because a wrong picture costs more than a branch.
#define GIBENCH_CHECK(condition, message) \
  (static_cast<bool>(condition) ? void(0) : ::gibench::check_failed(#condition, message, __FILE__, __LINE__))
