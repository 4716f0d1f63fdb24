/// The projected BRDFs, each made once: materials switch between them at run time.
#pragma once

#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "common/reflectance/lobe_harmonics.h"

namespace gibench::spectral {

/// Whether a material reflects otherwise than diffusely.
bool has_lobe(const Material& material);

class LobeStore {
 public:
  /// The lobe of a material; the same for all that differ in name, diffuse part and emission only. Empty where it has none.
  std::shared_ptr<const LobeHarmonics> lobe_of(const Material& material);

 private:
  using Key = std::tuple<int, std::tuple<float, float, float>, float, float, std::tuple<float, float, float>,
                         std::tuple<float, float, float>>;
  std::map<Key, std::shared_ptr<const LobeHarmonics>> lobes_;
};

}  // namespace gibench::spectral
