/// The search for a scene that the user names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gibench {

struct KnownScene {
  std::string name;  ///< file name without .scene.json
  std::filesystem::path file;
};

/// The scene files that come with the program and those that its generators made.
std::vector<KnownScene> known_scenes();

/// The file that `name` stands for: a path as it is from the working folder, else beside `beside` (the folder of a
/// study file; may be empty), else one of known_scenes(), with or without ".scene.json". A name that is found nowhere
/// is given back unchanged for the loader, which also searches GIBENCH_PATH and words the error.
std::filesystem::path find_scene(const std::string& name, const std::filesystem::path& beside = {});

/// The study file that `name` stands for: a path as it is, else scenes/studies/NAME.study.json of those that come with the
/// program; a name that is found nowhere is given back unchanged.
std::filesystem::path find_study(const std::string& name);

}  // namespace gibench
