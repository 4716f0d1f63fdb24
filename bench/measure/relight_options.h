/// The options of a relighting: how many frames, where they are asked and compared, as a table.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/measure/option_fields.h"

namespace gibench {

struct RelightOptions {
  std::optional<int> frames;            ///< empty: as the file of moving lights says
  std::size_t surface_samples = 1024;   ///< at which a frame's irradiance is asked
  std::size_t compared_samples = 0;     ///< at which it is compared; 0: all that are asked
  std::uint64_t reference_samples = 0;  ///< paths per value in each replicate that it is compared with; 0: it is not compared
};

std::span<const OptionField<RelightOptions>> relight_fields();

/// What differs from the defaults, as it is written after `gibench relight SCENE`, option and value apart.
std::vector<std::string> arguments_of(const RelightOptions& options);

}  // namespace gibench
