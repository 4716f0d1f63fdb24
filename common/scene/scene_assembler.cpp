#include "common/scene/scene_assembler.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "common/core/error.h"
#include "common/core/names.h"
#include "common/scene/tessellate.h"

namespace gibench {

namespace {

// Squared lengths must fit into a float.
constexpr double largest_extent = 1e18;  // metres

constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

bool is_finite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

void ObjectGeometry::append(const ObjectGeometry& other) {
  const auto offset = static_cast<std::uint32_t>(vertices.size());
  vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
  for (Face face : other.faces) {
    for (std::uint32_t& corner : face.corners) corner += offset;
    faces.push_back(face);
  }
}

void SceneAssembler::add_object(Object object, ObjectGeometry geometry, const std::string& place) {
  if (vertices_.size() + geometry.vertices.size() >= unused)
    throw InputError(place, "the scene has more than 4 294 967 294 vertices", "leave out objects");
  object.vertex_begin = static_cast<std::uint32_t>(vertices_.size());
  object.face_begin = static_cast<std::uint32_t>(scene_.faces.size());
  std::vector<std::uint32_t> new_index(geometry.vertices.size(), unused);
  for (Face face : geometry.faces) {
    for (std::uint32_t& corner : face.corners) {
      const std::uint32_t old = corner;
      if (new_index[old] == unused) {
        if (!is_finite(geometry.vertices[old]))
          throw InputError(place, "vertex " + std::to_string(old) + " of object " + in_quotes(object.name) + " is not finite",
                           "correct its coordinates");
        new_index[old] = static_cast<std::uint32_t>(vertices_.size());
        vertices_.push_back(geometry.vertices[old]);
      }
      corner = new_index[old];
    }
    scene_.faces.push_back(face);
  }
  object.vertex_end = static_cast<std::uint32_t>(vertices_.size());
  object.face_end = static_cast<std::uint32_t>(scene_.faces.size());
  scene_.objects.push_back(std::move(object));
}

void SceneAssembler::finish_geometry(const std::string& place) {
  if (scene_.faces.empty()) throw InputError(place, "the scene is empty: it has no faces", "give at least one object a face");
  Vec3d low = vertices_.front(), high = vertices_.front();
  for (const Vec3d& v : vertices_) low = glm::min(low, v), high = glm::max(high, v);
  scene_.origin = low + 0.5 * (high - low);
  scene_.vertices.reserve(vertices_.size());
  for (const Vec3d& v : vertices_) scene_.vertices.push_back(to_local(v));
  if (!(glm::length(high - low) < largest_extent))
    throw InputError(place, "the scene is larger than 1e18 m, too large for single precision", "scale it down");
  tessellate(scene_);
}

void SceneAssembler::place_camera(Camera& camera, const Vec3d& position, const Vec3d& look_at, const std::string& place) const {
  const Vec3d local = position - scene_.origin, view = look_at - position;
  const double longest = std::max({std::abs(view.x), std::abs(view.y), std::abs(view.z)});
  const Vec3d scaled = view / longest;  // squares of the smallest lengths would be 0
  const double away = glm::length(local), distance = glm::length(scaled) * longest;
  if (!(away < largest_extent) || !(distance < largest_extent))
    throw InputError(place, "the camera or its view reaches farther than 1e18 m from the scene, too far for single precision",
                     "move the camera to the scene, and look_at near it");
  // A distance under this share of the coordinates would turn the view by more than 6e-5.
  constexpr double least_share = 1e-3, least_distance = 1e-12;  // metres; its square must be a float
  const bool too_near = distance < std::max(least_share * away, least_distance);
  const Vec3d ahead = too_near ? glm::normalize(scaled) * std::max(away, 1.0) : view;
  camera.position = Vec3(local);
  camera.look_at = Vec3(local + ahead);
}

}  // namespace gibench
