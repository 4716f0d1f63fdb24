#include "methods/spectral/all_bounces.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace gibench::spectral {

namespace {

constexpr double least_loss = 1e-3;  // of the slowest light at a bounce; T^s is exact to some 1e-5
constexpr double told_loss = 0.1;    // from which on the report says how far errors are multiplied
constexpr int most_power_steps = 300;
constexpr double steady = 1e-7;  // change of the ratio from one power to the next

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// B, a part's rows after another's.
Matrix basis_to_basis(const SpectralBasis& basis, const TransferMatrix& one_bounce, std::span<const Rgb4> reflectance,
                      int channel, Task& task) {
  const auto columns = static_cast<Eigen::Index>(basis.columns());
  Matrix result = Matrix::Zero(columns, columns);
  task.parallel_chunks(basis.parts().size(), 1, [&](const ChunkRange& range) {
    const SpectralBasis::Part& part = basis.parts()[range.begin];
    for (std::uint32_t slot = part.begin; slot < part.end; ++slot) {
      const float reflected = Rgb(reflectance[slot])[channel] * basis.weight()[slot];
      const std::span<const float> functions = basis.row(part, slot);
      for (std::uint32_t f = 0; f < part.functions; ++f) {
        double* const row = result.data() + static_cast<Eigen::Index>(part.column + f) * columns;
        one_bounce.add_row_to(slot, reflected * functions[f], {row, static_cast<std::size_t>(columns)});
      }
    }
  });
  return result;
}

/// The share of itself that the slowest light has after one more bounce: the spectral radius of B, by its powers.
double slowest_ratio(const Matrix& bounce, const std::vector<float>& start) {
  Eigen::VectorXd light = Eigen::Map<const Eigen::VectorXf>(start.data(), static_cast<Eigen::Index>(start.size())).cast<double>();
  double ratio = 0.0;
  for (int step = 0; step < most_power_steps; ++step) {
    const Eigen::VectorXd next = bounce * light;
    const double before = std::exchange(ratio, next.norm() / light.norm());
    if (!(ratio > 0.0)) return 0.0;
    if (step > 0 && std::fabs(ratio - before) < steady * ratio) break;
    light = next / next.norm();
  }
  return ratio;
}

Matrix sum_of(const Matrix& bounce, int most_bounces) {
  const Matrix identity = Matrix::Identity(bounce.rows(), bounce.cols());
  if (most_bounces == 0) return (identity - bounce).partialPivLu().inverse();
  Matrix sum = identity;
  for (int i = 1; i < most_bounces; ++i) sum = identity + bounce * sum;
  return sum;
}

bool is_grey(std::span<const Rgb4> reflectance) {
  return std::all_of(reflectance.begin(), reflectance.end(), [](const Rgb4& r) { return r.r == r.g && r.g == r.b; });
}

/// T* = T^s G, row by row.
class FoldedRows {
 public:
  FoldedRows(const TransferMatrix& one_bounce, const Matrix& folded) : one_bounce_(one_bounce), folded_(folded) {}

  std::vector<float> block(std::size_t begin) const {
    const auto columns = static_cast<std::size_t>(folded_.cols());
    std::vector<float> values((std::min(one_bounce_.rows(), begin + block_rows) - begin) * columns);
    for (std::size_t i = 0; i * columns < values.size(); ++i) fill(begin + i, std::span(values).subspan(i * columns, columns));
    return values;
  }

 private:
  void fill(std::size_t row, std::span<float> values) const {
    std::vector<double> sparse(values.size(), 0.0);
    one_bounce_.add_row_to(row, 1.0F, sparse);
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(folded_.cols());
    for (std::size_t c = 0; c < values.size(); ++c)
      if (sparse[c] != 0.0) sum += sparse[c] * folded_.row(static_cast<Eigen::Index>(c));
    for (std::size_t c = 0; c < values.size(); ++c) values[c] = static_cast<float>(sum[static_cast<Eigen::Index>(c)]);
  }

  const TransferMatrix& one_bounce_;
  const Matrix& folded_;
};

std::vector<PilotBlock> pilots_of(const FoldedRows& rows, std::size_t count, std::span<const double> areas) {
  std::vector<PilotBlock> pilots;
  for (const std::size_t block : pilot_blocks(chunk_count(count, block_rows))) {
    const std::size_t begin = block * block_rows, end = std::min(count, begin + block_rows);
    pilots.push_back({rows.block(begin),
                      {},
                      {areas.begin() + static_cast<std::ptrdiff_t>(begin), areas.begin() + static_cast<std::ptrdiff_t>(end)}});
  }
  return pilots;
}

TransferMatrix compressed(const SpectralBasis& basis, const FoldedRows& rows, std::span<const double> areas,
                          const CompressionWish& compression, Task& task) {
  const std::size_t count = basis.slots();
  TransferMatrix matrix(truncation_for(
                            compression, basis, [&] { return pilots_of(rows, count, areas); }, task),
                        basis.constant());
  std::vector<std::unique_ptr<TransferMatrix::Section>> sections(chunk_count(count, block_rows));
  task.parallel_chunks(count, block_rows, [&](const ChunkRange& range) {
    auto& section = sections[range.chunk] = std::make_unique<TransferMatrix::Section>(matrix);
    section->add_block(rows.block(range.begin));
  });
  for (const auto& section : sections)
    if (section) matrix.append(*section);
  return matrix;
}

/// Why the series has no sum that is known, or how far an error of the matrix counts in it.
void judge(double ratio, Folding& folding) {
  if (ratio > 1.0 - least_loss) {
    folding.termination = Termination::not_converged;
    folding.message = fmt::format(
        "light keeps {:.6f} of itself from bounce to bounce, so that the sum of all bounces is not known; bound them, lower the "
        "albedos, or set mode=bounces",
        ratio);
  } else if (ratio > 1.0 - told_loss) {
    folding.message =
        fmt::format("light keeps {:.3f} of itself from bounce to bounce: an error of the matrix counts up to {:.0f} times", ratio,
                    1.0 / (1.0 - ratio));
  }
}

}  // namespace

Folding fold_bounces(const SpectralBasis& basis, const TransferMatrix& one_bounce, const FoldingWish& wish,
                     const CompressionWish& compression, Task& task) {
  Folding folding;
  const int channels = is_grey(wish.reflectance) ? 1 : 3;
  for (int channel = 0; channel < channels && !task.cancelled(); ++channel) {
    const Matrix bounce = basis_to_basis(basis, one_bounce, wish.reflectance, channel, task);
    if (wish.most_bounces == 0 && succeeded(folding.termination)) judge(slowest_ratio(bounce, basis.constant()), folding);
    if (!succeeded(folding.termination) || task.cancelled()) break;
    const Matrix folded = sum_of(bounce, wish.most_bounces);
    folding.irradiance.push_back(compressed(basis, FoldedRows(one_bounce, folded), wish.areas, compression, task));
    if (wish.keep_light) {
      const Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> light = folded.cast<float>();
      folding.light.emplace_back(light.data(), light.data() + light.size());
    }
  }
  if (!succeeded(folding.termination)) folding.irradiance.clear(), folding.light.clear();
  return folding;
}

}  // namespace gibench::spectral
