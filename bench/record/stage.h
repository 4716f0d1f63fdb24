/// The stages of a run, as records time them.
#pragma once

#include <array>

#include "common/metrics/domain.h"

namespace gibench {

enum class Stage {
  load,           ///< reading the scene and building the ray backend
  prepare,        ///< geometry and materials
  light,          ///< the lights
  shade,          ///< all answers together
  shade_surface,  ///< answers at the surface samples
  shade_image,    ///< answers in the picture
};

inline constexpr std::array all_stages{Stage::load,  Stage::prepare,       Stage::light,
                                       Stage::shade, Stage::shade_surface, Stage::shade_image};

/// As records name it.
constexpr const char* to_string(Stage stage) {
  switch (stage) {
    case Stage::load: return "load";
    case Stage::prepare: return "prepare";
    case Stage::light: return "light";
    case Stage::shade: return "shade";
    case Stage::shade_surface: return "shade_surface";
    case Stage::shade_image: break;
  }
  return "shade_image";
}

/// The stage in which a domain is answered.
constexpr Stage shade_stage(Domain domain) { return domain == Domain::image ? Stage::shade_image : Stage::shade_surface; }

}  // namespace gibench
