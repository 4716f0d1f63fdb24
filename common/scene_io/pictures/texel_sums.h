/// Sums of texels along the rows of a picture that is carried on beyond its borders.
#pragma once

#include <cstdint>
#include <vector>

#include "common/scene_io/pictures/picture_texels.h"

namespace gibench {

/// The picture beyond its borders.
enum class Wrap { repeat, clamp, mirror };

/// That of each direction.
struct PictureWrap {
  Wrap u = Wrap::repeat, v = Wrap::repeat;
};

/// An integral over texels: of colour times opacity, and of opacity.
struct WeighedTexels {
  RgbDouble colour;
  double opacity = 0.0;

  WeighedTexels& operator+=(const WeighedTexels& o) {
    colour += o.colour, opacity += o.opacity;
    return *this;
  }
  friend WeighedTexels operator+(WeighedTexels a, const WeighedTexels& b) { return a += b; }
  friend WeighedTexels operator*(double s, const WeighedTexels& a) { return {s * a.colour, s * a.opacity}; }
};

/// A picture and its sums, made once for all that wear it. Sums up to every sixteenth column only, which keeps them a fraction of
/// the picture.
class TexelSums {
 public:
  /// `picture` has texels.
  explicit TexelSums(PictureTexels picture);

  int width() const { return picture_.width; }
  int height() const { return picture_.height; }
  const PictureTexels& picture() const { return picture_; }

  /// The integral along a row from its left border to `x`, in columns; any row and any x: the picture is carried on.
  WeighedTexels up_to(double x, std::int64_t row, PictureWrap wrap) const;
  /// The texel at a place in columns and rows.
  WeighedTexels at(double x, double y, PictureWrap wrap) const;
  /// Over all texels.
  const WeighedTexels& whole() const { return whole_; }
  /// The least and the greatest of each channel.
  const Rgb& low() const { return low_; }
  const Rgb& high() const { return high_; }

 private:
  static constexpr int columns_a_sum = 16;

  const Texel& texel(int column, int row) const;
  WeighedTexels within(double x, int row) const;
  WeighedTexels whole(int row) const;

  PictureTexels picture_;
  int sums_a_row_;
  std::vector<WeighedTexels> sums_;
  WeighedTexels whole_;
  Rgb low_, high_;
};

}  // namespace gibench
