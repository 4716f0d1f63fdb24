#include "methods/spectral/transfer.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/core/random.h"
#include "methods/spectral/all_bounces.h"
#include "methods/spectral/compression.h"
#include "methods/spectral/slot_order.h"
#include "methods/spectral/transfer_rows.h"
#include "methods/spectral/trial_lights.h"

namespace gibench::spectral {

namespace {

constexpr std::size_t rows_a_report = 256 * block_rows;  // vertices between two signs of progress
constexpr int fewer_pilot_rays = 4;                      // times fewer, where rows are made again
constexpr std::uint64_t pilot_stage = 0x70696c6f74ULL;

class TransferMaker {
 public:
  TransferMaker(const World& world, const Settings& settings, const TransferWish& wish, Task& task)
      : world_(world), settings_(settings), wish_(wish), task_(task) {}

  TransferMaking make() {
    make_mesh();
    if (!task_.cancelled()) make_basis();
    if (!task_.cancelled() && succeeded(making_.termination)) make_matrices();
    return std::move(making_);
  }

 private:
  Transfer& transfer() { return making_.transfer; }

  void make_mesh() {
    const SamplingMeshOptions options{edge_length_for(world_, settings_.vertices), static_cast<float>(settings_.crease_degrees)};
    transfer().mesh = std::make_unique<SamplingMesh>(world_, options);
    task_.count("vertices", transfer().mesh->vertices().size());
    if (transfer().mesh->refused_faces() > 0) task_.count("non_manifold_faces", transfer().mesh->refused_faces());
    task_.progress("sampling mesh", 0.02);
    SamplingMesh& mesh = *transfer().mesh;
    transfer().interpolation = wish_.occlusion ? Interpolation(world_, mesh, task_) : Interpolation(mesh);
  }

  void make_basis() {
    const SurfaceGraph graph = make_graph(*transfer().mesh, transfer().interpolation);
    Partition partition = partition_mesh(graph, static_cast<std::uint32_t>(settings_.part_vertices));
    put_neighbours_together(*transfer().mesh, block_rows, partition);
    task_.progress("partition", 0.04);
    BasisMaking made =
        BasisMaking::make(graph, partition, share_out(partition, static_cast<std::uint32_t>(settings_.basis_functions)),
                          settings_.laplacian, task_);
    if (!made.failure.empty()) {
      making_.termination = Termination::not_converged;
      making_.message = made.failure;
      return;
    }
    transfer().basis = std::move(made.basis);
    transfer().slot_of_vertex.resize(graph.size());
    for (std::uint32_t slot = 0; slot < partition.order.size(); ++slot) transfer().slot_of_vertex[partition.order[slot]] = slot;
    transfer().vertex_of_slot = std::move(partition.order);
    if (static_cast<std::size_t>(settings_.basis_functions) > graph.size())
      making_.message = fmt::format("{} basis functions asked for, {} vertices: the basis is complete with one a vertex",
                                    settings_.basis_functions, graph.size());
    task_.count("parts", transfer().basis.parts().size());
    task_.count("basis_functions", transfer().basis.functions());
    task_.count("basis_bytes", transfer().basis.bytes());
    task_.count("dense_parts", made.dense_parts);
    task_.count("eigenvector_retries", made.failed_attempts);
    task_.progress("basis", 0.1);
  }

  void make_matrices() {
    find_glossy_slots();
    const VertexRays rays = rays_of(task_.seed(), settings_.rays);
    Truncation truncation;
    TrialLights lights;
    if (settings_.compression_error > 0.0) {
      lights = trial_lights(world_, *transfer().mesh, transfer().basis, transfer().vertex_of_slot, wish_.occlusion, task_);
      truncation = choose_truncation(transfer().basis, with_ambient(lights, transfer().basis, ambient()), pilots(rays),
                                     settings_.compression_error, task_);
    }
    task_.progress("truncation", 0.12);
    fill(rays, truncation);
    if (task_.cancelled()) return;
    if (settings_.mode == Mode::fixed_albedo) fold_bounces(lights);
    std::uint64_t coefficients = transfer().one_bounce.coefficients(), bytes = transfer().one_bounce.bytes();
    for (const auto* matrices : {&transfer().all_bounces, &transfer().harmonic_slices})
      for (const TransferMatrix& matrix : *matrices) coefficients += matrix.coefficients(), bytes += matrix.bytes();
    task_.count("coefficients", coefficients);
    task_.count("coefficients_per_vertex", coefficients / std::max<std::uint64_t>(1, transfer().basis.slots()));
    task_.count("matrix_bytes", bytes);
    task_.progress("transfer", 1.0);
  }

