/// The header of a Radiance picture (.hdr).
#pragma once

#include <optional>
#include <string_view>

#include "common/image/primaries.h"

namespace gibench {

/// What a header says of the pixels (Radiance, "The RADIANCE Picture File Format").
struct HdrHeader {
  double width = 0.0, height = 0.0;         ///< 0 where they cannot be read
  double exposure = 1.0;                    ///< what all pixels were multiplied by
  std::optional<Chromaticities> primaries;  ///< empty where it says nothing
};

HdrHeader read_hdr_header(std::string_view bytes);

}  // namespace gibench
