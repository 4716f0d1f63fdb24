/// The spectral mesh basis: eigenvectors of the Laplacian of every submesh (Wang et al. 2007, section 3.1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/method/task.h"
#include "methods/spectral/partition.h"
#include "methods/spectral/rgb4.h"

namespace gibench::spectral {

/// Values at vertices are kept in slots: the mesh's vertices in the order of the partition.
class SpectralBasis {
 public:
  /// A part's slots and its columns, one for every function.
  struct Part {
    std::uint32_t begin = 0, end = 0;  ///< slots
    std::uint32_t column = 0;          ///< the first
    std::uint32_t functions = 0;
    std::uint32_t width = 0;  ///< floats a slot: the functions, and zeros up to a multiple of eight where there are several
    std::size_t values = 0;   ///< offset of the first slot's row
  };

  /// Room for so many functions of each part, all of them zero as yet.
  SpectralBasis(const Partition& partition, std::span<const std::uint32_t> functions);
  SpectralBasis() = default;

  /// Columns of all parts with so many functions each.
  static std::uint64_t columns_for(std::span<const std::uint32_t> functions);
  /// The functions at a slot, to be written, and the slot's weight.
  std::span<float> row_to_fill(const Part& part, std::uint32_t slot) {
    return std::span(values_).subspan(row_begin(part, slot), part.width);
  }
  void set_weight(std::uint32_t slot, float weight) { weight_[slot] = weight; }

  std::uint32_t slots() const { return static_cast<std::uint32_t>(weight_.size()); }
  std::uint32_t columns() const { return parts_.empty() ? 0 : parts_.back().column + parts_.back().functions; }
  const std::vector<Part>& parts() const { return parts_; }
  const Part& part_of(std::uint32_t slot) const { return parts_[part_of_slot_[slot]]; }
  /// s_ℓ at a slot, for the columns of its part, and zeros up to its width.
  std::span<const float> row(const Part& part, std::uint32_t slot) const {
    return std::span(values_).subspan(row_begin(part, slot), part.width);
  }
  /// wᵢ of the inner product ⟨f, g⟩ = Σ wᵢ fᵢ gᵢ in which the functions are orthonormal.
  std::span<const float> weight() const { return weight_; }

  /// ⟨f, s_ℓ⟩ for every column; `values` one per slot, `coefficients` one per column.
  void project(std::span<const Rgb4> values, std::span<Rgb4> coefficients, Task& task) const;
  /// The same of the light that surfaces reflect, `reflectance` (direct + indirect), one per slot, without that ever being
  /// stored.
  void project_reflected(std::span<const Rgb4> reflectance, std::span<const Rgb4> direct, std::span<const Rgb4> indirect,
                         std::span<Rgb4> coefficients, Task& task) const;
  /// Σ_ℓ c_ℓ s_ℓ at every slot.
  void reconstruct(std::span<const Rgb4> coefficients, std::span<Rgb4> values, Task& task) const;

  /// The function 1, projected: not zero for the first function of every part alone.
  std::vector<float> constant() const;

  std::size_t bytes() const { return (values_.size() + weight_.size()) * sizeof(float); }

 private:
  static std::size_t row_begin(const Part& part, std::uint32_t slot) {
    return part.values + std::size_t{slot - part.begin} * part.width;
  }

  std::vector<Part> parts_;
  std::vector<std::uint16_t> part_of_slot_;
  std::vector<float> values_, weight_;
};

}  // namespace gibench::spectral
