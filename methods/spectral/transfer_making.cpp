#include "methods/spectral/transfer_making.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "methods/spectral/all_bounces.h"
#include "methods/spectral/basis_making.h"
#include "methods/spectral/needs.h"
#include "methods/spectral/node_making.h"
#include "methods/spectral/slot_order.h"
#include "methods/spectral/transfer_filling.h"
#include "methods/spectral/transfer_pilots.h"
#include "methods/spectral/trial_lights.h"

namespace gibench::spectral {

namespace {

constexpr std::size_t many_vertices = 2;      // times as many as wanted: from there on they come together in clusters
constexpr float small_triangles = 0.5F;       // of the longest edge wanted: what has none of that length is looked at by clusters
constexpr std::size_t functions_a_piece = 8;  // that loose pieces are joined down to have
constexpr float first_look = 0.25F;           // of the longest edge: where a piece begins to look for another

/// Mesh, nodes and their graph.
class MeshMaking {
 public:
  /// Sets what the settings leave open.
  MeshMaking(const World& world, Settings& settings, bool occlusion, Transfer& transfer, Task& task)
      : world_(world), settings_(settings), occlusion_(occlusion), transfer_(transfer), task_(task) {
    settle_vertices(world.scene().triangles.size(), settings);
  }

  SurfaceGraph make() {
    if (may_cluster()) light_.emplace(world_, task_);
    if (task_.cancelled()) return {};
    const double edge = edge_length();
    transfer_.mesh =
        std::make_unique<SamplingMesh>(world_, SamplingMeshOptions{edge, static_cast<float>(settings_.crease_degrees)});
    SamplingMesh& mesh = *transfer_.mesh;
    task_.count("vertices", mesh.vertices().size());
    if (mesh.refused_faces() > 0) task_.count("non_manifold_faces", mesh.refused_faces());
    task_.progress("sampling mesh", 0.02);
    const auto wanted = static_cast<std::size_t>(settings_.vertices);
    const bool clusters = light_ && mesh.vertices().size() > many_vertices * wanted;
    const float smallest = clusters ? small_triangles * static_cast<float>(edge) : 0.0F;
    transfer_.interpolation = occlusion_ ? Interpolation(world_, mesh, smallest, task_) : Interpolation(mesh);
    task_.count("cut_triangles", transfer_.interpolation.torn_triangles());
    if (task_.cancelled()) return {};
    transfer_.nodes = clusters ? cluster_vertices(world_, mesh, transfer_.interpolation, *light_, wanted, task_) : Nodes(mesh);
    if (clusters) task_.count("clusters", transfer_.nodes.size());
    settle_basis(transfer_.nodes, settings_);
    SurfaceGraph graph = graph_of(world_, mesh, transfer_.interpolation, transfer_.nodes, task_);
    if (settings_.nodes == NodeKind::clusters && occlusion_)
      join_pieces(world_, mesh, transfer_.nodes,
                  std::max<std::size_t>(1, static_cast<std::size_t>(settings_.basis_functions) / functions_a_piece),
                  first_look * static_cast<float>(edge), graph, task_);
    transfer_.weights = NodeWeights(world_, mesh, transfer_.nodes, graph, task_);
    task_.progress("nodes", 0.03);
    return graph;
  }

 private:
  bool may_cluster() const {
    return settings_.nodes == NodeKind::clusters && occlusion_ &&
           world_.scene().triangles.size() > many_vertices * static_cast<std::size_t>(settings_.vertices);
  }

  /// Where light is known not to reach all surfaces, by the area of those that it reaches.
  double edge_length() const {
    const double whole = edge_length_for(world_, settings_.vertices);
    if (!light_) return whole;
    double area = 0.0;
    for (std::uint32_t t = 0; t < world_.scene().triangles.size(); ++t)
      if (light_->is_reached(t, true) || light_->is_reached(t, false)) area += static_cast<double>(world_.area(t));
    return area > 0.0 ? whole * std::sqrt(area / world_.total_area()) : whole;
  }

