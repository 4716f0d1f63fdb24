#include "common/scene_io/assimp/single_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gibench {

namespace {

double mean_edge(const ObjectGeometry& geometry) {
  double sum = 0.0;
  for (const Face& face : geometry.faces)
    for (std::size_t i = 0; i < 3; ++i)
      sum += glm::length(geometry.vertices[face.corners[i]] - geometry.vertices[face.corners[(i + 1) % 3]]);
  return geometry.faces.empty() ? 0.0 : sum / (3.0 * static_cast<double>(geometry.faces.size()));
}

}  // namespace

void LostPrecision::add(const ObjectGeometry& mesh) {
  double farthest = 0.0;
  for (const Vec3d& v : mesh.vertices) farthest = std::max({farthest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  const double share = 0x1p-23 * farthest / mean_edge(mesh);
  if (std::isfinite(share)) worst_ = std::max(worst_, share);
}

void LostPrecision::warn(const std::string& file, std::vector<std::string>& warnings) const {
  constexpr double tolerated = 1e-3;
  if (worst_ > tolerated)
    warnings.push_back(
        fmt::format("{}: positions are kept in single precision, whose steps so far from the origin are {:.2g} of the "
                    "mean edge; move the model near its origin and use translate",
                    file, worst_));
}

}  // namespace gibench
