/// The mean of a picture over the surfaces that wear it.
#pragma once

#include <array>
#include <span>

#include "common/core/vec.h"
#include "common/scene_io/pictures/texel_sums.h"

namespace gibench {

/// A surface with a picture, as one colour.
struct PictureMean {
  Rgb colour;            ///< linear, each texel weighed by its opacity; black where all are transparent
  double opacity = 1.0;  ///< mean alpha; below 1 the surface has holes or is translucent
};

/// Three corners in the picture: u to the right, v upwards, the picture is [0, 1]² (glTF counts v downwards: give 1 − v).
using UvTriangle = std::array<Vec2, 3>;

/// Mean over triangles, each with the weight of its area on the surface; both spans have one entry for each triangle.
/// Exact for texels of constant colour, but for triangles that cover so much of a carried-on picture, or so little in one
/// direction, that points stand for them (a fixed sequence; 16 to 4096, fewer the more triangles there are). A triangle
/// with a coordinate that is not finite counts for nothing; where nothing counts, the mean of the whole picture is given.
PictureMean mean_over_triangles(const TexelSums& picture, std::span<const UvTriangle> triangles, std::span<const double> areas,
                                PictureWrap wrap = {});

/// Mean over all texels: of surfaces without coordinates.
PictureMean mean_of_picture(const TexelSums& picture);

}  // namespace gibench
