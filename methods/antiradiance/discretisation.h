/// Everything that the geometry alone decides: mesh, elements, hierarchy, links, and the sums that form factors are held to.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/method/task.h"
#include "methods/antiradiance/bins.h"
#include "methods/antiradiance/elements.h"
#include "methods/antiradiance/hierarchy.h"
#include "methods/antiradiance/links.h"
#include "methods/antiradiance/reconstruction.h"
#include "methods/antiradiance/settings.h"
#include "methods/antiradiance/visibility.h"

namespace gibench::antiradiance {

/// How light gets past surfaces in the way.
enum class Visibility {
  none_needed,   ///< one convex room: everything sees everything
  traced,        ///< by rays, link by link
  nearest,       ///< of a bin's links the nearest
  antiradiance,  ///< by negative light
  shadow_passes  ///< by negative light without directions
};

/// A mesh, and the settings that say what becomes of it: how many elements, and whether its vertices share them.
struct DecidedMesh {
  Settings settings;
  SamplingMesh mesh;
};

struct Discretisation {
  Discretisation(const World& world, const Settings& settings, Task& task);
  Discretisation(const World& world, DecidedMesh made, Task& task);

  SamplingMesh mesh;
  Elements elements;
  std::vector<std::uint8_t> parted_triangles;  ///< of parted_triangles(); empty: not looked for
  Surroundings surroundings;
  Hierarchy hierarchy;
  Reconstruction reconstruction;
  bool is_parted(std::uint32_t triangle) const { return !parted_triangles.empty() && parted_triangles[triangle] != 0; }
  std::size_t bytes() const {
    return mesh.bytes() + elements.bytes() + parted_triangles.capacity() + hierarchy.bytes() + reconstruction.bytes();
  }
};

/// Counted in the task. The report names what the elements cannot be trusted with. Before any ray is traced the memory of
/// elements and of `table_bytes` more for each is held against the budget; nothing comes back where it does not suffice.
std::unique_ptr<Discretisation> make_elements(const World& world, const Settings& settings, double table_bytes, Task& task,
                                              StageReport& report);

/// Bytes an element takes in the tables of light by direction, and in the solvers.
double direction_table_bytes(const Settings& settings);

/// The links of one way of dealing with visibility, and what goes with them.
struct Linking {
  Visibility visibility = Visibility::none_needed;
  std::optional<DirectionBins> bins;  ///< only where light is kept by direction
  LinkTable links;
  float tolerance = 0.0F;  ///< that the links were made at
  std::string warning;     ///< where it had to be coarser than asked for, or links had to stay whole
  bool refused = false;    ///< no oracle keeps within the budget; `warning` says why
  std::size_t bytes() const { return links.bytes(); }
};

/// `radiosity` of the nodes, for the oracle that looks at it; empty: geometry alone.
Linking make_linking(const World& world, const Discretisation& parts, const Settings& settings, Visibility visibility,
                     std::span<const float> radiosity, Task& task);

}  // namespace gibench::antiradiance
