/// Pictures in memory.
#pragma once

#include <vector>

#include "common/core/rgb.h"

namespace gibench {

/// Row-major from the top, linear values.
struct Image {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;
};

}  // namespace gibench
