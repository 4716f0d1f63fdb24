/// The scenes that are measured in, made in code.
#pragma once

#include "common/scene/scene.h"

namespace gibench::micro {

/// A closed white room [0,1]³ with a lamp and twelve bumpy spheres: 307 214 triangles, most rays short and incoherent.
Scene bumpy_spheres();

}  // namespace gibench::micro
