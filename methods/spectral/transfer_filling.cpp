#include "methods/spectral/transfer_filling.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "methods/spectral/transfer_rows.h"

namespace gibench::spectral {

namespace {

constexpr std::size_t rows_a_report = 256 * block_rows;  // vertices between two signs of progress

class Filling {
 public:
  Filling(const World& world, const VertexRays& rays, Transfer& transfer, Task& task)
      : world_(world), transfer_(transfer), task_(task), makers_(transfer.basis, rays) {}

  /// All rows, section by section; the blocks of each are made in parallel and appended in order. Then the slices of glossy
  /// nodes that stand among others, eight of these to a block as well.
  void fill() {
    const std::size_t slots = transfer_.basis.slots();
    for (std::size_t begin = 0; begin < slots && !task_.cancelled(); begin += rows_a_report) {
      const std::size_t end = std::min(slots, begin + rows_a_report);
      fill_section(begin, end,
                   [&](std::size_t first, std::size_t last, TransferRows& maker) { return make_block(first, last, maker); });
      task_.progress("transfer", 0.12 + 0.85 * static_cast<double>(end) / static_cast<double>(slots));
    }
    if (transfer_.harmonic_slices.empty()) return;
    const std::size_t glossy = transfer_.glossy_slots.size();
    for (std::size_t begin = transfer_.harmonic_slices.front().rows(); begin < glossy && !task_.cancelled();
         begin += rows_a_report)
      fill_section(begin, std::min(glossy, begin + rows_a_report),
                   [&](std::size_t first, std::size_t last, TransferRows& maker) { return make_slices(first, last, maker); });
  }

 private:
  /// A block of the matrix, and one of every slice where all its nodes are glossy; or those of the slices alone.
  struct Made {
    std::optional<TransferMatrix::Section> irradiance;
    std::vector<TransferMatrix::Section> slices;
  };

  template <class MakeBlock>
  void fill_section(std::size_t begin, std::size_t end, const MakeBlock& make) {
    std::vector<std::unique_ptr<Made>> made(chunk_count(end - begin, block_rows));
    task_.parallel_chunks(end - begin, block_rows, [&](const ChunkRange& range) {
      makers_.use([&](TransferRows& maker) {
        made[range.chunk] = std::make_unique<Made>(make(begin + range.begin, begin + range.end, maker));
      });
    });
    for (const auto& block : made) {
      if (!block) continue;  // cancelled
      if (block->irradiance) transfer_.one_bounce.append(*block->irradiance);
      for (std::size_t k = 0; k < block->slices.size(); ++k) transfer_.harmonic_slices[k].append(block->slices[k]);
    }
  }

  Made make_block(std::size_t begin, std::size_t end, TransferRows& maker) {
    RayStream stream = task_.rays(world_);
    const std::span nodes = std::span(transfer_.node_of_slot).subspan(begin, end - begin);
    Made made{TransferMatrix::Section(transfer_.one_bounce), {}};
    if (is_whole_block_of_glossy(transfer_.glossy_row, begin, end)) {
      const std::vector<std::vector<float>> rows = maker.with_harmonics(nodes, stream);
      made.irradiance->add_block(rows.front());
      add_slices(rows, made);
      return made;
    }
    std::vector<float> rows(nodes.size() * transfer_.basis.columns());
    maker.irradiance(nodes, stream, rows);
    made.irradiance->add_block(rows);
    return made;
  }

  /// Of rows [begin, end) of the slices.
  Made make_slices(std::size_t begin, std::size_t end, TransferRows& maker) {
    RayStream stream = task_.rays(world_);
    std::vector<std::uint32_t> nodes;
    for (std::size_t row = begin; row < end; ++row) nodes.push_back(transfer_.node_of_slot[transfer_.glossy_slots[row]]);
    Made made;
    add_slices(maker.with_harmonics(nodes, stream), made);
    return made;
  }

  void add_slices(const std::vector<std::vector<float>>& rows, Made& made) const {
    for (std::size_t k = 0; k < transfer_.harmonic_slices.size(); ++k)
      made.slices.emplace_back(transfer_.harmonic_slices[k]).add_block(rows[1 + k]);
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
