/// Standing draped figures, made of superquadrics that harmonics deform.
#pragma once

#include <cstdint>

#include "scenes/generators/mesh.h"

namespace gibench::generators {

/// A figure about 1.9 metres tall, standing on y = 0 and facing +z; `seed` changes pose and folds. Closed parts (robe,
/// head, two arms) that reach into one another.
Mesh figure(std::uint64_t seed, int robe_rows = 120, int robe_columns = 120);

}  // namespace gibench::generators
