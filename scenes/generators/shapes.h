/// Turned, bent, stuffed and hanging shapes: what furniture is made of. Metres, y up, faces looking outwards.
#pragma once

#include <functional>
#include <vector>

#include "common/core/random.h"
#include "scenes/generators/mesh.h"

namespace gibench::generators {

/// Turned about x, then y, then z (degrees), then moved: the order of the scene file.
Mesh placed(Mesh mesh, const Vec3d& translate, const Vec3d& rotate_degrees = Vec3d(0.0));

/// A point of a turned profile.
struct ProfilePoint {
  double radius, y;  ///< metres
};

/// A solid of revolution about the y axis. The profile runs from the lower end of the axis round the outside to the upper
/// end; a vessel's turns at the rim and comes back inside. The first and the last radius are taken as 0.
Mesh lathe(const std::vector<ProfilePoint>& profile, int columns);

/// A round bar along a polyline of two points at least, closed by flat ends. `radius(t)` in metres for t in [0, 1] along
/// the points.
Mesh pipe(const std::vector<Vec3d>& points, int columns, const std::function<double(double t)>& radius);
Mesh pipe(const std::vector<Vec3d>& points, int columns, double radius);

/// A superellipsoid about the origin: exponent 1 an ellipsoid, towards 0 a box with rounded edges.
Mesh cushion(const Vec3d& half_size, double exponent, int rows, int columns);

/// An open grid of rows × columns quads over u, v in [0, 1]; its front is on the side of du × dv.
Mesh sheet(int rows, int columns, const std::function<Vec3d(double u, double v)>& point);

/// Uniform in [low, high).
double between(RandomStream& random, double low, double high);

}  // namespace gibench::generators
