#include "common/reflectance/lobe_harmonics.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "common/core/sampling.h"
#include "common/core/sobol.h"
#include "common/reflectance/bsdf.h"

namespace gibench {

namespace {

constexpr std::size_t angles = 65;              // 0 to just under 90 degrees
constexpr float steepest = 0.5F * pi - 1e-3F;   // the last of them
constexpr std::uint32_t directions = 1U << 12;  // of each integral
constexpr double pull = 1e-4;                   // share of the Gram matrix's mean diagonal
constexpr std::uint64_t random_key = 0x6c6f626573ULL;

using Gram = Eigen::Matrix<double, harmonic_count, harmonic_count>;
using Sums = Eigen::Matrix<double, harmonic_count, 3>;

Eigen::Matrix<double, harmonic_count, 1> harmonics_at(const Vec3& direction) {
  const Harmonics h = spherical_harmonics(direction);
  return Eigen::Map<const Eigen::Matrix<float, harmonic_count, 1>>(h.data()).cast<double>();
}

/// ∫ cos h_j h_k over the hemisphere.
Gram cosine_gram() {
  Gram gram = Gram::Zero();
  const SobolSequence random(random_key);
  for (std::uint32_t i = 0; i < directions; ++i) {
    const auto h = harmonics_at(cosine_hemisphere(random.pair(i, 0).unit()));
    gram += h * h.transpose() * (pi_double / directions);
  }
  return gram;
}

/// ∫ cos f h_k, by directions drawn from the lobe.
Sums cosine_moments(const SurfaceBsdf& lobe, const Vec3& out) {
  Sums sums = Sums::Zero();
  const SobolSequence random(random_key);
  for (std::uint32_t i = 0; i < directions; ++i) {
    const BsdfSample drawn = lobe.sample(out, random.pair(i, 1).unit().x, random.pair(i, 0).unit());
    if (is_black(drawn.weight)) continue;
    const auto h = harmonics_at(drawn.in);
    for (int c = 0; c < 3; ++c) sums.col(c) += h * static_cast<double>(drawn.weight[c]) / directions;
  }
  return sums;
}

}  // namespace

LobeHarmonics::LobeHarmonics(const Material& material) {
  const SurfaceBsdf lobe = SurfaceBsdf::specular_part(material);
  Gram gram = cosine_gram();
  const double added = pull * gram.trace() / harmonic_count;
  for (Eigen::Index k = 1; k < gram.rows(); ++k) gram(k, k) += added;
  const Eigen::LDLT<Gram> solver(gram);
  for (std::size_t i = 0; i < angles; ++i) {
    const float angle = steepest * static_cast<float>(i) / static_cast<float>(angles - 1);
    const Sums fitted = solver.solve(cosine_moments(lobe, {std::sin(angle), 0.0F, std::cos(angle)}));
    RgbHarmonics& row = by_angle_.emplace_back();
    for (std::size_t k = 0; k < harmonic_count; ++k) {
      const auto j = static_cast<Eigen::Index>(k);
      row[k] = Rgb(RgbDouble(fitted(j, 0), fitted(j, 1), fitted(j, 2)));
    }
  }
}

RgbHarmonics LobeHarmonics::coefficients(const Vec3& normal, const Vec3& toward_viewer) const {
  const float cosine = glm::dot(normal, toward_viewer);
  if (!(cosine > 0.0F)) return {};
  const float place = std::min(std::acos(std::min(1.0F, cosine)), steepest) / steepest * static_cast<float>(angles - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), angles - 2);
  const float share = place - static_cast<float>(below);
  RgbHarmonics local;
  for (std::size_t k = 0; k < harmonic_count; ++k)
    local[k] = by_angle_[below][k] * (1.0F - share) + by_angle_[below + 1][k] * share;
  // The frame whose x axis points to the viewer; any about the normal where the viewer is right above.
  Frame frame(normal);
  const Vec3 across = toward_viewer - cosine * normal;
  if (const float length = glm::length(across); length > 1e-4F) {
    frame.tangent = across / length;
    frame.bitangent = glm::cross(normal, frame.tangent);
  }
  return to_world(local, frame);
}

}  // namespace gibench
