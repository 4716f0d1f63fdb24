/// What a method says about itself: its entry and its parameters.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "common/core/error.h"
#include "common/core/overloaded.h"
#include "common/method/method_session.h"
#include "tests/contract/contract.h"

namespace gibench::contract {

namespace {

bool is_one_line(const std::string& text) { return !text.empty() && text.find('\n') == std::string::npos; }

constexpr const char* lower_case = "abcdefghijklmnopqrstuvwxyz0123456789_";
/// A paper's symbols keep their capitals.
constexpr const char* letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";

/// What can be typed after `--method` or `--set` and named in a study file.
bool is_plain_name(const std::string& name, const char* allowed) {
  return !name.empty() && name.find_first_not_of(allowed) == std::string::npos;
}

/// The message with which a setting is refused; empty where it is taken.
std::string refusal_of(const MethodEntry& entry, const std::string& name, const std::string& value) {
  try {
    const Parameters parameters(entry.schema, {{name, value}});
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

/// `below` and `above`: the numbers nearest to the range outside it.
void verify_range(const MethodEntry& entry, const ParameterSpec& spec, double value, double below, double above) {
  if (!(spec.minimum <= value && value <= spec.maximum))
    throw Violation(
        fmt::format("the default of {} is {}, outside its range {}..{}", spec.name, value, spec.minimum, spec.maximum));
  for (const double outside : {below, above})
    if (const std::string message = refusal_of(entry, spec.name, fmt::format("{}", outside));
        message.find(spec.name) == std::string::npos)
      throw Violation(fmt::format("{}={} is out of range, but was not refused by name: '{}'", spec.name, outside, message));
}

void verify_parameter(const MethodEntry& entry, const ParameterSpec& spec) {
  if (!is_plain_name(spec.name, letters)) throw Violation(fmt::format("'{}' is not a plain name of a parameter", spec.name));
  if (!is_one_line(spec.meaning)) throw Violation(spec.name + " does not say in one line what it means");
  if (!is_one_line(describe_type(spec))) throw Violation(spec.name + " does not describe its type");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Overloaded verify{
      [](bool) {},
      [&](std::int64_t whole) { verify_range(entry, spec, static_cast<double>(whole), spec.minimum - 1.0, spec.maximum + 1.0); },
      [&](double real) {
        verify_range(entry, spec, real, std::nextafter(spec.minimum, -infinity), std::nextafter(spec.maximum, infinity));
      },
      [](const std::string&) {},
  };
  std::visit(verify, spec.default_value);
  const std::string text = to_text(spec.default_value);
  if (const std::string message = refusal_of(entry, spec.name, text); !message.empty())
    throw Violation(fmt::format("the default of {} is refused when it is written out: {}", spec.name, message));
  const Parameters written(entry.schema, {{spec.name, text}}), defaults(entry.schema, {});
  if (written.values() != defaults.values())
    throw Violation(fmt::format("{}={} is not read back as the default", spec.name, text));
}

}  // namespace

void verify_the_entry_describes_itself(const MethodEntry& entry) {
  if (!is_plain_name(entry.name, lower_case)) throw Violation(fmt::format("'{}' is not a plain name of a method", entry.name));
  for (const auto& [what, text] :
       {std::pair{"summary", &entry.summary}, {"source", &entry.source}, {"light_paths", &entry.light_paths}})
    if (!is_one_line(*text)) throw Violation(fmt::format("its {} is not one line of text", what));
  const Capabilities can = make_session(entry, Parameters(entry.schema, entry.quick))->capabilities();
  if (can.effects.empty()) throw Violation("it simulates no effect");
  if (!can.quantities.contains(Quantity::irradiance))
    throw Violation("it does not answer irradiance, in which methods are compared at surface samples");
  if (can.effects.contains(Effect::glossy_final_bounce) && !can.quantities.contains(Quantity::radiance))
    throw Violation("it simulates glossy final bounces but does not answer radiance, in which alone they are seen");
  if (!can.direct && !can.indirect) throw Violation("it computes neither direct nor indirect light");
}

void verify_unknown_parameters_are_refused(const MethodEntry& entry) {
  std::vector<std::string> unknown{"no_such_parameter", ""};
  for (const ParameterSpec& spec : entry.schema) unknown.push_back(spec.name + "_");
  for (const std::string& name : unknown) {
    const std::string message = refusal_of(entry, name, "1");
    if (message.empty()) throw Violation(fmt::format("the unknown parameter '{}' is taken", name));
    if (message.find("'" + name + "'") == std::string::npos)
      throw Violation(fmt::format("the refusal does not name the unknown parameter '{}': {}", name, message));
    for (const ParameterSpec& spec : entry.schema)
      if (message.find(spec.name) == std::string::npos)
        throw Violation(fmt::format("the refusal does not list the known parameter {}: {}", spec.name, message));
  }
}

void verify_presets_can_be_chosen(const MethodEntry& entry) {
  std::set<std::string> names;
  for (const Preset& preset : entry.presets) {
    if (!is_plain_name(preset.name, lower_case))
      throw Violation(fmt::format("'{}' is not a plain name of a preset", preset.name));
    if (!names.insert(preset.name).second) throw Violation("there are two presets called " + preset.name);
    if (!is_one_line(preset.meaning)) throw Violation(preset.name + " does not say in one line what it means");
    std::set<std::string> set;
    for (const auto& [name, value] : preset.settings) {
      if (!set.insert(name).second) throw Violation(fmt::format("the preset {} sets {} twice", preset.name, name));
      if (const std::string message = refusal_of(entry, name, value); !message.empty())
        throw Violation(fmt::format("the preset {} cannot be chosen: {}", preset.name, message));
    }
    make_session(entry, Parameters(entry.schema, preset.settings));
  }
}

void verify_parameters_describe_themselves(const MethodEntry& entry) {
  std::set<std::string> names;
  for (const ParameterSpec& spec : entry.schema) {
    if (!names.insert(spec.name).second) throw Violation("there are two parameters called " + spec.name);
    verify_parameter(entry, spec);
  }
}

}  // namespace gibench::contract
