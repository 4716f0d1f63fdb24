/// The scenes made in memory (common/scene/made_scenes.h), under the tests' names.
#pragma once

#include "common/scene/made_scenes.h"

namespace gibench::test {

using made::box_scene;
using made::BoxOptions;
using made::random_triangles;
using made::SceneBuilder;
using made::transformed;

}  // namespace gibench::test
