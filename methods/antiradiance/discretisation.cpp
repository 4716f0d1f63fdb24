#include "methods/antiradiance/discretisation.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "methods/antiradiance/bin_transport.h"
#include "methods/antiradiance/exchange.h"
#include "methods/antiradiance/implicit.h"
#include "methods/antiradiance/near_directions.h"
#include "methods/antiradiance/refinement.h"
#include "methods/antiradiance/report_message.h"
#include "methods/antiradiance/visibility.h"

namespace gibench::antiradiance {

namespace {

constexpr double coarser = 1.5;  // times, from one oracle to the next
// At the peak, for each of the oracle's links: the table and the blocks it is put together from; with masks also the near
// links' pieces and all links' directions (measured: README.md, Memory).
constexpr double bytes_a_link = 20.0, bytes_a_masked_link = 52.0;
constexpr int most_attempts = 24;
constexpr double krylov_vectors = 8.0;
constexpr double bytes_an_element = 1500.0;  // with all but links and tables (README.md, Memory)
constexpr double many_more = 2.0;            // elements than asked for
constexpr std::size_t most_apart = 64;       // objects whose trees accessibility keeps apart

SamplingMeshOptions mesh_options(const World& world, const Settings& settings) {
  SamplingMeshOptions options;
  // Slivers have length without area: they are not cut into more pieces along it than there are to be elements.
  options.edge_length = std::max(edge_length_for(world, static_cast<double>(settings.elements)),
                                 static_cast<double>(world.diagonal()) / static_cast<double>(settings.elements));
  options.crease_degrees = settings.crease_degrees;
  options.keep_quads = true;
  return options;
}

double mebibytes(double bytes) { return bytes / (1024.0 * 1024.0); }

/// What many more elements than asked for come from.
std::string own_vertices(std::size_t elements, const Settings& settings) {
  if (static_cast<double>(elements) <= many_more * settings.elements) return {};
  return fmt::format("the scene's own vertices make {} elements where {} were asked for", elements, settings.elements);
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
    : Discretisation(world, SamplingMesh(world, mesh_options(world, settings)), settings, task) {}

Discretisation::Discretisation(const World& world, SamplingMesh made, const Settings& settings, Task& task)
    : mesh(std::move(made)),
      elements(world, mesh, settings.cell_points,
               {settings.backface_rays, settings.backface_rays > 0 && settings.mode == Mode::antiradiance}, task),
      surroundings(look_around(world, mesh, elements, settings.closure_rays, task)),
      hierarchy(elements,
                settings.closure_rays > 0 ? std::span<const std::uint32_t>(surroundings.space) : std::span<const std::uint32_t>{},
                task, settings.mode == Mode::accessibility && world.scene().objects.size() <= most_apart),
      reconstruction(world, mesh, elements, settings.backface_rays > 0, task) {}

double direction_table_bytes(const Settings& settings) {
  const auto bins = static_cast<std::size_t>(settings.bins) * static_cast<std::size_t>(settings.bins);
  return static_cast<double>(BinTransport::bytes_for(1, bins)) + krylov_vectors * static_cast<double>(bins * channels * sizeof(float));
}

std::unique_ptr<Discretisation> make_elements(const World& world, const Settings& settings, double table_bytes, Task& task,
                                              StageReport& report) {
  SamplingMesh mesh(world, mesh_options(world, settings));
  const std::size_t count = mesh.vertices().size();
  add_message(own_vertices(count, settings), report);
  const double needed = static_cast<double>(count) * (bytes_an_element + table_bytes);
  if (needed > settings.bytes_at_most()) {
    report.termination = Termination::out_of_budget;
    add_message(fmt::format("{} elements need {:.0f} MiB: raise the parameter memory_budget, or lower elements, bins or sectors",
                            count, mebibytes(needed)),
                report);
    return nullptr;
  }
  auto parts = std::make_unique<Discretisation>(world, std::move(mesh), settings, task);
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
    trace_links(world, parts.elements, parts.hierarchy, settings.visibility_rays, linking.links, task);
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
