/// Transport of light by direction: the operators U (transport without visibility), K (reflection) and J (go-through) on
/// tables of elements × directional bins (Dachsbacher, Stamminger, Drettakis, Durand 2007).
#pragma once

#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "common/method/task.h"
#include "methods/antiradiance/bins.h"
#include "methods/antiradiance/fixed_point.h"
#include "methods/antiradiance/glossy.h"
#include "methods/antiradiance/hierarchy.h"
#include "methods/antiradiance/links.h"

namespace gibench::antiradiance {

/// A colour in a vector register.
struct alignas(16) Light4 {
  float v[4] = {0.0F, 0.0F, 0.0F, 0.0F};
};

/// K, at the leaves.
struct Reflection {
  std::span<const Rgb> albedo;               ///< diffuse, of the fronts
  std::span<const float> closure;            ///< what is reflected of the light that the links bring; empty: all
  const GlossyReflection* glossy = nullptr;  ///< further lobes
};

/// Two tables of nodes × bins: exitant radiance less antiradiance, W/(m² sr), by the way it travels, and incident irradiance,
/// W/m², likewise. Of a leaf, bins on its front's side hold what leaves the front, those on the other side what leaves its
/// back: both hemispheres share a row. Vectors are the leaves' rows of such a table, four floats a bin.
class BinTransport {
 public:
  BinTransport(const Hierarchy& hierarchy, const LinkTable& links, const DirectionBins& bins);

  Eigen::Index vector_size() const { return static_cast<Eigen::Index>(hierarchy_.leaf_count() * bins_.count() * 4); }

  /// U of light that comes from no link: radiosities of the leaves' fronts, W/m², and `lobes` on top of them, radiance by bin
  /// (as the vectors are; empty: none).
  void transport_sources(std::span<const Rgb> radiosity, const Vector& lobes, Vector& incident, Task& task);
  /// U (−J): light that met something takes itself away behind it.
  void transport_through(const Vector& arriving, Vector& incident, Task& task);
  /// U (K − J).
  void transport(const Vector& arriving, const Reflection& reflection, Vector& incident, Task& task);
  /// U K alone: the next bounce.
  void transport_reflected(const Vector& arriving, const Reflection& reflection, Vector& incident, Task& task);

  /// Irradiance on the fronts, W/m².
  void irradiance(const Vector& arriving, std::span<Rgb> fronts, Task& task) const;

  std::size_t bytes() const { return (exitant_.capacity() + incident_.capacity()) * sizeof(Light4); }
  /// Of both tables for so many leaves and bins.
  static std::size_t bytes_for(std::size_t leaves, std::size_t bins) { return 4 * leaves * bins * sizeof(Light4); }

 private:
  void local_pass(const Vector& arriving, bool through, const Reflection* reflection, Task& task);
  void pull(Task& task);
  /// Of the link's sender what gather() will read.
  void prefetch_sent(std::size_t link) const;
  void gather(Task& task);
  void push(Task& task);
  void unoccluded(Vector& incident, Task& task);

  Light4* exitant(std::size_t node) { return exitant_.data() + node * bins_.count(); }
  const Light4* exitant(std::size_t node) const { return exitant_.data() + node * bins_.count(); }
  Light4* incident(std::size_t node) { return incident_.data() + node * bins_.count(); }

  const Hierarchy& hierarchy_;
  const LinkTable& links_;
  const DirectionBins& bins_;
  std::vector<Light4> exitant_, incident_;
};

/// Projected solid angles of the bins as a surface with this normal sees them, sr; positive for light that leaves its front,
/// negative for light that arrives there. Either side sums to π.
void projected_bins(const DirectionBins& bins, const Vec3& normal, std::span<float> projected);

/// The masks of all links, by the unit directions in which their light travels.
void make_masks(const Hierarchy& hierarchy, const DirectionBins& bins, std::span<const Vec3> ways, LinkTable& links, Task& task);

}  // namespace gibench::antiradiance
