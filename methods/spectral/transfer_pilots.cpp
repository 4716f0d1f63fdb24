#include "methods/spectral/transfer_pilots.h"

#include <algorithm>

#include "common/core/random.h"
#include "methods/spectral/transfer_rows.h"

namespace gibench::spectral {

namespace {

constexpr int fewer_pilot_rays = 4;             // times fewer, where rows are made again
constexpr std::size_t most_glossy_pilots = 16;  // blocks; each holds fifteen times the rows of one of the irradiance
constexpr std::uint64_t pilot_stage = 0x70696c6f74ULL;

/// The matrix's own rays, and two sets of fewer, independent ones.
struct PilotRays {
  const VertexRays& own;
  VertexRays others[2];

  PilotRays(const World& world, const Transfer& transfer, const VertexRays& rays, int ray_count, Task& task)
      : own(rays), others{other(world, transfer, ray_count, task, 0), other(world, transfer, ray_count, task, 1)} {}

 private:
  static VertexRays other(const World& world, const Transfer& transfer, int ray_count, Task& task, std::uint64_t which) {
    return rays_of(world, transfer, std::max(1, ray_count / fewer_pilot_rays), mix_keys(task.seed(), pilot_stage, which));
  }
};

/// The slots of every block of the matrix that has glossy ones: those.
std::vector<std::vector<std::uint32_t>> glossy_blocks(const Transfer& transfer) {
  std::vector<std::vector<std::uint32_t>> blocks;
  std::size_t last = transfer.basis.slots();  // no block's number
  for (const std::uint32_t slot : transfer.glossy_slots) {
    if (blocks.empty() || slot / block_rows != last) blocks.emplace_back();
    last = slot / block_rows;
    blocks.back().push_back(slot);
  }
  return blocks;
}

/// Each slice's rows of some vertices, one behind the other.
void make_slices(const Transfer& transfer, const VertexRays& by, std::span<const std::uint32_t> slots, RayStream& stream,
                 const std::function<std::vector<float>&(std::size_t slice)>& rows_of) {
  const std::size_t columns = transfer.basis.columns();
  TransferRows maker(transfer.basis, by);
  std::vector<float> all(harmonic_count * columns);
  for (const std::uint32_t slot : slots) {
    maker.with_harmonics(transfer.node_of_slot[slot], stream, all);
    for (std::size_t k = 1; k < harmonic_count; ++k) {
      const std::span<const float> row = std::span(all).subspan(k * columns, columns);
      std::vector<float>& rows = rows_of(k - 1);
      rows.insert(rows.end(), row.begin(), row.end());
    }
  }
}

}  // namespace

std::vector<PilotBlock> pilot_rows(const World& world, const Transfer& transfer, const VertexRays& rays, int ray_count,
                                   Task& task) {
  const std::size_t slots = transfer.basis.slots(), columns = transfer.basis.columns();
  const PilotRays sets(world, transfer, rays, ray_count, task);
  const std::vector<std::size_t> chosen = pilot_blocks(chunk_count(slots, block_rows));
  std::vector<PilotBlock> pilots(chosen.size());
  task.parallel_chunks(chosen.size(), 1, [&](const ChunkRange& range) {
    RayStream stream = task.rays(world);
    PilotBlock& pilot = pilots[range.begin];
    const std::size_t begin = chosen[range.begin] * block_rows, end = std::min(slots, begin + block_rows);
    for (std::size_t slot = begin; slot < end; ++slot) pilot.areas.push_back(static_cast<double>(transfer.node_at(slot).area));
    const auto fill = [&](const VertexRays& by, std::vector<float>& rows) {
      TransferRows maker(transfer.basis, by);
      rows.resize((end - begin) * columns);
      maker.irradiance(std::span(transfer.node_of_slot).subspan(begin, end - begin), stream, rows);
    };
    fill(sets.own, pilot.rows);
    for (std::size_t i = 0; i < 2; ++i) fill(sets.others[i], pilot.others[i]);
  });
  return pilots;
}

std::vector<PilotBlock> glossy_pilot_rows(const World& world, const Transfer& transfer, const VertexRays& rays, int ray_count,
                                          Task& task) {
  constexpr std::size_t slices = harmonic_count - 1;
  const PilotRays sets(world, transfer, rays, ray_count, task);
  const std::vector<std::vector<std::uint32_t>> blocks = glossy_blocks(transfer);
  const std::vector<std::size_t> chosen = pilot_blocks(blocks.size(), most_glossy_pilots);
  std::vector<PilotBlock> pilots(chosen.size() * slices);
  task.parallel_chunks(chosen.size(), 1, [&](const ChunkRange& range) {
    RayStream stream = task.rays(world);
    const std::vector<std::uint32_t>& slots = blocks[chosen[range.begin]];
    PilotBlock* const made = &pilots[range.begin * slices];
    for (std::size_t k = 0; k < slices; ++k)
      for (const std::uint32_t slot : slots) made[k].areas.push_back(static_cast<double>(transfer.node_at(slot).area));
    make_slices(transfer, sets.own, slots, stream, [&](std::size_t k) -> std::vector<float>& { return made[k].rows; });
    for (std::size_t i = 0; i < 2; ++i)
      make_slices(transfer, sets.others[i], slots, stream,
                  [&](std::size_t k) -> std::vector<float>& { return made[k].others[i]; });
  });
  return pilots;
}

}  // namespace gibench::spectral
