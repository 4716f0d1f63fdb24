#include "methods/antiradiance/settings.h"

#include <algorithm>

namespace gibench::antiradiance {

ParameterSchema settings_schema() {
  using Whole = std::int64_t;
  return {
      {"mode",
       std::string("antiradiance"),
       0,
       0,
       {"accessibility", "disc-bounce", "radiosity", "implicit", "antiradiance"},
       "ambient accessibility; one bounce of discs; traced visibility; nearest of a bin; negative light instead of visibility"},
      {"elements", Whole{4096}, 1, 4e6, {}, "disc elements wanted: faces are cut until there are about so many"},
      {"crease_degrees", 40.0, 0.0, 180.0, {}, "faces that turn by more share no vertex, degrees"},
      {"cell_points", Whole{16}, 4, 64, {}, "points of an element's cell that rays start from"},
      {"backface_rays", Whole{8}, 0, 1024, {}, "rays that must all meet backs for a point to be inside geometry; 0: no test"},
      {"near_field",
       std::string("cells"),
       0,
       0,
       {"cells", "discs"},
       "elements that nearly touch exchange light as the polygons of their cells, or as discs"},
      {"oracle",
       std::string("geometry"),
       0,
       0,
       {"geometry", "radiosity"},
       "links are accepted by form factor alone, or by form factor times radiosity times area"},
      {"tolerance", 0.01, 1e-5, 1.0, {}, "largest form factor (times relative radiosity and area) of an accepted link"},
      {"visibility_rays", Whole{4}, 1, 4096, {}, "rays a link, in radiosity mode"},
      {"closure_rays",
       Whole{256},
       0,
       65536,
       {},
       "rays an element that tell what its form factors must sum to; 0: they are only kept to one at most"},
      {"bins", Whole{12}, 4, 128, {}, "directional bins along a side of the map of the sphere: n means n² bins; even"},
      {"bin_winner",
       std::string("middle"),
       0,
       0,
       {"middle", "links"},
       "implicit: of a bin's senders the nearest across its middle stays, or (as in the text) of all whose links point into it"},
      {"residual", 1e-4, 1e-7, 1.0, {}, "the iteration ends when a step is smaller, share of the solution"},
      {"most_iterations", Whole{200}, 1, 100000, {}, "iterations of one solver, before the next one is tried"},
      {"iterations",
       Whole{0},
       0,
       100000,
       {},
       "exactly so many terms of the series, 1: light without shadows; 0: until the residual falls"},
      {"clamp", true, 0, 0, {}, "answer zero where light is negative"},
      {"direct_samples", Whole{4}, 1, 4096, {}, "light samples at each point of a cell"},
      {"passes", Whole{2}, 1, 100, {}, "passes of accessibility, shadow passes of disc-bounce; the last two are blended"},
      {"sectors",
       Whole{8},
       1,
       32,
       {},
       "accessibility by direction: n × n sectors, even, 4 at least; 1: by side alone, as in the text"},
      {"far_enough", 0.02, 0.0, 1.0, {}, "accessibility: largest form factor of a node that stands for its elements; 0: naive"},
      {"memory_budget",
       2048.0,
       1.0,
       1e9,
       {},
       "MiB for elements, links and tables; beyond it links get coarser, or the work ends"},
  };
}

Settings settings_from(const Parameters& parameters) {
  const auto whole = [&](const char* name) { return static_cast<int>(parameters.whole(name)); };
  const auto real = [&](const char* name) { return static_cast<float>(parameters.real(name)); };
  Settings settings;
  const std::string& mode = parameters.text("mode");
  settings.mode = mode == "accessibility" ? Mode::accessibility
                  : mode == "disc-bounce" ? Mode::disc_bounce
                  : mode == "radiosity"   ? Mode::radiosity
                  : mode == "implicit"    ? Mode::implicit
                                          : Mode::antiradiance;
  settings.elements = whole("elements");
  settings.crease_degrees = real("crease_degrees");
  settings.cell_points = whole("cell_points");
  settings.backface_rays = whole("backface_rays");
  settings.near_cells = parameters.text("near_field") == "cells";
  settings.oracle = parameters.text("oracle") == "geometry" ? OracleKind::geometry : OracleKind::radiosity;
  settings.tolerance = real("tolerance");
  settings.visibility_rays = whole("visibility_rays");
  settings.closure_rays = whole("closure_rays");
  settings.bins = whole("bins") + whole("bins") % 2;
  settings.bin_winner = parameters.text("bin_winner") == "middle" ? BinWinner::middle : BinWinner::links;
  settings.residual = parameters.real("residual");
  settings.most_iterations = whole("most_iterations");
  settings.iterations = whole("iterations");
  settings.clamp = parameters.flag("clamp");
  settings.direct_samples = whole("direct_samples");
  settings.passes = whole("passes");
  settings.sectors = whole("sectors") > 1 ? std::max(4, whole("sectors") + whole("sectors") % 2) : 1;
  settings.far_enough = real("far_enough");
  // Accessibility is found without any ray: what is inside geometry is hidden by it, as passes see to.
  if (settings.mode == Mode::accessibility) settings.closure_rays = settings.backface_rays = 0;
  settings.memory_budget = parameters.real("memory_budget") * 1024.0 * 1024.0;
  return settings;
}

}  // namespace gibench::antiradiance
