#include "bench/measure/loaded_scene.h"

#include <chrono>

#include "bench/measure/scene_search.h"
#include "common/core/find_file.h"
#include "common/core/names.h"
#include "common/scene_io/load.h"

namespace gibench {

namespace {

/// As find_scene(); of a name that is found nowhere it says which known scene is near.
std::filesystem::path existing_scene(const std::string& name) {
  try {
    return find_file(find_scene(name), ".", name);
  } catch (const MissingFileError&) {
    throw MissingFileError(name, "there is no file or scene of this name, here or under a folder of GIBENCH_PATH",
                           known_names("scenes", name, names_of(known_scenes())));
  }
}

}  // namespace

LoadedScene load_world(const std::string& name, int threads, const ModelReader& read_bare_model) {
  const auto start = std::chrono::steady_clock::now();
  LoadedScene loaded;
  loaded.world = std::make_unique<World>(load_scene(existing_scene(name), read_bare_model), threads);
  loaded.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return loaded;
}

}  // namespace gibench