  /// The indirect light to expect of the direct light, its share: ā + ā² + … of the mean albedo.
  float ambient() const {
    constexpr double most_albedo = 0.9;
    double reflected = 0.0, area = 0.0;
    if (wish_.reflectance.empty()) return 0.0F;
    for (const MeshVertex& vertex : making_.transfer.mesh->vertices()) {
      const auto share = static_cast<double>(vertex.area);
      reflected += share * static_cast<double>(pi * luminance(Rgb(wish_.reflectance[vertex.object])));
      area += share;
    }
    const double albedo = std::min(most_albedo, reflected / area);
    return static_cast<float>(albedo / (1.0 - albedo));
  }

  void find_glossy_slots() {
    transfer().glossy_row.assign(transfer().basis.slots(), Transfer::no_row);
    if (wish_.glossy_objects.empty()) return;
    for (std::uint32_t slot = 0; slot < transfer().basis.slots(); ++slot) {
      if (!wish_.glossy_objects[transfer().mesh->vertices()[transfer().vertex_of_slot[slot]].object]) continue;
      transfer().glossy_row[slot] = static_cast<std::uint32_t>(transfer().glossy_slots.size());
      transfer().glossy_slots.push_back(slot);
    }
    task_.count("glossy_vertices", transfer().glossy_slots.size());
  }

  VertexRays rays_of(std::uint64_t seed, int rays) const {
    return {world_, *making_.transfer.mesh, making_.transfer.interpolation, making_.transfer.slot_of_vertex, rays, seed};
  }

  double area_of(std::size_t slot) const {
    return static_cast<double>(making_.transfer.mesh->vertices()[making_.transfer.vertex_of_slot[slot]].area);
  }

  std::vector<PilotBlock> pilots(const VertexRays& rays) {
    const std::size_t slots = transfer().basis.slots(), columns = transfer().basis.columns();
    const int fewer = std::max(1, settings_.rays / fewer_pilot_rays);
    const VertexRays others[2] = {rays_of(mix_keys(task_.seed(), pilot_stage, 0), fewer),
                                  rays_of(mix_keys(task_.seed(), pilot_stage, 1), fewer)};
    const std::vector<std::size_t> chosen = pilot_blocks(chunk_count(slots, block_rows));
    std::vector<PilotBlock> pilots(chosen.size());
    task_.parallel_chunks(chosen.size(), 1, [&](const ChunkRange& range) {
      RayStream stream = task_.rays(world_);
      PilotBlock& pilot = pilots[range.begin];
      const std::size_t begin = chosen[range.begin] * block_rows, end = std::min(slots, begin + block_rows);
      for (std::size_t slot = begin; slot < end; ++slot) pilot.areas.push_back(area_of(slot));
      const auto fill = [&](const VertexRays& by, std::vector<float>& rows) {
        TransferRows maker(transfer().basis, by);
        rows.resize((end - begin) * columns);
        maker.irradiance(std::span(transfer().vertex_of_slot).subspan(begin, end - begin), stream, rows);
      };
      fill(rays, pilot.rows);
      for (std::size_t i = 0; i < 2; ++i) fill(others[i], pilot.others[i]);
    });
    return pilots;
  }

  /// All rows, section by section; the blocks of each are made in parallel and appended in order.
  void fill(const VertexRays& rays, const Truncation& truncation) {
    const std::size_t slots = transfer().basis.slots();
    const std::vector<float> constant = transfer().basis.constant();
    transfer().one_bounce = TransferMatrix(truncation, constant);
    if (!transfer().glossy_slots.empty())
      transfer().harmonic_slices.assign(harmonic_count - 1, TransferMatrix(truncation, constant));
    for (std::size_t begin = 0; begin < slots && !task_.cancelled(); begin += rows_a_report) {
      fill_section(rays, begin, std::min(slots, begin + rows_a_report));
      task_.progress("transfer",
                     0.12 + 0.85 * static_cast<double>(std::min(slots, begin + rows_a_report)) / static_cast<double>(slots));
    }
  }

  /// A block of the matrix, and one of every slice if any of its vertices is glossy.
  struct Made {
    TransferMatrix::Section irradiance;
    std::vector<TransferMatrix::Section> slices;
  };

