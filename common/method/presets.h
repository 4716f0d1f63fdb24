/// Presets: named sets of a method's parameters.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace gibench {

/// (name, text) as after `--set`.
using SettingTexts = std::vector<std::pair<std::string, std::string>>;

/// A set of parameters under a name of its own. `paper` is the name of the source's algorithm and constants, exactly.
struct Preset {
  std::string name;
  std::string meaning;    ///< one line
  SettingTexts settings;  ///< all other parameters keep their defaults
};

/// The settings of the preset, then `own`, which override them. Throws InputError, the known presets listed, for a name that
/// `presets` do not have; `place` is where it is named. An empty name is no preset.
SettingTexts with_preset(const std::vector<Preset>& presets, const std::string& name, const SettingTexts& own,
                         const std::string& place = "--preset");

}  // namespace gibench
