#include "methods/spectral/transfer_pilots.h"

#include <algorithm>

#include "common/core/random.h"
#include "methods/spectral/transfer_rows.h"

namespace gibench::spectral {

namespace {

constexpr int fewer_pilot_rays = 4;  // times fewer, where rows are made again
constexpr std::uint64_t pilot_stage = 0x70696c6f74ULL;

}  // namespace

std::vector<PilotBlock> pilot_rows(const World& world, const Transfer& transfer, const VertexRays& rays, int ray_count,
                                   Task& task) {
  const std::size_t slots = transfer.basis.slots(), columns = transfer.basis.columns();
  const int fewer = std::max(1, ray_count / fewer_pilot_rays);
  const VertexRays others[2] = {rays_of(world, transfer, fewer, mix_keys(task.seed(), pilot_stage, 0)),
                                rays_of(world, transfer, fewer, mix_keys(task.seed(), pilot_stage, 1))};
  const std::vector<std::size_t> chosen = pilot_blocks(chunk_count(slots, block_rows));
  std::vector<PilotBlock> pilots(chosen.size());
  task.parallel_chunks(chosen.size(), 1, [&](const ChunkRange& range) {
    RayStream stream = task.rays(world);
    PilotBlock& pilot = pilots[range.begin];
    const std::size_t begin = chosen[range.begin] * block_rows, end = std::min(slots, begin + block_rows);
    for (std::size_t slot = begin; slot < end; ++slot) pilot.areas.push_back(transfer.area_of(slot));
    const auto fill = [&](const VertexRays& by, std::vector<float>& rows) {
      TransferRows maker(transfer.basis, by);
      rows.resize((end - begin) * columns);
      maker.irradiance(std::span(transfer.vertex_of_slot).subspan(begin, end - begin), stream, rows);
    };
    fill(rays, pilot.rows);
    for (std::size_t i = 0; i < 2; ++i) fill(others[i], pilot.others[i]);
  });
  return pilots;
}

}  // namespace gibench::spectral
