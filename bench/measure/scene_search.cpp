#include "bench/measure/scene_search.h"

#include <algorithm>
#include <system_error>

#include "common/core/data_folder.h"

namespace gibench {

namespace {

namespace fs = std::filesystem;

constexpr const char* extension = ".scene.json";

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

std::vector<fs::path> scene_folders() { return {data_folder() / "scenes", data_folder() / "generated_scenes"}; }

}  // namespace

std::vector<KnownScene> known_scenes() {
  std::vector<KnownScene> scenes;
  for (const fs::path& folder : scene_folders()) {
    std::error_code absent;
    for (const auto& entry : fs::directory_iterator(folder, absent)) {
      const std::string name = entry.path().filename().string();
      if (name.ends_with(extension) && is_file(entry.path()))
        scenes.push_back({name.substr(0, name.size() - std::string(extension).size()), entry.path()});
    }
  }
  std::sort(scenes.begin(), scenes.end(), [](const KnownScene& a, const KnownScene& b) { return a.name < b.name; });
  return scenes;
}

fs::path find_scene(const std::string& name, const fs::path& beside) {
  if (is_file(name)) return name;
  std::vector<fs::path> folders = scene_folders();
  if (!beside.empty()) folders.insert(folders.begin(), beside);
  for (const fs::path& folder : folders)
    for (const std::string& candidate : {name, name + extension})
      if (!fs::path(name).is_absolute() && is_file(folder / candidate)) return folder / candidate;
  return name;
}

fs::path find_study(const std::string& name) {
  const fs::path known = data_folder() / "scenes" / "studies" / (name + ".study.json");
  return !is_file(name) && !fs::path(name).is_absolute() && is_file(known) ? known : fs::path(name);
}

}  // namespace gibench
