#include "methods/antiradiance/discretisation.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "methods/antiradiance/bin_transport.h"
#include "methods/antiradiance/element_count.h"
#include "methods/antiradiance/exchange.h"
#include "methods/antiradiance/implicit.h"
#include "methods/antiradiance/link_tracing.h"
#include "methods/antiradiance/near_directions.h"
#include "methods/antiradiance/parted_triangles.h"
#include "methods/antiradiance/refinement.h"
#include "methods/antiradiance/report_message.h"
#include "methods/antiradiance/visibility.h"

namespace gibench::antiradiance {

namespace {

constexpr double coarser = 1.5;  // times, from one oracle to the next
// At the peak, for each of the oracle's links: the table and the blocks it is put together from; with masks also the near
// links' pieces and all links' directions (measured: README.md, Memory).
constexpr double bytes_a_link = 20.0, bytes_a_masked_link = 52.0;
// Tracing: the table before and after; of links that others are taken apart into, that after and a list that grows.
constexpr double bytes_a_traced_link = 16.0, bytes_a_made_link = 32.0;
constexpr int most_attempts = 24;
constexpr float partial_share = 0.25F;  // of the tolerance: for links that other surfaces hide in part
constexpr double krylov_vectors = 8.0;
constexpr double bytes_an_element = 1500.0;      // with all but links and tables (README.md, Memory)
constexpr double bytes_a_merged_vertex = 800.0;  // of a mesh whose vertices share elements, while their cells are cut
constexpr double many_more = 2.0;                // elements than asked for
constexpr int fewest_elements = 64;              // that a memory budget is kept to
constexpr std::size_t most_apart = 64;           // objects whose trees accessibility keeps apart

SamplingMeshOptions mesh_options(const World& world, const Settings& settings) {
  SamplingMeshOptions options;
  // Slivers have length without area: they are not cut into more pieces along it than there are to be elements.
  options.edge_length = std::max(edge_length_for(world, static_cast<double>(settings.elements)),
                                 static_cast<double>(world.diagonal()) / static_cast<double>(settings.elements));
  options.crease_degrees = settings.crease_degrees;
  options.keep_quads = true;
  return options;
}

/// What the scene has of its own, before any face is cut.
struct OwnDetail {
  std::optional<SamplingMesh> mesh;
  std::size_t vertices, corners;
  float longest_edge = 0.0F;  ///< metres

