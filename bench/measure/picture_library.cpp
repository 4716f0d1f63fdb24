#include "bench/measure/picture_library.h"

#include <algorithm>

#include "bench/record/machine.h"
#include "common/image/image_plugin.h"

namespace gibench {

PictureLibrary::PictureLibrary() : peak_before_(peak_bytes()) {
  const std::uint64_t before = resident_bytes();
  image_plugin();
  taken_ = std::max(resident_bytes(), before) - before;
}

std::uint64_t PictureLibrary::peak_bytes_without() const {
  const std::uint64_t peak = peak_bytes();
  return std::max(peak_before_, peak - std::min(peak, taken_));
}

}  // namespace gibench
