#include "methods/spectral/transfer_pilots.h"

#include <algorithm>
#include <functional>

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

/// The nodes of some glossy slots.
std::vector<std::uint32_t> nodes_of(const Transfer& transfer, std::span<const std::uint32_t> slots) {
  std::vector<std::uint32_t> nodes;
  for (const std::uint32_t slot : slots) nodes.push_back(transfer.node_of_slot[slot]);
  return nodes;
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
  const std::size_t glossy = transfer.glossy_slots.size();
  const std::vector<std::size_t> chosen = pilot_blocks(chunk_count(glossy, block_rows), most_glossy_pilots);
  std::vector<PilotBlock> pilots(chosen.size() * slices);
  task.parallel_chunks(chosen.size(), 1, [&](const ChunkRange& range) {
    RayStream stream = task.rays(world);
    const std::size_t begin = chosen[range.begin] * block_rows;
    const std::span slots = std::span(transfer.glossy_slots).subspan(begin, std::min(block_rows, glossy - begin));
    const std::vector<std::uint32_t> nodes = nodes_of(transfer, slots);
    PilotBlock* const made = &pilots[range.begin * slices];
    for (std::size_t k = 0; k < slices; ++k)
      for (const std::uint32_t slot : slots) made[k].areas.push_back(static_cast<double>(transfer.node_at(slot).area));
    const auto fill = [&](const VertexRays& by, const std::function<std::vector<float>&(PilotBlock&)>& rows_of) {
      std::vector<std::vector<float>> rows = TransferRows(transfer.basis, by).with_harmonics(nodes, stream);
      for (std::size_t k = 0; k < slices; ++k) rows_of(made[k]) = std::move(rows[1 + k]);
    };
    fill(sets.own, [](PilotBlock& pilot) -> std::vector<float>& { return pilot.rows; });
    for (std::size_t i = 0; i < 2; ++i)
      fill(sets.others[i], [i](PilotBlock& pilot) -> std::vector<float>& { return pilot.others[i]; });
  });
  return pilots;
}

}  // namespace gibench::spectral
