#include "common/lighting/environment_sampler.h"

#include <algorithm>
#include <cmath>

#include "common/core/sampling.h"

namespace gibench {

namespace {

double mean(const Rgb& c) { return (static_cast<double>(c.r) + static_cast<double>(c.g) + static_cast<double>(c.b)) / 3.0; }

/// Turns about +y: positive angles carry −z towards −x.
Vec3 turned(const Vec3& v, float angle) {
  const float c = std::cos(angle), s = std::sin(angle);
  return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

struct Pick {
  std::size_t index;
  float within;  ///< [0, 1): where in the interval
};

/// The interval of a cumulative table of count + 1 values from 0 to 1 that `u` falls in; never an empty one.
Pick pick(const float* up_to, std::size_t count, float u) {
  const float* found = std::upper_bound(up_to + 1, up_to + count, u);
  const auto index = static_cast<std::size_t>(found - up_to) - 1;
  const float width = up_to[index + 1] - up_to[index];
  return {index, width > 0.0F ? std::clamp((u - up_to[index]) / width, 0.0F, 0x1.fffffep-1F) : 0.5F};
}

/// Turns weights[0 … count) into a cumulative table up_to[0 … count]; returns their sum. Black rows become uniform.
double accumulate(const std::vector<double>& weights, float* up_to) {
  double total = 0.0;
  for (const double weight : weights) total += weight;
  double sum = 0.0;
  up_to[0] = 0.0F;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sum += total > 0.0 ? weights[i] / total : 1.0 / static_cast<double>(weights.size());
    up_to[i + 1] = static_cast<float>(std::min(sum, 1.0));
  }
  up_to[weights.size()] = 1.0F;
  return total;
}

}  // namespace

EnvironmentSampler::EnvironmentSampler(const EnvironmentLight& light)
    : factor_(light.radiance), image_(light.image), rotation_(light.rotate_y_degrees * pi / 180.0F) {
  if (image_) build_table();
  else integral_ = 4.0 * pi_double * mean(factor_);
}

double EnvironmentSampler::cell_solid_angle(int row) const {
  const double step = pi_double / image_->height;
  return (std::cos(row * step) - std::cos((row + 1) * step)) * 2.0 * pi_double / image_->width;
}

void EnvironmentSampler::build_table() {
  const auto width = static_cast<std::size_t>(image_->width), height = static_cast<std::size_t>(image_->height);
  rows_up_to_.resize(height + 1);
  columns_up_to_.resize(height * (width + 1));
  std::vector<double> rows(height), columns(width);
  for (std::size_t row = 0; row < height; ++row) {
    for (std::size_t column = 0; column < width; ++column) columns[column] = mean(factor_ * image_->pixels[row * width + column]);
    rows[row] = accumulate(columns, &columns_up_to_[row * (width + 1)]) * cell_solid_angle(static_cast<int>(row));
  }
  integral_ = accumulate(rows, rows_up_to_.data());
}

EnvironmentSampler::Cell EnvironmentSampler::cell_of(const Vec3& direction) const {
  const Vec3 local = turned(direction, -rotation_);
  const float polar = std::acos(std::clamp(local.y, -1.0F, 1.0F)) / pi;     // 0 up, 1 down
  const float around = 0.5F + std::atan2(local.x, -local.z) / (2.0F * pi);  // the middle looks along −z
  const auto index = [](float share, int count) {
    return std::clamp(static_cast<int>(share * static_cast<float>(count)), 0, count - 1);
  };
  return {index(polar, image_->height), index(around, image_->width)};
}

Rgb EnvironmentSampler::radiance(const Vec3& direction) const {
  if (!image_) return factor_;
  const Cell cell = cell_of(direction);
  return factor_ * image_->pixels[static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(image_->width) +
                                  static_cast<std::size_t>(cell.column)];
}

Vec3 EnvironmentSampler::sample(const Vec3& normal, Vec2 u) const {
  if (!image_) return Frame(normal).to_world(cosine_hemisphere(u));
  const auto width = static_cast<std::size_t>(image_->width), height = static_cast<std::size_t>(image_->height);
  const Pick row = pick(rows_up_to_.data(), height, u.x);
  const Pick column = pick(&columns_up_to_[row.index * (width + 1)], width, u.y);
  const float step = pi / static_cast<float>(height);
  const float top = std::cos(static_cast<float>(row.index) * step), bottom = std::cos(static_cast<float>(row.index + 1) * step);
  const float cosine = top + row.within * (bottom - top);
  const float sine = std::sqrt(std::max(0.0F, 1.0F - cosine * cosine));
  const float around = 2.0F * pi * ((static_cast<float>(column.index) + column.within) / static_cast<float>(width) - 0.5F);
  return turned({sine * std::sin(around), cosine, -sine * std::cos(around)}, rotation_);
}

float EnvironmentSampler::pdf(const Vec3& normal, const Vec3& direction) const {
  if (!image_) return cosine_hemisphere_pdf(glm::dot(normal, direction));
  const auto width = static_cast<std::size_t>(image_->width);
  const Cell cell = cell_of(direction);
  const auto row = static_cast<std::size_t>(cell.row), column = static_cast<std::size_t>(cell.column);
  const float* columns = &columns_up_to_[row * (width + 1)];
  const float share = (rows_up_to_[row + 1] - rows_up_to_[row]) * (columns[column + 1] - columns[column]);
  return share / static_cast<float>(cell_solid_angle(cell.row));
}

}  // namespace gibench
