/// The search for a scene or a study that the user names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gibench {

struct KnownFile {
  std::string name;  ///< file name without .scene.json, .study.json
  std::filesystem::path file;
};

/// The scene files that come with the program and those that its generators made.
std::vector<KnownFile> known_scenes();
/// The study files that come with the program.
std::vector<KnownFile> known_studies();
std::vector<std::string> names_of(const std::vector<KnownFile>& files);

/// The file that `name` stands for: a path as it is from the working folder, else beside `beside` (the folder of a
/// study file; may be empty), else one of known_scenes(), with or without ".scene.json". A name that is found nowhere
/// is given back unchanged for the loader, which also searches GIBENCH_PATH and words the error.
std::filesystem::path find_scene(const std::string& name, const std::filesystem::path& beside = {});

/// The study file that `name` stands for: a path as it is, else one of known_studies(). Throws InputError, the known names
/// listed, for a name that is found nowhere.
std::filesystem::path find_study(const std::string& name);

}  // namespace gibench
