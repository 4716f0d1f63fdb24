/// A scene read and made ready for rays, with what that cost.
#pragma once

#include <memory>
#include <string>

#include "common/ray/world.h"
#include "common/scene_io/models/read_model.h"

namespace gibench {

struct LoadedScene {
  std::unique_ptr<World> world;
  double seconds = 0.0;  ///< reading and building the ray backend, wall clock

  const Scene& scene() const { return world->scene(); }
};

/// `name`: a path or the name of a known scene (bench/measure/scene_search.h). `read_bare_model`: as load_scene() takes it.
/// Throws InputError with file, JSON path and how to fix it.
LoadedScene load_world(const std::string& name, int threads, const ModelReader& read_bare_model = read_model);

}  // namespace gibench
