/// The transport between the points of the coarse levels as a sparse operator, kept from the rays of one gather each.
#pragma once

#include <cstdint>
#include <vector>

#include "common/method/task.h"
#include "methods/meshless/coefficients.h"
#include "methods/meshless/gather.h"
#include "methods/meshless/groups.h"

namespace gibench::meshless {

/// T of Lehtinen et al. 2007, section 5.1, between all points of the levels below `levels`: the row of a receiver holds, for
/// every basis function that its rays met, Σ albedo · B_k(hit) / rays. So one gather serves every bounce: the irradiance that a
/// function of these levels brings to a receiver is the product of its row and the function's coefficients.
class TransportRows : public HitKeeper {
 public:
  TransportRows(const Hierarchy& hierarchy, const Groups& groups, std::uint32_t levels, double epsilon_omega, int channels);

  /// Receivers, and senders: the points of these levels, which come first in the hierarchy.
  std::uint32_t size() const { return static_cast<std::uint32_t>(rows_.size()); }

  void announce(std::span<const std::uint32_t>) override {}
  /// Counts in the buffers the hits that no basis function covers.
  void keep(std::uint32_t point, const Gatherer& gatherer, GatherBuffers& buffers) override;

  /// The irradiance that arrives at each point from a function of these levels, W/m². The deviation is that of the
  /// pattern's share of reflecting hits, times the mean irradiance that they see.
  std::vector<Estimate> apply(const Coefficients& sent, Task& task) const;

  std::size_t links() const;  ///< pairs of a receiver and a sender that it sees
  std::size_t bytes() const;

 private:
  struct Row {
    std::vector<std::uint32_t> senders;
    std::vector<float> weights;  ///< channels_ for each sender
    Estimate reflectance;        ///< what arrives where the irradiance is 1 everywhere
  };
  /// One row in the making.
  struct Sums;

  bool add_hit(const SurfaceSample& hit, const Vec3& receiver, const Rgb& share, Sums& sums) const;
  Estimate irradiance(const Row& row, const std::vector<Rgb>& sent) const;

  const Hierarchy& hierarchy_;
  const Groups& groups_;
  std::uint32_t levels_;
  float epsilon_omega_;
  std::uint32_t channels_;
  std::vector<Row> rows_;
};

}  // namespace gibench::meshless
