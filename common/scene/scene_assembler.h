/// The assembly of a scene's geometry in double precision, and its recentring.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace gibench {

/// Vertices (metres, file coordinates) and faces that index into them.
struct ObjectGeometry {
  std::vector<Vec3d> vertices;
  std::vector<Face> faces;

  /// Adds other geometry behind this.
  void append(const ObjectGeometry& other);
};

/// Used once for each scene: objects first, then finish_geometry(), then everything that needs to_local().
class SceneAssembler {
 public:
  explicit SceneAssembler(Scene& scene) : scene_(scene) {}

  Scene& scene() { return scene_; }
  const Scene& scene() const { return scene_; }

  /// Adds an object; its name, material, two_sided and group are set, its ranges are filled here. Vertices that no
  /// face uses are left out. Throws InputError at `place` for a vertex that is not finite.
  void add_object(Object object, ObjectGeometry geometry, const std::string& place);

  /// Takes the centre of the bounding box off every vertex, rounds to float and tessellates. Throws InputError at
  /// `place` for a scene without faces, or one too large for single precision.
  void finish_geometry(const std::string& place);

  /// A point of the file in the scene's coordinates; after finish_geometry().
  Vec3 to_local(const Vec3d& point) const { return Vec3(point - scene_.origin); }

  /// Sets position and look_at of a camera, both in file coordinates and apart; after finish_geometry(). Where single precision
  /// would turn the view, because look_at is near and the scene's centre far, look_at moves away along the view. Throws
  /// InputError at `place` for a camera too far from the scene.
  void place_camera(Camera& camera, const Vec3d& position, const Vec3d& look_at, const std::string& place) const;

 private:
  Scene& scene_;
  std::vector<Vec3d> vertices_;
};

}  // namespace gibench
