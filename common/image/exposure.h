/// Exposure values (stops) at which pictures are shown and FLIP is taken.
#pragma once

namespace gibench {

/// The exposure of a scene, in stops.
struct Exposure {
  float value = 0.0F;                ///< LDR pictures: radiance times 2^value
  float start = -2.0F, stop = 4.0F;  ///< HDR-FLIP range
};

}  // namespace gibench
