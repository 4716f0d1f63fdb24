#include "methods/spectral/all_bounces.h"

#include <Eigen/Dense>
#include <algorithm>
#include <memory>

#include "methods/spectral/compression.h"

namespace gibench::spectral {

namespace {

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
                                        const TrialLights& lights, double compression_error, Task& task) {
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
    const auto dense_block = [&](std::size_t begin) {
      std::vector<float> values((std::min(rows, begin + block_rows) - begin) * columns);
      for (std::size_t i = 0; i * columns < values.size(); ++i)
        dense_row(begin + i, std::span(values).subspan(i * columns, columns));
      return values;
    };
    Truncation truncation;
    if (compression_error > 0.0) {
      std::vector<PilotBlock> pilots;
      for (const std::size_t block : pilot_blocks(chunk_count(rows, block_rows))) {
        PilotBlock& pilot = pilots.emplace_back(PilotBlock{dense_block(block * block_rows), {}, {}});
        const auto first = areas.begin() + static_cast<std::ptrdiff_t>(block * block_rows);
        pilot.areas.assign(first, first + static_cast<std::ptrdiff_t>(pilot.rows.size() / columns));
      }
      truncation = choose_truncation(basis, lights, pilots, compression_error, task);
    }
    TransferMatrix& matrix = result.emplace_back(truncation, basis.constant());
    std::vector<std::unique_ptr<TransferMatrix::Section>> sections(chunk_count(rows, block_rows));
    task.parallel_chunks(rows, block_rows, [&](const ChunkRange& range) {
      auto& section = sections[range.chunk] = std::make_unique<TransferMatrix::Section>(matrix);
      section->add_block(dense_block(range.begin));
    });
    for (const auto& section : sections)
      if (section) matrix.append(*section);
  }
  return result;
}

}  // namespace gibench::spectral
