/// The accuracy that the truth suite requires of every method, in one place.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "common/ray/world.h"
#include "methods/registry.h"
#include "truth_case.h"

namespace gibench::truth {

/// A question whose answer at the rule's settings is known to miss the rule's tolerance, from the noise of one seed to the next
/// say, and the tolerance that it must keep: the largest miss that was measured over several seeds, and half as much again.
struct NamedMiss {
  std::string question;
  double tolerance = 0.0;
  std::string cause;
};

/// How near a method has to come, and what it is not asked. What a method says itself (its capabilities, its
/// refusals) needs no line here.
struct MethodRule {
  std::string method;
  std::string technique;             ///< appended to the method's name where it has several rules
  std::optional<Quantity> quantity;  ///< the one that is asked; empty: all
  /// Share of the true value (or of a tenth of the case's largest one, where that is more). 0: the method knows its own
  /// standard errors, and is held to four of them.
  double tolerance = 0.0;
  std::vector<NamedMiss> misses;  ///< questions that the method answers less well, each held to a bound of its own
  std::vector<std::pair<std::string, std::string>> settings;
  bool asks_sensors = false;  ///< can be asked in empty space
  /// Questions nearer to another surface or to an open edge than this share of the scene's diagonal are left out:
  /// a finite-element solution need not resolve them.
  double clearance = 0.0;
  std::vector<std::pair<std::string, std::string>> not_cases;  ///< id of a case or of a question, and why it is left out

  /// The named miss's, or the rule's own.
  double tolerance_of(const std::string& question) const;
  std::string name() const { return technique.empty() ? method : method + "_" + technique; }
  friend void PrintTo(const MethodRule& rule, std::ostream* out) { *out << rule.name(); }  ///< for GoogleTest
};

/// Rules of every registered method: of one that has none, the tolerance of 2% at its default settings.
std::vector<MethodRule> all_rules();

/// Why this question of a case is not asked of the method; empty where it is.
std::optional<std::string> left_out(const MethodRule& rule, const MethodEntry& entry, const TruthCase& truth,
                                    const Question& question);

/// Metres from the question's point to the nearest surface that does not hold it, or to the nearest edge of its own plane's
/// surface.
double clearance_of(const Scene& scene, const Question& question);

}  // namespace gibench::truth
