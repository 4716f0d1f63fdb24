#include "bench/measure/scene_search.h"

#include <algorithm>
#include <system_error>

#include "common/core/data_folder.h"
#include "common/core/error.h"
#include "common/core/names.h"

namespace gibench {

namespace {

namespace fs = std::filesystem;

constexpr const char* extension = ".scene.json";
constexpr const char* study_extension = ".study.json";

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

std::vector<fs::path> scene_folders() { return {data_folder() / "scenes", data_folder() / "generated_scenes"}; }
fs::path study_folder() { return data_folder() / "scenes" / "studies"; }

/// The files NAME + `ending` of these folders, by name.
std::vector<KnownFile> files_in(const std::vector<fs::path>& folders, const std::string& ending) {
  std::vector<KnownFile> files;
  for (const fs::path& folder : folders) {
    std::error_code absent;
    for (const auto& entry : fs::directory_iterator(folder, absent)) {
      const std::string name = entry.path().filename().string();
      if (name.ends_with(ending) && is_file(entry.path()))
        files.push_back({name.substr(0, name.size() - ending.size()), entry.path()});
    }
  }
  std::sort(files.begin(), files.end(), [](const KnownFile& a, const KnownFile& b) { return a.name < b.name; });
  return files;
}

}  // namespace

std::vector<KnownFile> known_scenes() { return files_in(scene_folders(), extension); }

std::vector<KnownFile> known_studies() { return files_in({study_folder()}, study_extension); }

std::vector<std::string> names_of(const std::vector<KnownFile>& files) {
  std::vector<std::string> names;
  for (const KnownFile& file : files) names.push_back(file.name);
  return names;
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
  std::error_code ignored;
  if (fs::exists(name, ignored)) return name;
  const fs::path known = study_folder() / (name + study_extension);
  if (!fs::path(name).is_absolute() && is_file(known)) return known;
  throw InputError(name, "there is no study file of this name", known_names("studies", name, names_of(known_studies())));
}

}  // namespace gibench
