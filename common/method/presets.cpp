#include "common/method/presets.h"

#include <algorithm>

#include "common/core/error.h"
#include "common/core/names.h"

namespace gibench {

SettingTexts with_preset(const std::vector<Preset>& presets, const std::string& name, const SettingTexts& own,
                         const std::string& place) {
  if (name.empty()) return own;
  const auto found = std::find_if(presets.begin(), presets.end(), [&](const Preset& preset) { return preset.name == name; });
  if (found == presets.end()) {
    std::vector<std::string> known;
    for (const Preset& preset : presets) known.push_back(preset.name);
    throw InputError(place, "there is no preset " + in_quotes(name), known_names("presets", name, known));
  }
  SettingTexts settings = found->settings;
  settings.insert(settings.end(), own.begin(), own.end());
  return settings;
}

}  // namespace gibench
