/// Lights that move and materials that switch over time: the file of `gibench relight`, frame by frame.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace gibench {

/// The text of scenes/light-path.schema.json as it was when the program was built.
const char* moving_lights_schema_text();

/// The scene's lights and materials at one frame.
struct LightsFrame {
  double at = 0.0;  ///< 0 for the first frame, 1 for the last
  std::vector<Light> lights;
  std::vector<Material> materials;
  std::vector<MaterialEdit> switched;  ///< since the frame before
};

/// All frames of a file of moving lights on a scene: numbers of a light are interpolated linearly between the keys that give them
/// and held before the first and behind the last; switches act from the first frame at or behind their time. `frames`: how many,
/// in place of the file's own. Throws InputError with file, JSON path and how to fix it; everything is checked before any work.
std::vector<LightsFrame> read_moving_lights(const std::filesystem::path& file, const Scene& scene, std::optional<int> frames);

}  // namespace gibench
