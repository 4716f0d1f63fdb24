#include "common/scene_io/pictures/picture_use.h"

#include <algorithm>
#include <cmath>

#include "common/core/error.h"
#include "common/core/sampling.h"

namespace gibench {

namespace {

/// In columns and rows of the picture, y downwards.
struct Place {
  double x = 0.0, y = 0.0;
};
using Triangle = std::array<Place, 3>;

// Borders of texels that a triangle's edges may cross, and points that stand for a triangle that crosses more.
constexpr double most_crossings = 16384.0, least_crossings = 64.0;
constexpr int most_points = 4096, least_points = 16;
// Of all triangles together: a second or two.
constexpr double most_crossings_of_all = 6.7e7;
// In texels: where a triangle covers less, the rounding of its sums shows.
constexpr double smallest_area = 1e-4;

double signed_area(const Triangle& t) {
  return 0.5 * ((t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y));
}

/// Borders of texels that the edges cross, and one for each edge.
double crossings(const Triangle& t) {
  double sum = 3.0;
  for (std::size_t i = 0; i < 3; ++i) sum += std::abs(t[(i + 1) % 3].x - t[i].x) + std::abs(t[(i + 1) % 3].y - t[i].y);
  return sum;
}

/// ∫ F dy along an edge, F the integral of the texels from the left border (Green's theorem: the sum over the edges of a
/// triangle is its integral of the texels). F is linear between borders of texels, so the middle of each piece gives it.
class EdgeIntegral {
 public:
  EdgeIntegral(const TexelSums& sums, PictureWrap wrap, const Place& from, const Place& to)
      : sums_(sums), wrap_(wrap), from_(from), to_(to) {}

  WeighedTexels value() {
    if (from_.y == to_.y) return {};
    // From above to below: the pieces are then those of the neighbour that shares the edge, and cancel to the last bit.
    const bool is_upwards = from_.y > to_.y;
    if (is_upwards) std::swap(from_, to_);
    for (double row = std::floor(from_.y); row < to_.y; ++row) add_row(row);
    return is_upwards ? -1.0 * sum_ : sum_;
  }

 private:
  double x_at(double y) const {
    if (y <= from_.y) return from_.x;
    if (y >= to_.y) return to_.x;
    return from_.x + (to_.x - from_.x) * ((y - from_.y) / (to_.y - from_.y));
  }

  void add_row(double row) {
    const double top = std::max(row, from_.y), bottom = std::min(row + 1.0, to_.y);
    const double first = x_at(top), last = x_at(bottom);
    const double left = std::min(first, last), right = std::max(first, last);
    const double height_of_a_column = right > left ? (bottom - top) / (right - left) : 0.0;
    if (height_of_a_column == 0.0 || std::floor(left) == std::floor(right)) {
      add_piece(0.5 * (left + right), row, bottom - top);
      return;
    }
    for (double column = std::floor(left); column < right; ++column) {
      const double begin = std::max(column, left), end = std::min(column + 1.0, right);
      add_piece(0.5 * (begin + end), row, height_of_a_column * (end - begin));
    }
  }

  void add_piece(double x, double row, double height) { sum_ += height * sums_.up_to(x, static_cast<std::int64_t>(row), wrap_); }

  const TexelSums& sums_;
  PictureWrap wrap_;
  Place from_, to_;
  WeighedTexels sum_;
};

/// Adds up triangles, and bounds what they cost.
class UseOfPicture {
 public:
  UseOfPicture(const TexelSums& picture, PictureWrap wrap, std::size_t triangles)
      : sums_(picture),
        wrap_(wrap),
        budget_(std::clamp(most_crossings_of_all / static_cast<double>(std::max<std::size_t>(1, triangles)), least_crossings,
                           most_crossings)) {}

  /// The mean over one triangle.
  WeighedTexels mean(const UvTriangle& uv) {
    const Triangle triangle = placed(uv);
    const double area = signed_area(triangle), borders = crossings(triangle);
    if (borders > budget_ || std::abs(area) < smallest_area) return mean_of_points(triangle, borders);
    WeighedTexels sum;
    for (std::size_t i = 0; i < 3; ++i) sum += EdgeIntegral(sums_, wrap_, triangle[i], triangle[(i + 1) % 3]).value();
    return (1.0 / area) * sum;
  }

