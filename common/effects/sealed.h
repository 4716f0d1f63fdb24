/// The test whether a scene is closed against everything outside.
#pragma once

#include "common/ray/world.h"

namespace gibench {

/// Whether no lit side sees anything outside the scene: every one looks into a closed room whose fronts face inwards. Proven
/// or false; false for more than 2048 triangles.
bool is_sealed(const World& world);

}  // namespace gibench
