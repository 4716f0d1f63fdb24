#include "methods/spectral/transfer_filling.h"

#include <algorithm>
#include <memory>

#include "methods/spectral/transfer_rows.h"

namespace gibench::spectral {

namespace {

constexpr std::size_t rows_a_report = 256 * block_rows;  // vertices between two signs of progress

class Filling {
 public:
  Filling(const World& world, const VertexRays& rays, Transfer& transfer, Task& task)
      : world_(world), transfer_(transfer), task_(task), makers_(transfer.basis, rays) {}

  /// All rows, section by section; the blocks of each are made in parallel and appended in order.
  void fill() {
    const std::size_t slots = transfer_.basis.slots();
    for (std::size_t begin = 0; begin < slots && !task_.cancelled(); begin += rows_a_report) {
      fill_section(begin, std::min(slots, begin + rows_a_report));
      task_.progress("transfer",
                     0.12 + 0.85 * static_cast<double>(std::min(slots, begin + rows_a_report)) / static_cast<double>(slots));
    }
  }

 private:
  /// A block of the matrix, and one of every slice if any of its nodes is glossy.
  struct Made {
    TransferMatrix::Section irradiance;
    std::vector<TransferMatrix::Section> slices;
  };

  void fill_section(std::size_t begin, std::size_t end) {
    std::vector<std::unique_ptr<Made>> made(chunk_count(end - begin, block_rows));
    task_.parallel_chunks(end - begin, block_rows, [&](const ChunkRange& range) {
      makers_.use([&](TransferRows& maker) {
        made[range.chunk] = std::make_unique<Made>(make_block(begin + range.begin, begin + range.end, maker));
      });
    });
    for (const auto& block : made) {
      if (!block) continue;  // cancelled
      transfer_.one_bounce.append(block->irradiance);
      for (std::size_t k = 0; k < block->slices.size(); ++k) transfer_.harmonic_slices[k].append(block->slices[k]);
    }
  }

  Made make_block(std::size_t begin, std::size_t end, TransferRows& maker) {
    const std::size_t columns = transfer_.basis.columns(), slices = transfer_.harmonic_slices.size();
    RayStream stream = task_.rays(world_);
    const std::span nodes = std::span(transfer_.node_of_slot).subspan(begin, end - begin);
    const std::span glossy_rows = std::span(transfer_.glossy_row).subspan(begin, end - begin);
    std::vector<std::vector<float>> rows(1 + slices);  // of the irradiance and of every slice, one behind the other
    rows.front().resize(nodes.size() * columns);
    if (std::all_of(glossy_rows.begin(), glossy_rows.end(), [](std::uint32_t row) { return row == Transfer::no_row; }))
      maker.irradiance(nodes, stream, rows.front());
    else make_glossy_rows(maker, nodes, glossy_rows, stream, rows);
    Made made{TransferMatrix::Section(transfer_.one_bounce), {}};
    made.irradiance.add_block(rows.front());
    for (std::size_t k = 0; k < slices; ++k) {
      made.slices.emplace_back(transfer_.harmonic_slices[k]);
      if (!rows[1 + k].empty()) made.slices.back().add_block(rows[1 + k]);
    }
    return made;
  }

  /// One node after the other: those without gloss have no rows in the slices.
  static void make_glossy_rows(TransferRows& maker, std::span<const std::uint32_t> nodes,
                               std::span<const std::uint32_t> glossy_rows, RayStream& stream,
                               std::vector<std::vector<float>>& rows) {
    const std::size_t columns = rows.front().size() / nodes.size();
    std::vector<float> all(columns * rows.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const std::span<float> irradiance = std::span(rows.front()).subspan(i * columns, columns);
      if (glossy_rows[i] == Transfer::no_row) {
        maker.irradiance(nodes[i], stream, irradiance);
        continue;
      }
      maker.with_harmonics(nodes[i], stream, all);
      std::copy_n(all.begin(), columns, irradiance.begin());
      for (std::size_t k = 1; k < rows.size(); ++k) {
        const std::span<float> row = std::span(all).subspan(k * columns, columns);
        rows[k].insert(rows[k].end(), row.begin(), row.end());
      }
    }
  }

  const World& world_;
  Transfer& transfer_;
  Task& task_;
  TransferRowsPool makers_;
};

}  // namespace

void fill_matrices(const World& world, const VertexRays& rays, const Truncations& truncations, Transfer& transfer, Task& task) {
  const std::vector<float> constant = transfer.basis.constant();
  transfer.one_bounce = TransferMatrix(truncations.irradiance, constant);
  if (!transfer.glossy_slots.empty())
    transfer.harmonic_slices.assign(harmonic_count - 1, TransferMatrix(truncations.slices, constant));
  Filling(world, rays, transfer, task).fill();
}

}  // namespace gibench::spectral
