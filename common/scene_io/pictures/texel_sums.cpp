#include "common/scene_io/pictures/texel_sums.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/core/error.h"

namespace gibench {

namespace {

WeighedTexels weighed(const Texel& texel) {
  const auto opacity = static_cast<double>(texel.opacity);
  return {opacity * RgbDouble(texel.colour), opacity};
}

double place_in_picture(double x, int size, Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat: return x - size * std::floor(x / size);
    case Wrap::clamp: return x;
    case Wrap::mirror: {
      const double rest = x - 2.0 * size * std::floor(x / (2.0 * size));
      return rest <= size ? rest : 2.0 * size - rest;
    }
  }
  return 0.0;
}

/// A place of the picture that is carried on, in [0, size], also where x is so large that its rest is rounding.
double folded(double x, int size, Wrap wrap) {
  return std::clamp(place_in_picture(x, size, wrap), 0.0, static_cast<double>(size));
}

/// The texel at `x`, which may lie on the far border.
int index_of(double x, int size) { return std::clamp(static_cast<int>(std::floor(x)), 0, size - 1); }

}  // namespace

TexelSums::TexelSums(PictureTexels picture)
    : picture_(std::move(picture)),
      sums_a_row_(width() / columns_a_sum + 1),
      low_(std::numeric_limits<float>::max()),
      high_(std::numeric_limits<float>::lowest()) {
  GIBENCH_CHECK(width() > 0 && height() > 0 && !picture_.texels.empty(), "a picture has texels");
  sums_.reserve(static_cast<std::size_t>(sums_a_row_) * static_cast<std::size_t>(height()));
  for (int row = 0; row < height(); ++row) {
    WeighedTexels sum;
    for (int column = 0; column < width(); ++column) {
      if (column % columns_a_sum == 0) sums_.push_back(sum);
      const WeighedTexels here = weighed(texel(column, row));
      sum += here;
      whole_ += here;
    }
    if (width() % columns_a_sum == 0) sums_.push_back(sum);
  }
  for (const Texel& texel : picture_.texels)
    for (int c = 0; c < 3; ++c) {
      low_[c] = std::min(low_[c], texel.colour[c]);
      high_[c] = std::max(high_[c], texel.colour[c]);
    }
}

const Texel& TexelSums::texel(int column, int row) const {
  return picture_
      .texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture_.width) + static_cast<std::size_t>(column)];
}

/// For x in [0, width].
WeighedTexels TexelSums::within(double x, int row) const {
  const int whole_columns = std::min(static_cast<int>(x), picture_.width);
  const int block = whole_columns / columns_a_sum;
  WeighedTexels sum =
      sums_[static_cast<std::size_t>(row) * static_cast<std::size_t>(sums_a_row_) + static_cast<std::size_t>(block)];
  for (int column = block * columns_a_sum; column < whole_columns; ++column) sum += weighed(texel(column, row));
  if (whole_columns < picture_.width) sum += (x - whole_columns) * weighed(texel(whole_columns, row));
  return sum;
}

WeighedTexels TexelSums::whole(int row) const { return within(picture_.width, row); }

WeighedTexels TexelSums::up_to(double x, std::int64_t any_row, PictureWrap wrap) const {
  const int columns = width();
  const int row = index_of(folded(static_cast<double>(any_row) + 0.5, picture_.height, wrap.v), picture_.height);
  const double rest = folded(x, columns, wrap.u);
  switch (wrap.u) {
    case Wrap::repeat: return std::floor(x / columns) * whole(row) + within(rest, row);
    case Wrap::clamp: return within(rest, row) + (x - rest) * weighed(texel(x < rest ? 0 : columns - 1, row));
    case Wrap::mirror: {
      const double periods = std::floor(x / (2.0 * columns));
      const bool is_back = x - 2.0 * columns * periods > columns;
      return is_back ? (2.0 * periods + 2.0) * whole(row) + -1.0 * within(rest, row)
                     : 2.0 * periods * whole(row) + within(rest, row);
    }
  }
  return {};
}

WeighedTexels TexelSums::at(double x, double y, PictureWrap wrap) const {
  return weighed(texel(index_of(folded(x, picture_.width, wrap.u), picture_.width),
                       index_of(folded(y, picture_.height, wrap.v), picture_.height)));
}

}  // namespace gibench
