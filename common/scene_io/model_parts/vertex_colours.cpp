#include "common/scene_io/model_parts/vertex_colours.h"

#include <cmath>

namespace gibench {

void VertexColours::add(const Corner& a, const Corner& b, const Corner& c) {
  const Vec3d colour = (Vec3d(a.colour) + Vec3d(b.colour) + Vec3d(c.colour)) / 3.0;
  const double twice_area = glm::length(glm::cross(b.position - a.position, c.position - a.position));
  by_corner_ += colour, triangles_ += 1.0;
  if (std::isfinite(twice_area)) by_area_ += twice_area * colour, area_ += twice_area;
}

Rgb VertexColours::mean() const {
  const Vec3d mean = area_ > 0.0 ? by_area_ / area_ : by_corner_ / triangles_;
  return {static_cast<float>(mean.x), static_cast<float>(mean.y), static_cast<float>(mean.z)};
}

}  // namespace gibench
