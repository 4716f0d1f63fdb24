/// Facts about a scene's geometry: counts, closedness, convexity, extent. Defects are not errors: every method
/// accepts them, and they are reported here.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "common/core/vec.h"
#include "common/scene/scene.h"

namespace gibench {

/// The facts of a scene or of one object.
struct GeometryReport {
  std::string name;                                 ///< of the scene or the object
  std::size_t faces = 0, triangles = 0, quads = 0;  ///< triangles and quads as given: faces is their sum
  std::size_t degenerate_faces = 0;                 ///< repeated corners, equal corner positions, or area 0
  std::size_t vertices = 0;
  std::size_t duplicate_vertices = 0;  ///< vertices of an object exactly where another of it is; summed over objects
  std::size_t non_manifold_edges = 0;  ///< of three faces or more
  std::size_t boundary_edges = 0;      ///< of one face
  std::size_t flipped_edges = 0;       ///< between two neighbours of opposite orientation
  std::size_t components = 0;          ///< joined by shared edges
  bool closed = false;                 ///< no boundary edges
  bool oriented = false;               ///< no flipped edges
  /// Closed, in one piece, and the boundary of a convex set: seen as a room or as an object no face hides another.
  bool convex = false;
  Vec3d bounds_min{0.0}, bounds_max{0.0};  ///< metres, file coordinates
  double area = 0.0;                       ///< m², one side of every face
  double volume = 0.0;  ///< m³, of a closed, oriented scene: positive with fronts outward, negative for a room; else 0
};

/// Of the scene as a whole: vertices of different objects at one place are one (see weld_tolerance()), so that a
/// box of six separate quads is closed.
GeometryReport report_geometry(const Scene& scene);

/// The same for each object separately.
std::vector<GeometryReport> report_objects(const Scene& scene);

nlohmann::ordered_json to_json(const GeometryReport& report);
/// All but the name, which is not written. Throws nlohmann::json::exception for what is none.
GeometryReport geometry_report_of(const nlohmann::ordered_json& json);

}  // namespace gibench
