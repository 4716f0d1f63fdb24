/// The limits under which the model files of strangers are read.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "bench/measure/option_fields.h"

namespace gibench {

/// Of the process that reads a bare model file through Assimp.
struct ModelLimits {
  std::size_t seconds = 60;      ///< wall clock
  std::size_t mebibytes = 4096;  ///< resident memory
};

std::span<const OptionField<ModelLimits>> model_limit_fields();

/// What differs from the defaults, as it is written after `gibench VERB SCENE`, option and value apart.
std::vector<std::string> arguments_of(const ModelLimits& limits);

}  // namespace gibench
