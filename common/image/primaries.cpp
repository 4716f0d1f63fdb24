#include "common/image/primaries.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "common/core/vec.h"

namespace gibench {

namespace {

constexpr float digits = 1e-4F;

/// CIE XYZ in the unit in which X + Y + Z = 1.
Vec3d unscaled_xyz(const Chromaticities& c, std::size_t which) {
  const double x = static_cast<double>(c[2 * which]), y = static_cast<double>(c[2 * which + 1]);
  return {x, y, 1.0 - x - y};
}

/// XYZ of white, Y = 1.
Vec3d white_xyz(const Chromaticities& c) { return unscaled_xyz(c, 3) / unscaled_xyz(c, 3).y; }

/// Columns are the XYZ of red, green and blue: together they are white.
glm::dmat3 rgb_to_xyz(const Chromaticities& c) {
  const glm::dmat3 primaries(unscaled_xyz(c, 0), unscaled_xyz(c, 1), unscaled_xyz(c, 2));
  const Vec3d amounts = glm::inverse(primaries) * white_xyz(c);
  return {amounts.x * primaries[0], amounts.y * primaries[1], amounts.z * primaries[2]};
}

/// Bradford's cone responses of XYZ.
const glm::dmat3& cone_responses() {
  static const glm::dmat3 rows(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296);
  static const glm::dmat3 matrix = glm::transpose(rows);
  return matrix;
}

/// XYZ under one white to that under another.
glm::dmat3 adaptation(const Vec3d& from_white, const Vec3d& to_white) {
  const Vec3d ratio = (cone_responses() * to_white) / (cone_responses() * from_white);
  glm::dmat3 scale(1.0);
  for (int i = 0; i < 3; ++i) scale[i][i] = ratio[i];
  return glm::inverse(cone_responses()) * scale * cone_responses();
}

RgbDouble colour_of(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// Written for values that may be NaN.
bool is_moderate(const glm::dmat3& matrix) {
  constexpr double most = 1e3;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      if (!(std::abs(matrix[column][row]) < most)) return false;
  return true;
}

}  // namespace

std::optional<ColourConversion> ColourConversion::to_rec709(const Chromaticities& from) {
  const glm::dmat3 matrix = glm::inverse(rgb_to_xyz(rec709_chromaticities)) *
                            adaptation(white_xyz(from), white_xyz(rec709_chromaticities)) * rgb_to_xyz(from);
  if (!is_moderate(matrix)) return std::nullopt;
  return ColourConversion(colour_of(matrix[0]), colour_of(matrix[1]), colour_of(matrix[2]));
}

bool are_rec709(const Chromaticities& chromaticities) {
  return std::ranges::equal(chromaticities, rec709_chromaticities, [](float a, float b) { return std::abs(a - b) <= digits; });
}

}  // namespace gibench
