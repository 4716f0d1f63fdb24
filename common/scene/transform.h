/// The transform of an object in a scene file: scale, rotate about x, then y, then z, translate.
#pragma once

#include <glm/mat3x3.hpp>

#include "common/scene/scene_assembler.h"

namespace gibench {

/// p → linear p + translation, in double precision.
struct Transform {
  glm::dmat3 linear{1.0};
  Vec3d translation{0.0};

  Vec3d apply(const Vec3d& point) const { return linear * point + translation; }
  bool mirrors() const;
};

/// Rz Ry Rx S, then the translation; exact for multiples of 90°.
Transform make_transform(const Vec3d& scale, const Vec3d& rotate_degrees, const Vec3d& translate);

/// Moves the vertices; a mirroring transform also turns every face round, so that fronts stay fronts.
void transform_geometry(const Transform& transform, ObjectGeometry& geometry);

}  // namespace gibench
