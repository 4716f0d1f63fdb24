#include "methods/spectral/all_bounces.h"

#include <Eigen/Dense>
#include <algorithm>
#include <memory>

#include "methods/spectral/compression.h"

namespace gibench::spectral {

namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
constexpr std::size_t row_chunk = 64, pilot_rows = 256;

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

Matrix series(const Matrix& bounce, int most_bounces) {
  const Matrix identity = Matrix::Identity(bounce.rows(), bounce.cols());
  if (most_bounces == 0) return (identity - bounce).partialPivLu().inverse();
  Matrix sum = identity;
  for (int i = 1; i < most_bounces; ++i) sum = identity + bounce * sum;
  return sum;
}

bool is_grey(std::span<const Rgb4> reflectance) {
  return std::all_of(reflectance.begin(), reflectance.end(), [](const Rgb4& r) { return r.r == r.g && r.g == r.b; });
}

}  // namespace

std::vector<TransferMatrix> all_bounces(const SpectralBasis& basis, const TransferMatrix& one_bounce,
                                        std::span<const Rgb4> reflectance, std::span<const double> areas, int most_bounces,
                                        const std::vector<std::vector<Rgb4>>& lights, double compression_error, Task& task) {
  const std::size_t columns = basis.columns(), rows = basis.slots();
  std::vector<TransferMatrix> result;
  const int channels = is_grey(reflectance) ? 1 : 3;
  for (int channel = 0; channel < channels && !task.cancelled(); ++channel) {
    const Matrix folded = series(basis_to_basis(basis, one_bounce, reflectance, channel, task), most_bounces);
    const auto dense_row = [&](std::size_t row, std::span<float> values) {
      std::vector<double> sparse(columns, 0.0);
      one_bounce.add_row_to(row, 1.0F, sparse);
      Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(columns));
      for (std::size_t c = 0; c < columns; ++c)
        if (sparse[c] != 0.0) sum += sparse[c] * folded.row(static_cast<Eigen::Index>(c));
      for (std::size_t c = 0; c < columns; ++c) values[c] = static_cast<float>(sum[static_cast<Eigen::Index>(c)]);
    };
    std::vector<float> steps;
    if (compression_error > 0.0) {
      std::vector<PilotRow> pilot(std::min(pilot_rows, rows));
      for (std::size_t i = 0; i < pilot.size(); ++i) {
        const std::size_t row = (2 * i + 1) * rows / (2 * pilot.size());
        pilot[i] = {std::vector<float>(columns), {}, areas[row]};
        dense_row(row, pilot[i].values);
      }
      steps = choose_steps(basis, lights, pilot, compression_error);
    }
    TransferMatrix& matrix = result.emplace_back(steps, basis.constant());
    std::vector<std::unique_ptr<TransferMatrix::Block>> blocks(chunk_count(rows, row_chunk));
    task.parallel_chunks(rows, row_chunk, [&](const ChunkRange& range) {
      auto& block = blocks[range.chunk] = std::make_unique<TransferMatrix::Block>(matrix);
      std::vector<float> values(columns);
      for (std::size_t row = range.begin; row < range.end; ++row) {
        dense_row(row, values);
        block->add_row(values);
      }
    });
    for (const auto& block : blocks)
      if (block) matrix.append(*block);
  }
  return result;
}

}  // namespace gibench::spectral