 private:
  /// Near the picture itself, by whole periods: large numbers would cost digits.
  static double shift(float a, float b, float c, Wrap wrap) {
    const double least = std::min({a, b, c});
    switch (wrap) {
      case Wrap::repeat: return std::floor(least);
      case Wrap::clamp: return 0.0;
      case Wrap::mirror: return 2.0 * std::floor(0.5 * least);
    }
    return 0.0;
  }

  Triangle placed(const UvTriangle& uv) const {
    const double u = shift(uv[0].x, uv[1].x, uv[2].x, wrap_.u), v = shift(uv[0].y, uv[1].y, uv[2].y, wrap_.v);
    Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i)
      triangle[i] = {(static_cast<double>(uv[i].x) - u) * sums_.width(),
                     (1.0 - (static_cast<double>(uv[i].y) - v)) * sums_.height()};
    return triangle;
  }

  /// Points of the sequence of Roberts (2018, "The unreasonable effectiveness of quasirandom sequences"): its steps are
  /// irrational, so that no repetition of the picture falls in with them. It goes on from one triangle to the next.
  WeighedTexels mean_of_points(const Triangle& t, double borders) {
    constexpr double step_u = 0.7548776662466927, step_v = 0.5698402909980532;
    const int count = std::clamp(static_cast<int>(std::min(borders, budget_ / 4.0)), least_points, most_points);
    WeighedTexels sum;
    for (int i = 0; i < count; ++i) {
      const auto index = static_cast<double>(++points_);
      const double u = index * step_u - std::floor(index * step_u), v = index * step_v - std::floor(index * step_v);
      const Vec2 barycentric = uniform_triangle({static_cast<float>(u), static_cast<float>(v)});
      const double b = static_cast<double>(barycentric.x), c = static_cast<double>(barycentric.y);
      sum += sums_.at(t[0].x + b * (t[1].x - t[0].x) + c * (t[2].x - t[0].x),
                      t[0].y + b * (t[1].y - t[0].y) + c * (t[2].y - t[0].y), wrap_);
    }
    return (1.0 / count) * sum;
  }

  const TexelSums& sums_;
  PictureWrap wrap_;
  double budget_;
  std::uint64_t points_ = 0;
};

bool counts(const UvTriangle& triangle, double area) {
  return area > 0.0 && std::isfinite(area) && std::all_of(triangle.begin(), triangle.end(), [](const Vec2& corner) {
           return std::isfinite(corner.x) && std::isfinite(corner.y);
         });
}

/// `sum` over a surface of `area`. No mean is outside the range of its texels: what is, is rounding.
PictureMean mean_of(const WeighedTexels& sum, double area, const TexelSums& picture) {
  PictureMean mean;
  mean.opacity = std::clamp(sum.opacity / area, 0.0, 1.0);
  if (!(sum.opacity > 0.0)) return mean;
  const Rgb colour(sum.colour / sum.opacity);
  for (int c = 0; c < 3; ++c) mean.colour[c] = std::clamp(colour[c], picture.low()[c], picture.high()[c]);
  return mean;
}

}  // namespace

PictureMean mean_over_triangles(const TexelSums& picture, std::span<const UvTriangle> triangles, std::span<const double> areas,
                                PictureWrap wrap) {
  GIBENCH_CHECK(triangles.size() == areas.size(), "one area for each triangle");
  UseOfPicture use(picture, wrap, triangles.size());
  WeighedTexels sum;
  double area = 0.0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (!counts(triangles[i], areas[i])) continue;
    sum += areas[i] * use.mean(triangles[i]);
    area += areas[i];
  }
  return area > 0.0 ? mean_of(sum, area, picture) : mean_of_picture(picture);
}

PictureMean mean_of_picture(const TexelSums& picture) {
  return mean_of(picture.whole(), static_cast<double>(picture.picture().texels.size()), picture);
}

}  // namespace gibench
