/// Lights along a path and materials that switch on the way: the file of `gibench relight`, frame by frame.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace gibench {

/// The text of scenes/light-path.schema.json as it was when the program was built.
const char* light_path_schema_text();

/// The scene's lights and materials at one frame.
struct PathFrame {
  double at = 0.0;  ///< 0 for the first frame, 1 for the last
  std::vector<Light> lights;
  std::vector<Material> materials;
  std::vector<MaterialEdit> switched;  ///< since the frame before
};

/// All frames of a path on a scene: numbers of a light are interpolated linearly between the keys that give them and
/// held before the first and behind the last; switches act from the first frame at or behind their time. `frames`: how many, in
/// place of the file's own. Throws InputError with file, JSON path and how to fix it; everything is checked before any work.
std::vector<PathFrame> read_light_path(const std::filesystem::path& file, const Scene& scene, std::optional<int> frames);

}  // namespace gibench
