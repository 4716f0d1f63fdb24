#include "bench/measure/loaded_scene.h"

#include <chrono>

#include "bench/measure/scene_search.h"
#include "common/scene/load.h"

namespace gibench {

LoadedScene load_world(const std::string& name, int threads) {
  const auto start = std::chrono::steady_clock::now();
  LoadedScene loaded;
  loaded.world = std::make_unique<World>(load_scene(find_scene(name)), threads);
  loaded.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return loaded;
}

}  // namespace gibench
