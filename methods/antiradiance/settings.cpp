#include "methods/antiradiance/settings.h"

#include <algorithm>

#include "common/method/parameter_table.h"

namespace gibench::antiradiance {

namespace {

const ParameterTable<Settings>& table() {
  static const ParameterTable<Settings> made{
      parameter("mode", &Settings::mode,
                {{"accessibility", Mode::accessibility},
                 {"disc-bounce", Mode::disc_bounce},
                 {"radiosity", Mode::radiosity},
                 {"implicit", Mode::implicit},
                 {"antiradiance", Mode::antiradiance}},
                "ambient accessibility; one bounce of discs; traced visibility; nearest of a bin; negative light instead of "
                "visibility"),
      parameter(
          "elements", &Settings::elements, 0, 4e6,
          "disc elements wanted: faces are cut until there are about so many, or vertices share discs until there are; 0: as "
          "many as the scene needs (4096, or more where it has more corners; 4096 with light by direction)"),
      parameter("merge", &Settings::merge,
                "vertices share discs where the scene's own are more than `elements`, and twice as many when cut; false: each "
                "has its own, as "
                "in the text"),
      parameter("crease_degrees", &Settings::crease_degrees, 0.0, 180.0, "faces that turn by more share no vertex, degrees"),
      parameter("cell_points", &Settings::cell_points, 4, 64, "points of an element's cell that rays start from"),
      parameter("backface_rays", &Settings::backface_rays, 0, 1024,
                "rays that must all meet backs for a point to be inside geometry; 0: no test"),
      parameter("near_field", &Settings::near_cells, {{"cells", true}, {"discs", false}},
                "elements that nearly touch exchange light as the polygons of their cells, or as discs"),
      parameter("oracle", &Settings::oracle, {{"geometry", OracleKind::geometry}, {"radiosity", OracleKind::radiosity}},
                "links are accepted by form factor alone, or by form factor times radiosity times area"),
      parameter("tolerance", &Settings::tolerance, 1e-5, 1.0,
                "largest form factor (times relative radiosity and area) of an accepted link"),
      parameter("visibility_rays", &Settings::visibility_rays, 1, 4096, "rays per link, in radiosity mode"),
      parameter(
          "split_partial", &Settings::split_partial,
          "radiosity with oracle=geometry: links of several elements that rays find free in part are taken apart; false: as "
          "in the text, their factor is multiplied by the free share"),
      parameter("closure_rays", &Settings::closure_rays, 0, 65536,
                "rays of an element that measure what its form factors must sum to; 0: they are only kept to one at most"),
      parameter("bins", &Settings::bins, 4, 128, "directional bins along a side of the map of the sphere: n means n² bins; even"),
      parameter("bin_winner", &Settings::bin_winner, {{"middle", BinWinner::middle}, {"links", BinWinner::links}},
                "implicit: of a bin's senders the nearest across its middle stays, or (as in the text) of all whose links point "
                "into it"),
      parameter("residual", &Settings::residual, 1e-7, 1.0, "the iteration ends when a step is smaller, share of the solution"),
      parameter("most_iterations", &Settings::most_iterations, 1, 100000,
                "iterations of one solver, before the next one is tried"),
      parameter("iterations", &Settings::iterations, 0, 100000,
                "exactly so many terms of the series, 1: light without shadows; 0: until the residual falls"),
      parameter("clamp", &Settings::clamp, "answer zero where light is negative"),
      parameter("direct_samples", &Settings::direct_samples, 1, 4096, "light samples at each point of a cell"),
      parameter("passes", &Settings::passes, 1, 100,
                "passes of accessibility and disc-bounce, the first without what a pass before found; the last two are blended"),
      parameter("sectors", &Settings::sectors, 1, 32,
                "accessibility by direction: n × n sectors, even, 4 at least; 1: by side alone, as in the text"),
      parameter("far_enough", &Settings::far_enough, 0.0, 1.0,
                "accessibility: largest form factor of a node that stands for its elements; 0: naive"),
      parameter("memory_budget", &Settings::memory_budget, 1.0, 1e9,
                "MiB for elements, links and tables; beyond it links get coarser, or the work ends"),
  };
  return made;
}

int even(int number) { return number + number % 2; }

}  // namespace

ParameterSchema settings_schema() { return table().schema(); }

Settings settings_from(const Parameters& parameters) {
  Settings settings = table().read(parameters);
  settings.bins = even(settings.bins);
  if (settings.sectors > 1) settings.sectors = std::max(4, even(settings.sectors));
  // Accessibility is found without any ray: what is inside geometry is hidden by it, as passes see to.
  if (settings.mode == Mode::accessibility) settings.closure_rays = settings.backface_rays = 0;
  return settings;
}

}  // namespace gibench::antiradiance