  void fill_section(const VertexRays& rays, std::size_t begin, std::size_t end) {
    std::vector<std::unique_ptr<Made>> made(chunk_count(end - begin, block_rows));
    task_.parallel_chunks(end - begin, block_rows, [&](const ChunkRange& range) {
      made[range.chunk] = std::make_unique<Made>(make_block(rays, begin + range.begin, begin + range.end));
    });
    for (const auto& block : made) {
      if (!block) continue;  // cancelled
      transfer().one_bounce.append(block->irradiance);
      for (std::size_t k = 0; k < block->slices.size(); ++k) transfer().harmonic_slices[k].append(block->slices[k]);
    }
  }

  Made make_block(const VertexRays& rays, std::size_t begin, std::size_t end) {
    const std::size_t columns = transfer().basis.columns(), slices = transfer().harmonic_slices.size();
    RayStream stream = task_.rays(world_);
    TransferRows maker(transfer().basis, rays);
    const std::span vertices = std::span(transfer().vertex_of_slot).subspan(begin, end - begin);
    const std::span glossy_rows = std::span(transfer().glossy_row).subspan(begin, end - begin);
    std::vector<std::vector<float>> rows(1 + slices);  // of the irradiance and of every slice, one behind the other
    rows.front().resize(vertices.size() * columns);
    if (std::all_of(glossy_rows.begin(), glossy_rows.end(), [](std::uint32_t row) { return row == Transfer::no_row; }))
      maker.irradiance(vertices, stream, rows.front());
    else make_glossy_rows(maker, vertices, glossy_rows, stream, rows);
    Made made{TransferMatrix::Section(transfer().one_bounce), {}};
    made.irradiance.add_block(rows.front());
    for (std::size_t k = 0; k < slices; ++k) {
      made.slices.emplace_back(transfer().harmonic_slices[k]);
      if (!rows[1 + k].empty()) made.slices.back().add_block(rows[1 + k]);
    }
    return made;
  }

  /// One vertex after the other: those without gloss have no rows in the slices.
  static void make_glossy_rows(TransferRows& maker, std::span<const std::uint32_t> vertices,
                               std::span<const std::uint32_t> glossy_rows, RayStream& stream,
                               std::vector<std::vector<float>>& rows) {
    const std::size_t columns = rows.front().size() / vertices.size();
    std::vector<float> all(columns * rows.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const std::span<float> irradiance = std::span(rows.front()).subspan(i * columns, columns);
      if (glossy_rows[i] == Transfer::no_row) {
        maker.irradiance(vertices[i], stream, irradiance);
        continue;
      }
      maker.with_harmonics(vertices[i], stream, all);
      std::copy_n(all.begin(), columns, irradiance.begin());
      for (std::size_t k = 1; k < rows.size(); ++k) {
        const std::span<float> row = std::span(all).subspan(k * columns, columns);
        rows[k].insert(rows[k].end(), row.begin(), row.end());
      }
    }
  }

  void fold_bounces(const TrialLights& lights) {
    std::vector<Rgb4> reflectance;
    std::vector<double> areas;
    for (const std::uint32_t vertex : transfer().vertex_of_slot) {
      reflectance.push_back(wish_.reflectance[transfer().mesh->vertices()[vertex].object]);
    }
    for (std::size_t slot = 0; slot < reflectance.size(); ++slot) areas.push_back(area_of(slot));
    transfer().all_bounces = all_bounces(transfer().basis, transfer().one_bounce, reflectance, areas, wish_.most_bounces, lights,
                                         settings_.compression_error, task_);
    if (transfer().harmonic_slices.empty()) transfer().one_bounce = TransferMatrix();
  }

  const World& world_;
  const Settings& settings_;
  const TransferWish& wish_;
  Task& task_;
  TransferMaking making_;
};

}  // namespace

TransferMaking make_transfer(const World& world, const Settings& settings, const TransferWish& wish, Task& task) {
  return TransferMaker(world, settings, wish, task).make();
}

std::size_t Transfer::bytes() const {
  if (!mesh) return 0;
  std::size_t bytes =
      mesh->bytes() + interpolation.bytes() + basis.bytes() + one_bounce.bytes() +
      (vertex_of_slot.size() + slot_of_vertex.size() + glossy_slots.size() + glossy_row.size()) * sizeof(std::uint32_t);
  for (const TransferMatrix& matrix : all_bounces) bytes += matrix.bytes();
  for (const TransferMatrix& matrix : harmonic_slices) bytes += matrix.bytes();
  return bytes;
}

}  // namespace gibench::spectral
