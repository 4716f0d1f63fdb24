/// The colours of a surface's vertices as one colour.
#pragma once

#include "common/core/rgb.h"
#include "common/core/vec.h"

namespace gibench {

/// The mean of colours that are linear between the corners of triangles, over their area; where no triangle has an area,
/// over the corners.
class VertexColours {
 public:
  /// Of a triangle.
  struct Corner {
    Vec3d position;
    Vec3 colour;
  };
  void add(const Corner& a, const Corner& b, const Corner& c);

  /// After at least one triangle.
  Rgb mean() const;

 private:
  Vec3d by_area_{0.0}, by_corner_{0.0};
  double area_ = 0.0, triangles_ = 0.0;
};

}  // namespace gibench