  OwnDetail(const World& world, const Settings& settings) {
    SamplingMeshOptions options;
    options.crease_degrees = settings.crease_degrees;
    options.keep_quads = true;
    mesh.emplace(world, options);
    vertices = mesh->vertices().size(), corners = corner_count(*mesh);
    for (const MeshFace& face : mesh->faces())
      for (std::size_t k = 0; k < face.corners.size(); ++k) {
        const auto at = [&](std::size_t corner) { return mesh->vertices()[face.corners[corner % face.corners.size()]].position; };
        longest_edge = std::max(longest_edge, glm::length(at(k + 1) - at(k)));
      }
  }
};

/// The mesh cut as the settings say: the scene's own, which is taken away, where that is fine enough.
SamplingMesh cut_mesh(const World& world, const Settings& settings, OwnDetail& detail) {
  const SamplingMeshOptions options = mesh_options(world, settings);
  if (!detail.mesh || static_cast<double>(detail.longest_edge) > options.edge_length) return SamplingMesh(world, options);
  SamplingMesh own = std::move(*detail.mesh);
  detail.mesh.reset();
  return own;
}

/// With as many elements as the scene needs, where that is asked for; with `merge` only where the scene's own vertices are more
/// than the elements wanted.
Settings decided(const OwnDetail& detail, Settings settings) {
  // Tables of light by direction are dear, and the links' masks: there a room's elements have to do.
  if (settings.elements == 0)
    settings.elements = settings.mode == Mode::antiradiance ? elements_of_a_room : elements_for(detail.corners);
  settings.merge = settings.merge && detail.vertices > static_cast<std::size_t>(settings.elements);
  return settings;
}

/// Whether the mesh has more vertices than there are to be elements.
bool merges(const SamplingMesh& mesh, const Settings& settings) {
  return settings.merge && static_cast<double>(mesh.vertices().size()) > many_more * settings.elements;
}

bool sends_negative_light(const Settings& settings) {
  return settings.mode == Mode::antiradiance || settings.mode == Mode::disc_bounce;
}

Merging merging_of(const World& world, const SamplingMesh& mesh, const Settings& settings, Task& task) {
  return merges(mesh, settings)
             ? merge_discs(world, mesh, static_cast<std::size_t>(settings.elements), sends_negative_light(settings), task)
             : Merging{};
}

/// `bytes`: for all links. A tolerance of light says nothing about form factors: links made by it are left whole.
TracingRule tracing_rule(const Settings& settings, const RefinementRule& made_by, std::size_t links, double bytes) {
  const bool splits = settings.split_partial && made_by.radiosity.empty();
  const double left = bytes - bytes_a_traced_link * static_cast<double>(links);
  return {settings.visibility_rays, settings.near_cells,
          splits ? partial_share * made_by.tolerance : std::numeric_limits<float>::infinity(),
          static_cast<std::size_t>(std::max(0.0, left / bytes_a_made_link))};
}

/// Traces the links within the memory, and warns where they do not all have room to be taken apart.
void trace_within(const World& world, const Discretisation& parts, const TracingRule& rule, Linking& linking, Task& task) {
  const TracingCounts counts = trace_links(world, parts.elements, parts.hierarchy, rule, linking.links, task);
  task.count("links_taken_apart", counts.taken_apart);
  if (counts.left_whole > 0)
    linking.warning += fmt::format("{}the memory budget left {} links whole that are free in part",
                                   linking.warning.empty() ? "" : "; ", counts.left_whole);
}

bool looks_for_parted(const Settings& settings) { return settings.backface_rays > 0 && settings.mode != Mode::accessibility; }

double mebibytes(double bytes) { return bytes / (1024.0 * 1024.0); }

std::size_t element_count(const SamplingMesh& mesh, const Settings& settings) {
  return merges(mesh, settings) ? static_cast<std::size_t>(settings.elements) : mesh.vertices().size();
}

double bytes_needed(const SamplingMesh& mesh, const Settings& settings, double table_bytes) {
  const auto vertices = static_cast<double>(mesh.vertices().size());
  return static_cast<double>(element_count(mesh, settings)) * (bytes_an_element + table_bytes) +
         (merges(mesh, settings) ? vertices * bytes_a_merged_vertex : 0.0);
}

DecidedMesh decided_mesh(const World& world, const Settings& settings) {
  OwnDetail detail(world, settings);
  const Settings used = decided(detail, settings);
  return {used, cut_mesh(world, used, detail)};
}

/// The mesh, with as many elements as the budget has room for; `may_merge`: where they may share vertices to that end.
DecidedMesh mesh_within_budget(const World& world, OwnDetail detail, double table_bytes, bool may_merge, const Settings& wanted) {
  DecidedMesh made{wanted, cut_mesh(world, wanted, detail)};
  Settings& settings = made.settings;
  while (may_merge && settings.elements > fewest_elements) {
    const double needed = bytes_needed(made.mesh, settings, table_bytes);
    if (needed <= settings.bytes_at_most()) break;
    settings.elements =
        std::max(fewest_elements, static_cast<int>(settings.elements * std::min(0.9, settings.bytes_at_most() / needed)));
    settings.merge = true;
    settings = decided(detail, settings);
    if (!merges(made.mesh, settings)) made.mesh = cut_mesh(world, settings, detail);
  }
  return made;
}

/// How many elements there are, where these are not about as many as were asked for, one for each vertex.
std::string how_many(const SamplingMesh& mesh, const Settings& settings, int asked) {
  const std::size_t elements = element_count(mesh, settings);
  std::string text;
  if (merges(mesh, settings)) text = fmt::format("{} vertices share about {} elements", mesh.vertices().size(), elements);
  else if (static_cast<double>(elements) > many_more * asked)
    text = fmt::format("the scene's own vertices make {} elements where {} were asked for", elements, asked);
  if (settings.elements < asked)
    text += fmt::format("{}the memory budget asked for coarser elements: {} instead of {}", text.empty() ? "" : "; ",
                        settings.elements, asked);
  return text;
}

/// Elements whose assumptions other surfaces break, counted in the task and told of.
std::string count_crossings(const Elements& elements, Task& task) {
  std::uint64_t covered = 0, parted = 0, backed = 0;
  for (std::uint32_t i = 0; i < elements.size(); ++i) {
    if (elements.covered(i)) ++covered;
    if (elements.parted(i)) ++parted;
    if (elements.backed(i)) ++backed;
  }
  task.count("elements_behind_coplanar_faces", covered);
  task.count("elements_parted_by_surfaces", parted);
  task.count("elements_on_thin_slabs", backed);
  std::string text;
  if (parted > 0) text = fmt::format("other surfaces cross {} of {} elements", parted, elements.size());
  if (backed > 0)
    text += fmt::format("{}{} of {} elements have another surface behind them within their radius: light may leak there",
                        text.empty() ? "" : "; ", backed, elements.size());
  return text;
}

}  // namespace

Discretisation::Discretisation(const World& world, const Settings& settings, Task& task)
    : Discretisation(world, decided_mesh(world, settings), task) {}

Discretisation::Discretisation(const World& world, DecidedMesh made, Task& task)
    : mesh(std::move(made.mesh)),
      elements(world, mesh, made.settings.cell_points,
               {made.settings.backface_rays, made.settings.backface_rays > 0 && made.settings.mode == Mode::antiradiance}, task,
               merging_of(world, mesh, made.settings, task)),
      parted_triangles(looks_for_parted(made.settings) ? antiradiance::parted_triangles(world, mesh, elements, task)
                                                       : std::vector<std::uint8_t>()),
      surroundings(look_around(world, mesh, elements,
                               {made.settings.closure_rays, sends_negative_light(made.settings), parted_triangles}, task)),
      hierarchy(
          elements,
          made.settings.closure_rays > 0 ? std::span<const std::uint32_t>(surroundings.space) : std::span<const std::uint32_t>{},
          task, made.settings.mode == Mode::accessibility && world.scene().objects.size() <= most_apart),
      reconstruction(made.settings.mode == Mode::accessibility
                         ? Reconstruction()
                         : Reconstruction(world, mesh, elements, hierarchy, parted_triangles, task)) {}

double direction_table_bytes(const Settings& settings) {
  const auto bins = static_cast<std::size_t>(settings.bins) * static_cast<std::size_t>(settings.bins);
  return static_cast<double>(BinTransport::bytes_for(1, bins)) +
         krylov_vectors * static_cast<double>(bins * channels * sizeof(float));
}

std::unique_ptr<Discretisation> make_elements(const World& world, const Settings& settings, double table_bytes, Task& task,
                                              StageReport& report) {
  OwnDetail detail(world, settings);
  const Settings wanted = decided(detail, settings);
  DecidedMesh made = mesh_within_budget(world, std::move(detail), table_bytes, settings.merge, wanted);
  add_message(how_many(made.mesh, made.settings, wanted.elements), report);
  if (const double needed = bytes_needed(made.mesh, made.settings, table_bytes); needed > settings.bytes_at_most()) {
    report.termination = Termination::out_of_budget;
    add_message(fmt::format("{} elements need {:.0f} MiB: raise the parameter memory_budget, or lower elements, bins or sectors",
                            element_count(made.mesh, made.settings), mebibytes(needed)),
                report);
    return nullptr;
  }
  auto parts = std::make_unique<Discretisation>(world, std::move(made), task);
  task.count("elements", parts->elements.size());
  task.count("elements_inside_geometry", parts->elements.size() - parts->hierarchy.leaf_count());
  task.count("nodes", parts->hierarchy.size());
  add_message(count_crossings(parts->elements, task), report);
  task.progress("elements", 0.1);
  return parts;
}

Linking make_linking(const World& world, const Discretisation& parts, const Settings& settings, Visibility visibility,
                     std::span<const float> radiosity, Task& task) {
  Linking linking;
  linking.visibility = visibility;
  const bool by_direction = visibility == Visibility::antiradiance;
  if (by_direction || visibility == Visibility::nearest) linking.bins.emplace(settings.bins);
  const double tables = by_direction ? static_cast<double>(parts.hierarchy.leaf_count()) * direction_table_bytes(settings) : 0.0;
  const double fixed = static_cast<double>(parts.bytes()) + tables;
  if (fixed > settings.bytes_at_most()) {
    linking.refused = true;
    linking.warning = fmt::format("{} elements{} need {:.0f} MiB: raise the parameter memory_budget, or lower elements or bins",
                                  parts.elements.size(), by_direction ? fmt::format(" of {} bins", linking.bins->count()) : "",
                                  mebibytes(fixed));
    return linking;
  }

  RefinementRule rule;
  const bool both = by_direction || visibility == Visibility::shadow_passes;
  rule.facing = both ? Facing::both : Facing::fronts;
  rule.tolerance = settings.tolerance;
  // A sender is to be about as large as a bin: a hemisphere of n²/2 of them.
  if (visibility == Visibility::nearest)
    rule.tolerance = std::min(rule.tolerance, 2.0F / static_cast<float>(linking.bins->count()));
  rule.radiosity = radiosity;
  if (!radiosity.empty()) {
    double sum = 0.0, area = 0.0;
    for (const std::uint32_t root : parts.hierarchy.roots()) {
      const auto root_area = static_cast<double>(parts.hierarchy.nodes()[root].area);
      sum += root_area * static_cast<double>(radiosity[root]), area += root_area;
    }
    rule.mean_radiosity = area > 0.0 ? static_cast<float>(sum / area) : 0.0F;
  }
  rule.most_links =
      static_cast<std::size_t>((settings.bytes_at_most() - fixed) / (by_direction ? bytes_a_masked_link : bytes_a_link));
  RefinementCounts counts;
  for (int attempt = 0; attempt < most_attempts && !task.cancelled(); ++attempt) {
    linking.links = make_links(parts.hierarchy, rule, task, counts);
    if (!counts.too_many) break;
    rule.tolerance *= static_cast<float>(coarser);
  }
  task.count("oracle_pairs", counts.pairs);
  linking.tolerance = rule.tolerance;
  if (counts.too_many) {
    linking.refused = true;
    linking.warning =
        fmt::format("more than {} links at any tolerance: raise the parameter memory_budget or lower elements", rule.most_links);
    return linking;
  }
  if (rule.tolerance > 1.01F * settings.tolerance)
    linking.warning = fmt::format("the memory budget asked for coarser links: tolerance {:.3g} instead of {:.3g}", rule.tolerance,
                                  settings.tolerance);
  task.progress("links", 0.4);

  refine_factors(parts.elements, parts.hierarchy, settings.near_cells, linking.links, task);
  if (visibility == Visibility::traced)
    trace_within(world, parts, tracing_rule(settings, rule, linking.links.size(), settings.bytes_at_most() - fixed), linking,
                 task);
  if (visibility == Visibility::nearest)
    linking.links = nearest_links(parts.hierarchy, linking.links, *linking.bins, settings.bin_winner, task);
  if (by_direction) {
    std::vector<Vec3> ways;
    split_near_links(parts.elements, parts.hierarchy, linking.links, ways, task);
    if (!task.cancelled()) make_masks(parts.hierarchy, *linking.bins, ways, linking.links, task);
  }
  return linking;
}

}  // namespace gibench::antiradiance
