#include "method_rules.h"

#include <algorithm>
#include <tuple>

#include "asking.h"
#include "common/method/method_session.h"

namespace gibench::truth {

namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

MethodRule rule_of(const std::string& method, const std::string& technique, Settings settings) {
  MethodRule rule;
  rule.method = method;
  rule.technique = technique;
  rule.settings = std::move(settings);
  return rule;
}

MethodRule path_tracing(const std::string& technique, Settings settings) {
  MethodRule rule = rule_of("pathtracer", technique, std::move(settings));
  rule.knows_its_errors = true;
  return rule;
}

MethodRule preset(const std::string& method, const std::string& name) {
  return rule_of(method, name, with_preset(find_method(method).presets, name, {}));
}

const std::vector<MethodRule>& rules() {
  static const std::vector<MethodRule> all = [] {
    MethodRule accessibility = rule_of("antiradiance", "accessibility", {{"mode", "accessibility"}});
    accessibility.quantity = Quantity::accessibility;
    MethodRule disc_bounce = rule_of("antiradiance", "disc_bounce", {{"mode", "disc-bounce"}});
    disc_bounce.most_bounces = 1;
    return std::vector<MethodRule>{
        path_tracing("", {}),
        path_tracing("roulette", {{"roulette_start", "1"}, {"roulette_below", "1"}, {"light_samples", "4"}}),
        rule_of("meshless", "", {}),
        rule_of("meshless", "exact", {{"first_bounce", "exact"}}),
        rule_of("meshless", "basis", {{"first_bounce", "basis"}, {"direct", "basis"}}),
        preset("meshless", "paper"),
        rule_of("spectral", "", {}),
        rule_of("spectral", "graph", {{"laplacian", "graph"}}),
        rule_of("spectral", "fixed_albedo", {{"mode", "fixed_albedo"}}),
        rule_of("spectral", "basis", {{"direct", "basis"}, {"compression", "rounding"}}),
        rule_of("antiradiance", "", {}),
        accessibility,
        rule_of("antiradiance", "radiosity", {{"mode", "radiosity"}}),
        rule_of("antiradiance", "implicit", {{"mode", "implicit"}}),
        disc_bounce,
        preset("antiradiance", "paper"),
        rule_of("wavelet", "", {}),
        rule_of("wavelet", "gathered", {{"mode", "gathered"}}),
    };
  }();
  return all;
}

bool is_asked(const MethodRule& rule, const Capabilities& can, const Question& question) {
  if (rule.quantity && question.quantity != *rule.quantity) return false;
  if (rule.most_bounces && (!question.bounces || *question.bounces > *rule.most_bounces)) return false;
  if (!rule.knows_its_errors && question.place == Place::sensor) return false;  // it lies on no surface
  if (question.quantity == Quantity::radiosity && can.quantities.contains(Quantity::irradiance)) return true;
  return can.quantities.contains(question.quantity);
}

}  // namespace

std::vector<MethodRule> all_rules() {
  std::vector<MethodRule> all = rules();
  for (const MethodEntry& entry : all_methods()) {
    if (std::any_of(all.begin(), all.end(), [&](const MethodRule& rule) { return rule.method == entry.name; })) continue;
    all.push_back(rule_of(entry.name, "", {}));
  }
  return all;
}

std::vector<std::vector<Question>> asked_of(const MethodRule& rule, const MethodEntry& entry, const TruthCase& truth) {
  const Capabilities can = make_session(entry, Parameters(entry.schema, rule.settings))->capabilities();
  std::vector<std::vector<Question>> groups;
  for (const Question& question : truth.questions) {
    if (!is_asked(rule, can, question)) continue;
    const auto found = std::ranges::find_if(groups, [&](const std::vector<Question>& group) {
      return group.front().emitters == question.emitters && group.front().bounces == question.bounces;
    });
    if (found == groups.end()) groups.push_back({question});
    else found->push_back(question);
  }
  std::erase_if(groups, [&](const auto& group) { return beyond(entry, *truth.world, group, rule.settings).has_value(); });
  for (auto& group : groups)
    std::ranges::stable_sort(group, {}, [](const Question& question) {
      return std::tuple(question.place == Place::mean, question.quantity, question.component);
    });
  return groups;
}

}  // namespace gibench::truth
