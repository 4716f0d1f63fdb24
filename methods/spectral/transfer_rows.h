/// The transfer function of nodes projected onto the basis (Wang et al. 2007, Eq. 7 and 8), all functions in one pass.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "common/core/lanes.h"
#include "common/reflectance/spherical_harmonics.h"
#include "methods/spectral/basis.h"
#include "methods/spectral/vertex_rays.h"

namespace gibench::spectral {

/// One block of rows after another, by one thread. The basis is linear, so that the rays' weights are first summed at the
/// slots they meet, Σ over hits of weights; those of all rows are then multiplied with the functions there at once. What a call
/// costs follows from the slots that its rays meet, not from how many there are: keep one for many calls.
class TransferRows {
 public:
  TransferRows(const SpectralBasis& basis, const VertexRays& rays);

  /// T^s(v, ℓ) for every column, a row for every node, eight at most: E = Σ_ℓ T^s L^s, W/m².
  void irradiance(std::span<const std::uint32_t> nodes, RayStream& rays, std::span<float> rows);
  void irradiance(std::uint32_t node, RayStream& rays, std::span<float> row) { irradiance({&node, 1}, rays, row); }
  /// The same of one node and T_k^s(v, ℓ) for every harmonic k > 0, a row each behind the first; the slice of the constant
  /// harmonic is that number times the irradiance's.
  void with_harmonics(std::uint32_t node, RayStream& rays, std::span<float> rows);
  /// The same of several nodes: the irradiance, then every harmonic, each with a row for every node.
  std::vector<std::vector<float>> with_harmonics(std::span<const std::uint32_t> nodes, RayStream& rays);

  /// The weights at the slots, in place of their projection: nodal gathering through the same rays.
  void nodal(std::uint32_t node, RayStream& rays, std::span<float> at_slots);

 private:
  void begin(std::size_t rows);
  void touch(std::uint32_t slot) { touched_[slot / 64] |= std::uint64_t{1} << slot % 64; }
  float* at_slots(std::size_t row) { return at_slots_.data() + row * basis_.slots(); }
  void project(std::span<float> rows);
  void take_weights();
  void project_part(const SpectralBasis::Part& part, std::span<float> rows);

  const SpectralBasis& basis_;
  const VertexRays& rays_;
  std::size_t rows_ = 0;                // of a call
  std::vector<float> at_slots_;         // row by row; zero between two calls
  std::vector<std::uint64_t> touched_;  // a bit for every slot, not set between two calls
  std::vector<std::uint32_t> slots_;    // touched ones of one part, ascending
  std::vector<float> weights_;          // of those, slot by slot: of all rows, and zeros up to a multiple of eight
};

/// Makers of rows, of which each works for one thread at a time.
class TransferRowsPool {
 public:
  TransferRowsPool(const SpectralBasis& basis, const VertexRays& rays) : basis_(basis), rays_(rays) {}

  /// Calls work(maker) with one that is not at work.
  template <class Work>
  void use(const Work& work) {
    std::unique_ptr<TransferRows> maker = take();
    work(*maker);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(maker));
  }

 private:
  std::unique_ptr<TransferRows> take();

  const SpectralBasis& basis_;
  const VertexRays& rays_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<TransferRows>> idle_;
};

}  // namespace gibench::spectral
