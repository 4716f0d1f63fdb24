#include "bench/measure/model_limits.h"

namespace gibench {

std::span<const OptionField<ModelLimits>> model_limit_fields() {
  using O = ModelLimits;
  constexpr std::size_t most_seconds = 1'000'000, most_mebibytes = std::size_t{1} << 30U;
  static const OptionField<O> fields[] = {
      {"--model-seconds", "", "Seconds that reading a model file through Assimp (FBX, COLLADA, ...) may take", &O::seconds, 1,
       most_seconds, true},
      {"--model-memory", "", "MiB of memory that it may take", &O::mebibytes, 1, most_mebibytes, true},
  };
  return fields;
}

std::vector<std::string> arguments_of(const ModelLimits& limits) { return arguments_of(model_limit_fields(), limits); }

}  // namespace gibench
