/// The rules of the truth suite: which methods are asked, in which modes, and what of a case each is asked.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "methods/registry.h"
#include "truth_case.h"

namespace gibench::truth {

/// A method in one of its modes. What it says itself (its capabilities, its refusals) needs no line here; which cases it is
/// asked stands in runs.txt, how near it has to come in bounds.json.
struct MethodRule {
  std::string method;
  std::string technique;             ///< appended to the method's name where it has several rules
  std::optional<Quantity> quantity;  ///< the one that is asked; empty: all
  std::optional<int> most_bounces;   ///< questions of more reflections, or of all, are not asked
  /// The method knows its own standard errors, and is held to four of them; it can be asked in empty space, too.
  bool knows_its_errors = false;
  std::vector<std::pair<std::string, std::string>> settings;

  std::string name() const { return technique.empty() ? method : method + "_" + technique; }
  friend void PrintTo(const MethodRule& rule, std::ostream* out) { *out << rule.name(); }  ///< for GoogleTest
};

/// Rules of every registered method: of one that has none, all questions at its default settings.
std::vector<MethodRule> all_rules();

/// The questions that the method is asked and does not refuse, in groups that one preparation answers: the same emitters and
/// bounce bound.
std::vector<std::vector<Question>> asked_of(const MethodRule& rule, const MethodEntry& entry, const TruthCase& truth);

}  // namespace gibench::truth