  const World& world_;
  Settings& settings_;
  bool occlusion_;
  Transfer& transfer_;
  Task& task_;
  std::optional<SideLight> light_;  // where the scene may be finer than wanted
};

/// The basis over the transfer's nodes, and with it the order of the slots.
void make_slots(const SurfaceGraph& graph, const Settings& settings, TransferMaking& making, Task& task) {
  Transfer& transfer = making.transfer;
  Partition partition = partition_mesh(graph, static_cast<std::uint32_t>(settings.part_vertices));
  put_neighbours_together(transfer.nodes, block_rows, partition);
  task.progress("partition", 0.04);
  const std::vector<std::uint32_t> functions =
      share_out(partition, static_cast<std::uint32_t>(settings.basis_functions), transfer.nodes);
  if (const std::uint64_t columns = SpectralBasis::columns_for(functions);
      settings.mode == Mode::fixed_albedo && columns > most_folded_columns) {
    making.termination = Termination::out_of_budget;
    making.message = fmt::format(
        "mode=fixed_albedo inverts a dense matrix of as many rows as the basis has columns, {} at most, here {}; lower "
        "basis_functions or set mode=bounces",
        most_folded_columns, columns);
    return;
  }
  BasisMaking made = make_basis(graph, partition, functions, settings.laplacian, task);
  if (!made.failure.empty()) {
    making.termination = Termination::not_converged;
    making.message = made.failure;
    return;
  }
  transfer.basis = std::move(made.basis);
  std::vector<std::uint32_t> slot_of_node(graph.size());
  for (std::uint32_t slot = 0; slot < partition.order.size(); ++slot) slot_of_node[partition.order[slot]] = slot;
  transfer.weights.renumber(slot_of_node);
  transfer.node_of_slot = std::move(partition.order);
  if (static_cast<std::size_t>(settings.basis_functions) > graph.size())
    making.message = fmt::format("{} basis functions asked for, {} vertices: the basis is complete with one per vertex",
                                 settings.basis_functions, graph.size());
  task.count("parts", transfer.basis.parts().size());
  task.count("basis_functions", transfer.basis.columns());
  task.count("basis_bytes", transfer.basis.bytes());
  task.count("dense_parts", made.dense_parts);
  task.count("eigenvector_retries", made.failed_attempts);
  task.progress("basis", 0.1);
}

/// Slots that stand among others are put in an order in which those of one block of the slices are neighbours.
void find_glossy_slots(const std::vector<bool>& glossy_objects, Transfer& transfer, Task& task) {
  const std::size_t slots = transfer.basis.slots();
  transfer.glossy_row.assign(slots, Transfer::no_row);
  if (glossy_objects.empty()) return;
  for (std::uint32_t slot = 0; slot < slots; ++slot)
    if (glossy_objects[transfer.node_at(slot).object]) transfer.glossy_row[slot] = 0;  // until it is known
  std::vector<std::uint32_t> among_others;
  for (std::uint32_t begin = 0; begin < slots; begin += block_rows) {
    const auto end = static_cast<std::uint32_t>(std::min<std::size_t>(slots, begin + block_rows));
    std::vector<std::uint32_t>& list =
        is_whole_block_of_glossy(transfer.glossy_row, begin, end) ? transfer.glossy_slots : among_others;
    for (std::uint32_t slot = begin; slot < end; ++slot)
      if (transfer.glossy_row[slot] != Transfer::no_row) list.push_back(slot);
  }
  put_neighbours_together(transfer.nodes, block_rows, transfer.node_of_slot, among_others);
  transfer.glossy_slots.insert(transfer.glossy_slots.end(), among_others.begin(), among_others.end());
  for (std::uint32_t row = 0; row < transfer.glossy_slots.size(); ++row) transfer.glossy_row[transfer.glossy_slots[row]] = row;
  task.count("glossy_vertices", transfer.glossy_slots.size());
}

/// The indirect light to expect of the direct light, its share: ā + ā² + … of the mean albedo.
float ambient(const Nodes& nodes, std::span<const Rgb4> reflectance_of_object) {
  constexpr double most_albedo = 0.9;
  double reflected = 0.0, area = 0.0;
  if (reflectance_of_object.empty()) return 0.0F;
  for (std::uint32_t node = 0; node < nodes.size(); ++node) {
    const double share = nodes[node].reached ? static_cast<double>(nodes[node].area) : 0.0;
    reflected += share * static_cast<double>(pi * luminance(Rgb(reflectance_of_object[nodes[node].object])));
    area += share;
  }
  if (!(area > 0.0)) return 0.0F;
  const double albedo = std::min(most_albedo, reflected / area);
  return static_cast<float>(albedo / (1.0 - albedo));
}

/// Mode fixed_albedo: all bounces in one matrix, in place of that of one bounce.
void fold(const TransferWish& wish, const CompressionWish& compression, TransferMaking& making, Task& task) {
  Transfer& transfer = making.transfer;
  std::vector<Rgb4> reflectance;
  std::vector<double> areas;
  for (std::size_t slot = 0; slot < transfer.node_of_slot.size(); ++slot) {
    reflectance.push_back(wish.reflectance[transfer.node_at(slot).object]);
    areas.push_back(static_cast<double>(transfer.node_at(slot).area));
  }
  Folding folding = fold_bounces(transfer.basis, transfer.one_bounce,
                                 {reflectance, areas, wish.most_bounces, !transfer.harmonic_slices.empty()}, compression, task);
  transfer.all_bounces = std::move(folding.irradiance);
  transfer.all_light = std::move(folding.light);
  transfer.one_bounce = TransferMatrix();
  making.termination = folding.termination;
  if (!folding.message.empty()) making.message += (making.message.empty() ? "" : "; ") + folding.message;
}

void count_matrices(const Transfer& transfer, Task& task) {
  std::uint64_t coefficients = transfer.one_bounce.coefficients(), bytes = transfer.one_bounce.bytes();
  for (const auto* matrices : {&transfer.all_bounces, &transfer.harmonic_slices})
    for (const TransferMatrix& matrix : *matrices) coefficients += matrix.coefficients(), bytes += matrix.bytes();
  task.count("coefficients", coefficients);
  task.count("coefficients_per_vertex", coefficients / std::max<std::uint64_t>(1, transfer.basis.slots()));
  task.count("matrix_bytes", bytes);
}

Truncations truncations_for(const World& world, const VertexRays& rays, const Settings& settings,
                            const CompressionWish& compression, const Transfer& transfer, Task& task) {
  Truncations chosen;
  chosen.irradiance = truncation_for(
      compression, transfer.basis, [&] { return pilot_rows(world, transfer, rays, settings.rays, task); }, task);
  if (!transfer.glossy_slots.empty())
    chosen.slices = truncation_for(
        compression, transfer.basis, [&] { return glossy_pilot_rows(world, transfer, rays, settings.rays, task); }, task);
  return chosen;
}

void make_matrices(const World& world, const Settings& settings, const TransferWish& wish, TransferMaking& making, Task& task) {
  Transfer& transfer = making.transfer;
  find_glossy_slots(wish.glossy_objects, transfer, task);
  const VertexRays rays = rays_of(world, transfer, settings.rays, task.seed());
  CompressionWish compression{settings.compression, settings.compression_error, {}}, of_one_bounce = compression;
  if (compression.judged()) {
    compression.lights = trial_lights(world, transfer, wish.occlusion, task);
    of_one_bounce.lights = with_ambient(compression.lights, transfer.basis, ambient(transfer.nodes, wish.reflectance));
    task.progress("trial lights", 0.11);
  }
  const Truncations truncations = truncations_for(world, rays, settings, of_one_bounce, transfer, task);
  task.progress("truncation", 0.12);
  if (task.cancelled()) return;
  fill_matrices(world, rays, truncations, transfer, task);
  if (task.cancelled()) return;
  if (settings.mode == Mode::fixed_albedo) fold(wish, compression, making, task);
  count_matrices(transfer, task);
  task.progress("transfer", 1.0);
}

}  // namespace

TransferMaking make_transfer(const World& world, const Settings& asked, const TransferWish& wish, Task& task) {
  TransferMaking making;
  Settings settings = asked;
  const SurfaceGraph graph = MeshMaking(world, settings, wish.occlusion, making.transfer, task).make();
  if (!task.cancelled()) make_slots(graph, settings, making, task);
  if (!task.cancelled() && succeeded(making.termination)) make_matrices(world, settings, wish, making, task);
  return making;
}

}  // namespace gibench::spectral
