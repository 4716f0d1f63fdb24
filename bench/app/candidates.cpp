#include "bench/app/candidates.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "bench/app/value_kinds.h"
#include "bench/measure/scene_search.h"
#include "common/core/overloaded.h"
#include "common/effects/effect_plan.h"
#include "common/metrics/metric_table.h"
#include "methods/registry.h"

namespace gibench {

namespace {

std::vector<Candidate> method_names() {
  std::vector<Candidate> names;
  for (const MethodEntry& entry : all_methods()) names.push_back({entry.name, entry.summary});
  return names;
}

std::vector<Candidate> effect_names() {
  std::vector<Candidate> names;
  for (const Effect effect : all_effects()) names.push_back({to_string(effect), meaning_of(effect)});
  return names;
}

std::vector<Candidate> file_names(const std::vector<KnownFile>& files) {
  std::vector<Candidate> names;
  for (const KnownFile& file : files) names.push_back({file.name, {}});
  return names;
}

/// The names that `gibench list WHAT` lists.
std::vector<Candidate> listed_names(const std::string& what) {
  if (what == "methods") return method_names();
  if (what == "effects") return effect_names();
  if (what == "scenes") return file_names(known_scenes());
  std::vector<Candidate> names;
  if (what == "metrics")
    for (const Metric& metric : all_metrics()) names.push_back({metric.name, metric.meaning});
  return names;
}

/// What a parameter may be, where that is one of some words.
std::vector<std::string> choices_of(const ParameterSpec& spec) {
  using Words = std::vector<std::string>;
  return std::visit(Overloaded{[](bool) {
                                 return Words{"true", "false"};
                               },
                               [](std::int64_t) { return Words(); }, [](double) { return Words(); },
                               [&](const std::string&) { return spec.choices; }},
                    spec.default_value);
}

/// "samples=", and behind the sign what the parameter may be where these are words.
std::vector<Candidate> settings_of(const std::string& method, const std::string& typed) {
  std::vector<Candidate> settings;
  for (const MethodEntry& entry : all_methods()) {
    if (entry.name != method) continue;
    for (const ParameterSpec& spec : entry.schema) {
      const std::string begin = spec.name + "=";
      if (!typed.starts_with(begin)) {
        settings.push_back({begin, spec.meaning});
        continue;
      }
      for (const std::string& choice : choices_of(spec)) settings.push_back({begin + choice, {}});
    }
  }
  return settings;
}

std::vector<Candidate> presets_of(const std::string& method) {
  std::vector<Candidate> names;
  for (const MethodEntry& entry : all_methods())
    if (entry.name == method)
      for (const Preset& preset : entry.presets) names.push_back({preset.name, preset.meaning});
  return names;
}

/// The names behind the commas that stand already.
std::vector<Candidate> behind_commas(const std::vector<Candidate>& names, const std::string& typed) {
  const std::size_t comma = typed.rfind(',');
  const std::string begin = comma == std::string::npos ? std::string() : typed.substr(0, comma + 1);
  std::vector<Candidate> list;
  for (const Candidate& name : names) list.push_back({begin + name.word, name.meaning});
  return list;
}

/// A call as far as it is typed.
struct TypedCall {
  std::vector<std::string> arguments;  ///< without dashes, in their order
  std::vector<std::string> given;      ///< names of options
  std::string method;                  ///< of --method
  const CallOption* open = nullptr;    ///< the option whose value is being typed
};

const CallOption* find_option(const CallVerb& verb, const std::string& name) {
  for (const CallOption& option : verb.options)
    if (std::find(option.names.begin(), option.names.end(), name) != option.names.end()) return &option;
  return nullptr;
}

void take_value(const CallOption& option, const std::string& value, TypedCall& call) {
  if (option.value == value_kind::method) call.method = value;
}

/// Reads the words between the verb and the one that is completed.
TypedCall read_typed(const CallVerb& verb, const std::vector<std::string>& words) {
  TypedCall call;
  for (std::size_t i = 1; i + 1 < words.size(); ++i) {
    const std::string& word = words[i];
    if (call.open) {
      take_value(*call.open, word, call);
      call.open = nullptr;
      continue;
    }
    if (!word.starts_with("-")) {
      call.arguments.push_back(word);
      continue;
    }
    const std::size_t sign = word.find('=');
    const CallOption* option = find_option(verb, word.substr(0, sign));
    if (!option) continue;
    call.given.push_back(option->names.back());
    if (option->value.empty()) continue;
    if (sign == std::string::npos) call.open = option;
    else take_value(*option, word.substr(sign + 1), call);
  }
  return call;
}

class Completer {
 public:
  Completer(const CallTree& tree, const CallVerb& verb, const std::vector<std::string>& words)
      : tree_(tree), verb_(verb), call_(read_typed(verb, words)), current_(words.back()) {}

