/// A method as the program lists it and makes it.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/method/method.h"
#include "common/method/parameters.h"
#include "common/method/presets.h"

namespace gibench {

/// The description of a method and the function that makes it.
struct MethodEntry {
  std::string name;
  std::string summary;      ///< one line
  std::string source;       ///< the paper
  std::string light_paths;  ///< what it computes at most, as an OSL light-path expression; under a plan: light_paths()
  ParameterSchema schema;
  std::unique_ptr<TransportMethod> (*make)(const Parameters&);  ///< for a MethodSession: see make_session()
  /// Settings for a rough answer in little time, a second or less in a simple room: what the contract's tests run on.
  SettingTexts quick = {};
  /// The parameter, if any, whose choices are techniques of their own: each has to keep the contract.
  std::string technique_parameter = {};
  /// What `--preset` may name.
  std::vector<Preset> presets = {};
};

}  // namespace gibench
