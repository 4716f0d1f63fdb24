#include "methods/spectral/transfer_making.h"

#include <fmt/format.h>

#include <algorithm>

#include "methods/spectral/all_bounces.h"
#include "methods/spectral/basis_making.h"
#include "methods/spectral/slot_order.h"
#include "methods/spectral/transfer_filling.h"
#include "methods/spectral/transfer_pilots.h"
#include "methods/spectral/trial_lights.h"

namespace gibench::spectral {

namespace {

void make_mesh(const World& world, const Settings& settings, bool occlusion, Transfer& transfer, Task& task) {
  const SamplingMeshOptions options{edge_length_for(world, settings.vertices), static_cast<float>(settings.crease_degrees)};
  transfer.mesh = std::make_unique<SamplingMesh>(world, options);
  SamplingMesh& mesh = *transfer.mesh;
  task.count("vertices", mesh.vertices().size());
  if (mesh.refused_faces() > 0) task.count("non_manifold_faces", mesh.refused_faces());
  task.progress("sampling mesh", 0.02);
  transfer.interpolation = occlusion ? Interpolation(world, mesh, task) : Interpolation(mesh);
}

/// The basis of the transfer's mesh, and with it the order of the slots.
void make_slots(const Settings& settings, TransferMaking& making, Task& task) {
  Transfer& transfer = making.transfer;
  const SurfaceGraph graph = make_graph(*transfer.mesh, transfer.interpolation);
  Partition partition = partition_mesh(graph, static_cast<std::uint32_t>(settings.part_vertices));
  put_neighbours_together(*transfer.mesh, block_rows, partition);
  task.progress("partition", 0.04);
  BasisMaking made = make_basis(graph, partition, share_out(partition, static_cast<std::uint32_t>(settings.basis_functions)),
                                settings.laplacian, task);
  if (!made.failure.empty()) {
    making.termination = Termination::not_converged;
    making.message = made.failure;
    return;
  }
  transfer.basis = std::move(made.basis);
  transfer.slot_of_vertex.resize(graph.size());
  for (std::uint32_t slot = 0; slot < partition.order.size(); ++slot) transfer.slot_of_vertex[partition.order[slot]] = slot;
  transfer.vertex_of_slot = std::move(partition.order);
  if (static_cast<std::size_t>(settings.basis_functions) > graph.size())
    making.message = fmt::format("{} basis functions asked for, {} vertices: the basis is complete with one per vertex",
                                 settings.basis_functions, graph.size());
  task.count("parts", transfer.basis.parts().size());
  task.count("basis_functions", transfer.basis.functions());
  task.count("basis_bytes", transfer.basis.bytes());
  task.count("dense_parts", made.dense_parts);
  task.count("eigenvector_retries", made.failed_attempts);
  task.progress("basis", 0.1);
}

void find_glossy_slots(const std::vector<bool>& glossy_objects, Transfer& transfer, Task& task) {
  transfer.glossy_row.assign(transfer.basis.slots(), Transfer::no_row);
  if (glossy_objects.empty()) return;
  for (std::uint32_t slot = 0; slot < transfer.basis.slots(); ++slot) {
    if (!glossy_objects[transfer.mesh->vertices()[transfer.vertex_of_slot[slot]].object]) continue;
    transfer.glossy_row[slot] = static_cast<std::uint32_t>(transfer.glossy_slots.size());
    transfer.glossy_slots.push_back(slot);
  }
  task.count("glossy_vertices", transfer.glossy_slots.size());
}

/// The indirect light to expect of the direct light, its share: ā + ā² + … of the mean albedo.
float ambient(const SamplingMesh& mesh, std::span<const Rgb4> reflectance_of_object) {
  constexpr double most_albedo = 0.9;
  double reflected = 0.0, area = 0.0;
  if (reflectance_of_object.empty()) return 0.0F;
  for (const MeshVertex& vertex : mesh.vertices()) {
    const auto share = static_cast<double>(vertex.area);
    reflected += share * static_cast<double>(pi * luminance(Rgb(reflectance_of_object[vertex.object])));
    area += share;
  }
  const double albedo = std::min(most_albedo, reflected / area);
  return static_cast<float>(albedo / (1.0 - albedo));
}

/// Mode fixed_albedo: all bounces in one matrix, in place of that of one bounce unless harmonic slices need it.
void fold_bounces(const Settings& settings, const TransferWish& wish, const TrialLights& lights, Transfer& transfer, Task& task) {
  std::vector<Rgb4> reflectance;
  std::vector<double> areas;
  for (std::size_t slot = 0; slot < transfer.vertex_of_slot.size(); ++slot) {
    reflectance.push_back(wish.reflectance[transfer.mesh->vertices()[transfer.vertex_of_slot[slot]].object]);
    areas.push_back(transfer.area_of(slot));
  }
  transfer.all_bounces = all_bounces(transfer.basis, transfer.one_bounce, reflectance, areas, wish.most_bounces, lights,
                                     settings.compression_error, task);
  if (transfer.harmonic_slices.empty()) transfer.one_bounce = TransferMatrix();
}

void count_matrices(const Transfer& transfer, Task& task) {
  std::uint64_t coefficients = transfer.one_bounce.coefficients(), bytes = transfer.one_bounce.bytes();
  for (const auto* matrices : {&transfer.all_bounces, &transfer.harmonic_slices})
    for (const TransferMatrix& matrix : *matrices) coefficients += matrix.coefficients(), bytes += matrix.bytes();
  task.count("coefficients", coefficients);
  task.count("coefficients_per_vertex", coefficients / std::max<std::uint64_t>(1, transfer.basis.slots()));
  task.count("matrix_bytes", bytes);
}

void make_matrices(const World& world, const Settings& settings, const TransferWish& wish, Transfer& transfer, Task& task) {
  find_glossy_slots(wish.glossy_objects, transfer, task);
  const VertexRays rays = rays_of(world, transfer, settings.rays, task.seed());
  Truncation truncation;
  TrialLights lights;
  if (settings.compression_error > 0.0) {
    lights = trial_lights(world, *transfer.mesh, transfer.basis, transfer.vertex_of_slot, wish.occlusion, task);
    const TrialLights tried = with_ambient(lights, transfer.basis, ambient(*transfer.mesh, wish.reflectance));
    truncation = choose_truncation(transfer.basis, tried, pilot_rows(world, transfer, rays, settings.rays, task),
                                   settings.compression_error, task);
  }
  task.progress("truncation", 0.12);
  fill_matrices(world, rays, truncation, transfer, task);
  if (task.cancelled()) return;
  if (settings.mode == Mode::fixed_albedo) fold_bounces(settings, wish, lights, transfer, task);
  count_matrices(transfer, task);
  task.progress("transfer", 1.0);
}

}  // namespace

TransferMaking make_transfer(const World& world, const Settings& settings, const TransferWish& wish, Task& task) {
  TransferMaking making;
  make_mesh(world, settings, wish.occlusion, making.transfer, task);
  if (!task.cancelled()) make_slots(settings, making, task);
  if (!task.cancelled() && succeeded(making.termination)) make_matrices(world, settings, wish, making.transfer, task);
  return making;
}

}  // namespace gibench::spectral
