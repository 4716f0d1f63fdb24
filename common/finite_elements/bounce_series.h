/// The Neumann series of light, bounce by bounce: how many there may be, when it may end, and the message about its end.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

namespace gibench {

/// When the bounces end.
struct BounceBound {
  std::optional<int> planned;  ///< reflections between a light and the surface asked about, at most
  int most = 1000;             ///< computed
  double residual = 1e-3;      ///< share of the solution that the bounces left out may hold

  int last() const { return std::min(planned.value_or(most), most); }
};

/// Ratio of a bounce to the one before from which on bounces do not fade.
inline constexpr double fading_ratio = 1.0 - 1e-6;

/// The share that light loses from one bounce to the next at this ratio, never quite nothing: all bounces after the last one
/// hold ratio / share_lost(ratio) of it, were the ratio to stay.
constexpr double share_lost(double ratio) { return std::max(1.0 - fading_ratio, 1.0 - ratio); }

/// How far a residual has fallen on its way to the one wanted, [0, 1], on a logarithmic scale.
double progress_of(double residual, double wanted);

/// Counts the bounces that a method adds up, and judges each by what the method measured of it:
/// while (series.goes_on()) { ...make bounce number series.next()...; series.add(ratio, residual); }
class BounceSeries {
 public:
  explicit BounceSeries(const BounceBound& bound) : bound_(bound) {}

  bool goes_on() const { return !settled_ && bounces_ < bound_.last(); }
  int next() const { return bounces_ + 1; }

  /// One more bounce, of which nothing is known yet.
  void add() { ++bounces_; }
  /// One more bounce: its ratio to the one before, and the share of the solution in the bounces left out. The series is
  /// settled where that is smaller than the bound's.
  void add(double ratio, double residual);
  /// No further bounce is needed.
  void settle() { settled_ = true; }

  int bounces() const { return bounces_; }
  int last() const { return bound_.last(); }
  double residual() const { return residual_; }
  bool fades() const { return !(ratio_ > fading_ratio); }
  bool settled() const { return settled_; }
  /// The bounces asked for were computed, or enough of them, or they would have come to an end: false where they do not fade
  /// and no plan bounds them.
  bool succeeded() const { return settled_ || bound_.planned || bounces_ < last() || fades(); }
  /// [0, 1], by the bound or by the residual, whichever is nearer to its end.
  double progress() const;
  /// One line; empty where the series settled.
  std::string message() const;

 private:
  BounceBound bound_;
  int bounces_ = 0;
  double ratio_ = 0.0, residual_ = 0.0;
  bool settled_ = false;
};

}  // namespace gibench
