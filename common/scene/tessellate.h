/// The triangles of a scene, from its faces.
#pragma once

#include "common/scene/scene.h"

namespace gibench {

/// Fills the tessellation arrays and the objects' triangle ranges from faces and objects.
void tessellate(Scene& scene);

}  // namespace gibench