  Candidates complete() {
    if (call_.open) add_values(*call_.open, {}, current_);
    else if (const std::size_t sign = current_.find('='); current_.starts_with("--") && sign != std::string::npos)
      add_values_behind_sign(sign);
    else if (current_.starts_with("-")) add_options();
    else if (const CallOption* argument = next_argument()) add_values(*argument, {}, current_);
    else add_options();
    return found_;
  }

 private:
  const CallOption* next_argument() const {
    std::size_t place = 0;
    const CallOption* last = nullptr;
    for (const CallOption& option : verb_.options) {
      if (!option.is_argument()) continue;
      if (place++ == call_.arguments.size()) return &option;
      last = &option;
    }
    return last && last->repeats ? last : nullptr;
  }

  void add_options() {
    for (const CallOption& option : verb_.options) {
      if (option.is_argument()) continue;
      const std::string& name = option.names.back();
      const bool given = std::find(call_.given.begin(), call_.given.end(), name) != call_.given.end();
      if (option.repeats || !given) found_.words.push_back({name, option.meaning});
    }
  }

  void add_values_behind_sign(std::size_t sign) {
    if (const CallOption* option = find_option(verb_, current_.substr(0, sign)))
      add_values(*option, current_.substr(0, sign + 1), current_.substr(sign + 1));
  }

  void add_values(const CallOption& option, const std::string& before, const std::string& typed) {
    for (const std::string& kind : CLI::detail::split(option.value, '|'))
      for (const Candidate& candidate : values_of(kind, typed))
        found_.words.push_back({before + candidate.word, candidate.meaning});
  }

  std::vector<Candidate> values_of(const std::string& kind, const std::string& typed) {
    if (kind == value_kind::scene || kind == value_kind::study || kind == value_kind::file) found_.paths = Paths::files;
    if (kind == value_kind::folder) found_.paths = Paths::folders;
    if (kind == value_kind::scene) return file_names(known_scenes());
    if (kind == value_kind::study) return file_names(known_studies());
    if (kind == value_kind::method) return method_names();
    if (kind == value_kind::setting) return settings_of(call_.method, typed);
    if (kind == value_kind::preset) return presets_of(call_.method);
    if (kind == value_kind::effects) return behind_commas(effect_names(), typed);
    if (kind == value_kind::listed) return listed_names(call_.arguments.empty() ? "" : call_.arguments.back());
    if (kind == value_kind::verb) return verbs();
    const bool is_word = std::any_of(kind.begin(), kind.end(), [](char c) { return c >= 'a' && c <= 'z'; });
    return is_word ? std::vector<Candidate>{{kind, {}}} : std::vector<Candidate>{};
  }

  std::vector<Candidate> verbs() const {
    std::vector<Candidate> names;
    for (const CallVerb& verb : tree_.verbs) names.push_back({verb.name, verb.summary});
    return names;
  }

  const CallTree& tree_;
  const CallVerb& verb_;
  TypedCall call_;
  std::string current_;
  Candidates found_;
};

Candidates first_words(const CallTree& tree, const std::string& current) {
  Candidates found;
  if (current.starts_with("-"))
    for (const CallOption& option : tree.options) found.words.push_back({option.names.back(), option.meaning});
  else
    for (const CallVerb& verb : tree.verbs) found.words.push_back({verb.name, verb.summary});
  return found;
}

}  // namespace

Candidates candidates_for(const CallTree& tree, const std::vector<std::string>& words) {
  if (words.empty()) return first_words(tree, {});
  Candidates found;
  if (words.size() == 1) found = first_words(tree, words.front());
  else if (const CallVerb* verb = tree.find(words.front())) found = Completer(tree, *verb, words).complete();
  std::erase_if(found.words, [&](const Candidate& candidate) { return !candidate.word.starts_with(words.back()); });
  return found;
}

}  // namespace gibench
