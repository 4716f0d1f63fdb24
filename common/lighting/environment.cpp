#include "common/lighting/environment.h"

#include <algorithm>
#include <cmath>

#include "common/core/sampling.h"

namespace gibench {

namespace {

/// Cosine of the angle from +y at the upper edge of a row.
double row_cosine(int row, int height) { return std::cos(pi_double * row / height); }

/// The cell of a cumulative table that `u` falls into; `u` becomes its place within the cell.
int find_cell(const float* cdf, int cells, float& u) {
  const float* found = std::upper_bound(cdf, cdf + cells + 1, u) - 1;
  int cell = std::clamp(static_cast<int>(found - cdf), 0, cells - 1);
  while (cell > 0 && cdf[cell + 1] <= cdf[cell]) --cell;  // never a cell without probability
  const float width = cdf[cell + 1] - cdf[cell];
  u = width > 0.0F ? std::clamp((u - cdf[cell]) / width, 0.0F, 0x1.fffffep-1F) : 0.5F;
  return cell;
}

void normalise(float* cdf, int cells, double sum) {
  for (int i = 0; i <= cells; ++i)
    cdf[i] = static_cast<float>(sum > 0.0 ? static_cast<double>(cdf[i]) / sum : static_cast<double>(i) / cells);
  cdf[cells] = 1.0F;
}

}  // namespace

Environment::Environment(const EnvironmentLight& light)
    : factor_(light.radiance), image_(light.image), rotation_(light.rotate_y_degrees * (pi / 180.0F)) {
  if (image_) tabulate();
  else integral_ = 4.0 * pi_double * static_cast<double>(largest(factor_));
}

/// Row and column tables of ∫ radiance dω over the pixels, largest channel.
void Environment::tabulate() {
  const int width = image_->width;
  const int height = image_->height;
  const auto columns_a_row = static_cast<std::size_t>(width);
  row_cdf_.assign(static_cast<std::size_t>(height) + 1, 0.0F);
  column_cdf_.assign(static_cast<std::size_t>(height) * (columns_a_row + 1), 0.0F);
  for (int row = 0; row < height; ++row) {
    const double solid_angle = 2.0 * pi_double / width * (row_cosine(row, height) - row_cosine(row + 1, height));
    double sum = 0.0;
    float* columns = &column_cdf_[static_cast<std::size_t>(row) * (columns_a_row + 1)];
    for (std::size_t column = 0; column < columns_a_row; ++column) {
      const float value = largest(image_->pixels[static_cast<std::size_t>(row) * columns_a_row + column] * factor_);
      density_.push_back(value);
      sum += static_cast<double>(value);
      columns[column + 1] = static_cast<float>(sum);
    }
    normalise(columns, width, sum);
    integral_ += sum * solid_angle;
    row_cdf_[static_cast<std::size_t>(row) + 1] = static_cast<float>(integral_);
  }
  normalise(row_cdf_.data(), height, integral_);
  for (float& density : density_) density = integral_ > 0.0 ? static_cast<float>(static_cast<double>(density) / integral_) : 0.0F;
}

std::size_t Environment::pixel_of(const Vec3& direction) const {
  const float turns = (std::atan2(direction.x, -direction.z) + rotation_) / (2.0F * pi) + 0.5F;
  const float wrapped = turns - std::floor(turns);
  const float polar = std::acos(std::clamp(direction.y, -1.0F, 1.0F)) / pi;
  const int column = std::min(static_cast<int>(wrapped * static_cast<float>(image_->width)), image_->width - 1);
  const int row = std::min(static_cast<int>(polar * static_cast<float>(image_->height)), image_->height - 1);
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(image_->width) + static_cast<std::size_t>(column);
}

Rgb Environment::radiance(const Vec3& direction) const {
  return image_ ? factor_ * image_->pixels[pixel_of(direction)] : factor_;
}

Vec3 Environment::sample(Vec2 u, const Vec3& normal) const {
  if (!image_) return Frame(normal).to_world(square_to_cosine_hemisphere(u));
  const int row = find_cell(row_cdf_.data(), image_->height, u.y);
  const std::size_t stride = static_cast<std::size_t>(image_->width) + 1;
  const int column = find_cell(&column_cdf_[static_cast<std::size_t>(row) * stride], image_->width, u.x);
  // Uniform by solid angle within the pixel: linear in the cosine.
  const double top = row_cosine(row, image_->height);
  const double bottom = row_cosine(row + 1, image_->height);
  const auto y = static_cast<float>(top + (bottom - top) * static_cast<double>(u.y));
  const float radius = std::sqrt(std::max(0.0F, 1.0F - y * y));
  const float angle = 2.0F * pi * ((static_cast<float>(column) + u.x) / static_cast<float>(image_->width) - 0.5F) - rotation_;
  return {radius * std::sin(angle), y, -radius * std::cos(angle)};
}

float Environment::pdf(const Vec3& direction, const Vec3& normal) const {
  return image_ ? density_[pixel_of(direction)] : std::max(0.0F, glm::dot(direction, normal)) / pi;
}

}  // namespace gibench
