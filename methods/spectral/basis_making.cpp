#include "methods/spectral/basis_making.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "methods/spectral/eigenvectors.h"

namespace gibench::spectral {

namespace {

constexpr std::uint64_t most_columns = 65536;  // columns are numbered in 16 bits

std::string too_many_columns(const Partition& partition, std::uint64_t columns) {
  return fmt::format(
      "{} parts need {} columns where there may be {}; lower basis_functions, or join the scene's loose "
      "pieces, of which each is a part",
      partition.parts(), columns, most_columns);
}

std::string no_eigenvectors(const Partition& partition, std::size_t part) {
  return fmt::format(
      "the eigenvectors of part {} of {} ({} vertices) were not found: three shifts of the Lanczos solver failed, and {}; set "
      "another part_vertices",
      part + 1, partition.parts(), partition.part_size(part),
      partition.part_size(part) > most_dense ? "it is too large for the dense one" : "so did the dense one");
}

/// How the eigenvectors of a part were found; nothing where they were not.
struct Found {
  bool dense;
  int failed_attempts;
};

/// Finds the functions of a part and writes them into the basis: y / √w of the symmetric Laplacian's eigenvectors y.
std::optional<Found> fill_part(const SurfaceGraph& graph, const Partition& partition, const SpectralBasis::Part& part,
                               Laplacian kind, double mean_area, SpectralBasis& basis) {
  std::vector<std::uint32_t> ascending(partition.order.begin() + part.begin, partition.order.begin() + part.end);
  std::sort(ascending.begin(), ascending.end());
  const SymmetricLaplacian laplacian = symmetric_laplacian(graph, ascending, kind, mean_area);
  const std::optional<Eigenpairs> pairs = smallest_eigenpairs(laplacian.matrix, part.functions);
  if (!pairs) return std::nullopt;
  for (std::uint32_t slot = part.begin; slot < part.end; ++slot) {
    const Eigen::Index i = std::lower_bound(ascending.begin(), ascending.end(), partition.order[slot]) - ascending.begin();
    basis.set_weight(slot, static_cast<float>(laplacian.weight[i]));
    const std::span<float> row = basis.row_to_fill(part, slot);
    for (std::uint32_t f = 0; f < part.functions; ++f)
      row[f] = static_cast<float>(pairs->vectors(i, static_cast<Eigen::Index>(f)) / std::sqrt(laplacian.weight[i]));
  }
  return Found{pairs->dense, pairs->failed_attempts};
}

}  // namespace

BasisMaking make_basis(const SurfaceGraph& graph, const Partition& partition, const std::vector<std::uint32_t>& functions,
                       Laplacian kind, Task& task) {
  BasisMaking making;
  if (const std::uint64_t columns = SpectralBasis::columns_for(functions); columns > most_columns) {
    making.failure = too_many_columns(partition, columns);
    return making;
  }
  SpectralBasis& basis = making.basis = SpectralBasis(partition, functions);
  const double mean_area = std::accumulate(graph.area.begin(), graph.area.end(), 0.0) / static_cast<double>(graph.size());
  std::vector<std::optional<Found>> outcome(partition.parts());
  task.parallel_chunks(partition.parts(), 1, [&](const ChunkRange& range) {
    outcome[range.begin] = fill_part(graph, partition, basis.parts()[range.begin], kind, mean_area, basis);
  });
  if (task.cancelled()) return making;
  for (std::size_t p = 0; p < partition.parts(); ++p) {
    if (!outcome[p]) {
      making.failure = no_eigenvectors(partition, p);
      return making;
    }
    making.dense_parts += outcome[p]->dense ? 1U : 0U;
    making.failed_attempts += static_cast<std::uint32_t>(outcome[p]->failed_attempts);
  }
  return making;
}

}  // namespace gibench::spectral
