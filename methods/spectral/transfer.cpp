#include "methods/spectral/transfer.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/core/random.h"
#include "methods/spectral/all_bounces.h"
#include "methods/spectral/compression.h"
#include "methods/spectral/transfer_rows.h"

namespace gibench::spectral {

namespace {

constexpr std::size_t row_chunk = 8;         // vertices
constexpr std::size_t rows_a_report = 2048;  // vertices between two signs of progress
constexpr std::size_t pilot_rows = 256;
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
    const VertexRays rays = rays_of(task_.seed());
    std::vector<float> steps;
    const bool compressed = settings_.compression_error > 0.0;
    std::vector<std::vector<Rgb4>> lights;
    if (compressed) {
      lights = trial_lights(world_, *transfer().mesh, transfer().basis, transfer().vertex_of_slot, wish_.occlusion, task_);
      steps = choose_steps(transfer().basis, with_ambient(lights, transfer().basis, ambient()), pilot(rays),
                           settings_.compression_error);
    }
    task_.progress("steps", 0.12);
    fill(rays, steps);
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

  VertexRays rays_of(std::uint64_t seed) const {
    return {world_, *making_.transfer.mesh, making_.transfer.interpolation, making_.transfer.slot_of_vertex, settings_.rays,
            seed};
  }

  std::vector<PilotRow> pilot(const VertexRays& rays) {
    const std::size_t slots = transfer().basis.slots(), count = std::min(pilot_rows, slots), columns = transfer().basis.columns();
    const VertexRays others[2] = {rays_of(mix_keys(task_.seed(), pilot_stage, 0)),
                                  rays_of(mix_keys(task_.seed(), pilot_stage, 1))};
    std::vector<PilotRow> rows(count);
    for (PilotRow& row : rows)
      for (auto* values : {&row.values, &row.others[0], &row.others[1]}) values->resize(columns, 0.0F);
    task_.parallel_chunks(count, row_chunk, [&](const ChunkRange& range) {
      RayStream stream = task_.rays(world_);
      TransferRows own(transfer().basis, rays), first(transfer().basis, others[0]), second(transfer().basis, others[1]);
      for (std::size_t i = range.begin; i < range.end; ++i) {
        const std::uint32_t vertex = transfer().vertex_of_slot[(2 * i + 1) * slots / (2 * count)];
        rows[i].area = static_cast<double>(transfer().mesh->vertices()[vertex].area);
        own.irradiance(vertex, stream, rows[i].values);
        first.irradiance(vertex, stream, rows[i].others[0]);
        second.irradiance(vertex, stream, rows[i].others[1]);
      }
    });
    return rows;
  }

  /// All rows, block by block; each block's are made in parallel and appended in order.
  void fill(const VertexRays& rays, const std::vector<float>& steps) {
    const std::size_t slots = transfer().basis.slots();
    const std::vector<float> constant = transfer().basis.constant();
    transfer().one_bounce = TransferMatrix(steps, constant);
    if (!transfer().glossy_slots.empty()) transfer().harmonic_slices.assign(harmonic_count - 1, TransferMatrix(steps, constant));
    for (std::size_t begin = 0; begin < slots && !task_.cancelled(); begin += rows_a_report) {
      fill_block(rays, begin, std::min(slots, begin + rows_a_report));
      task_.progress("transfer",
                     0.12 + 0.85 * static_cast<double>(std::min(slots, begin + rows_a_report)) / static_cast<double>(slots));
    }
  }

  void fill_block(const VertexRays& rays, std::size_t begin, std::size_t end) {
    struct Made {
      TransferMatrix::Block irradiance;
      std::vector<TransferMatrix::Block> slices;
    };
    const std::size_t columns = transfer().basis.columns();
    std::vector<std::unique_ptr<Made>> made(chunk_count(end - begin, row_chunk));
    task_.parallel_chunks(end - begin, row_chunk, [&](const ChunkRange& range) {
      RayStream stream = task_.rays(world_);
      TransferRows maker(transfer().basis, rays);
      auto& chunk = made[range.chunk] = std::make_unique<Made>(Made{TransferMatrix::Block(transfer().one_bounce), {}});
      for (const TransferMatrix& slice : transfer().harmonic_slices) chunk->slices.emplace_back(slice);
      const std::span vertices = std::span(transfer().vertex_of_slot).subspan(begin + range.begin, range.end - range.begin);
      std::vector<float> rows(columns * (transfer().harmonic_slices.empty() ? row_chunk : harmonic_count));
      if (transfer().harmonic_slices.empty()) {
        maker.irradiance(vertices, stream, rows);
        for (std::size_t i = 0; i < vertices.size(); ++i)
          chunk->irradiance.add_row(std::span(rows).subspan(i * columns, columns));
        return;
      }
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (transfer().glossy_row[begin + range.begin + i] == Transfer::no_row) {
          maker.irradiance(vertices[i], stream, std::span(rows).first(columns));
        } else {
          maker.with_harmonics(vertices[i], stream, rows);
          for (std::size_t k = 1; k < harmonic_count; ++k)
            chunk->slices[k - 1].add_row(std::span(rows).subspan(k * columns, columns));
        }
        chunk->irradiance.add_row(std::span(rows).first(columns));
      }
    });
    for (const auto& chunk : made) {
      if (!chunk) continue;  // cancelled
      transfer().one_bounce.append(chunk->irradiance);
      for (std::size_t k = 0; k < chunk->slices.size(); ++k) transfer().harmonic_slices[k].append(chunk->slices[k]);
    }
  }

  void fold_bounces(const std::vector<std::vector<Rgb4>>& lights) {
    std::vector<Rgb4> reflectance;
    std::vector<double> areas;
    for (const std::uint32_t vertex : transfer().vertex_of_slot) {
      reflectance.push_back(wish_.reflectance[transfer().mesh->vertices()[vertex].object]);
      areas.push_back(static_cast<double>(transfer().mesh->vertices()[vertex].area));
    }
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
