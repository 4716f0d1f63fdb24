/// Transport of light by direction: the operators U (transport without visibility), K (reflection) and J (go-through) on
/// tables of elements × directional bins (Dachsbacher, Stamminger, Drettakis, Durand 2007).
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "common/method/task.h"
#include "methods/antiradiance/bins.h"
#include "methods/antiradiance/fixed_point.h"
#include "methods/antiradiance/glossy.h"
#include "methods/antiradiance/hierarchy.h"
#include "methods/antiradiance/links.h"
#include "methods/antiradiance/scaled_number.h"

namespace gibench::antiradiance {

/// K, at the leaves.
struct Reflection {
  std::span<const Rgb> albedo;               ///< diffuse, of the fronts
  std::span<const float> closure;            ///< what is reflected of the light that the links bring; empty: all
  const GlossyReflection* glossy = nullptr;  ///< further lobes
};

/// A table of nodes × bins: exitant radiance less antiradiance by the way it travels, in numbers of 16 bits: each row
/// has a unit of its own, 1/32767 of the largest of a leaf's row, and of the children's larger one. Of a leaf, bins on its
/// front's side hold what leaves the front, those on the other side what leaves its back: both hemispheres share a row. Vectors
/// are rows of the leaves, by bin and channel: what arrives likewise, W/m².
class BinTransport {
 public:
  BinTransport(const Hierarchy& hierarchy, const LinkTable& links, const DirectionBins& bins);

  Eigen::Index vector_size() const { return static_cast<Eigen::Index>(hierarchy_.leaf_count() * row_); }

  /// U of light that comes from no link: radiosities of the leaves' fronts, W/m², and `lobes` on top of them, radiance by bin
  /// (as the vectors are; empty: none).
  void transport_sources(std::span<const Rgb> radiosity, const Vector& lobes, Vector& incident, Task& task);
  /// U (−J): light that met something takes itself away behind it.
  void transport_through(const Vector& arriving, Vector& incident, Task& task);
  /// U (K − J).
  void transport(const Vector& arriving, const Reflection& reflection, Vector& incident, Task& task);
  /// U K alone: the next bounce.
  void transport_reflected(const Vector& arriving, const Reflection& reflection, Vector& incident, Task& task);

  /// Of every leaf how many surfaces stand one behind another where its front looks, in the mean over its hemisphere: what the
  /// links bring of radiance one from everything, over one.
  std::vector<float> depths(Task& task);

  /// Irradiance on the fronts, W/m².
  void irradiance(const Vector& arriving, std::span<Rgb> fronts, Task& task) const;

  std::size_t bytes() const { return exitant_.capacity() * sizeof(ScaledNumber) + units_.capacity() * sizeof(float); }
  /// Of the table for so many leaves and bins.
  static std::size_t bytes_for(std::size_t leaves, std::size_t bins) {
    return 2 * leaves * (bins * channels * sizeof(ScaledNumber) + sizeof(float));
  }

 private:
  void local_pass(const Vector& arriving, bool through, const Reflection* reflection, Task& task);
  /// The row of a leaf.
  void send(std::uint32_t node, std::span<const float> radiance);
  void pull(Task& task);
  /// Of the link's sender what gather() will read.
  void prefetch_sent(std::size_t link) const;
  /// Adds what the links of a node bring.
  void gather(std::uint32_t node, float* arriving) const;
  /// What of a bin a surface shows, by the cosine that its light has at least.
  float cosine(const Node& node, std::size_t bin) const {
    return std::max(std::fabs(glm::dot(node.normal, bins_.direction(bin))), bins_.least_cosine());
  }
  /// What arrives at a node as it arrives at its child: of the same radiance, on the area that the child shows to each bin.
  void pass_down(const Node& node, const Node& child, const float* arriving, float* at_child) const;
  /// Everything below a node whose row holds what its ancestors and itself were brought, into the leaves' rows of `incident`.
  void gather_below(std::uint32_t node, std::vector<float>& rows, std::size_t depth, Vector& incident) const;
  void unoccluded(Vector& incident, Task& task);

  ScaledNumber* exitant(std::size_t node) { return exitant_.data() + node * row_; }
  const ScaledNumber* exitant(std::size_t node) const { return exitant_.data() + node * row_; }

  const Hierarchy& hierarchy_;
  const LinkTable& links_;
  const DirectionBins& bins_;
  std::size_t row_;           ///< numbers of a node
  std::vector<float> units_;  ///< of the nodes' rows
  std::vector<ScaledNumber> exitant_;
};

/// Projected solid angles of the bins as a surface with this normal sees them, sr; positive for light that leaves its front,
/// negative for light that arrives there. Either side sums to π.
void projected_bins(const DirectionBins& bins, const Vec3& normal, std::span<float> projected);

/// The masks of all links, by the unit directions in which their light travels.
void make_masks(const Hierarchy& hierarchy, const DirectionBins& bins, std::span<const Vec3> ways, LinkTable& links, Task& task);

}  // namespace gibench::antiradiance
