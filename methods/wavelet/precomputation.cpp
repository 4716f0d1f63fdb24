#include "methods/wavelet/precomputation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "methods/wavelet/blocks.h"
#include "methods/wavelet/closure.h"
#include "methods/wavelet/kernel.h"
#include "methods/wavelet/operator_making.h"

namespace gibench::wavelet {

namespace {

constexpr double bytes_a_block = 200.0;  // a block, its references, and its part of the links
constexpr int most_doublings = 20;
constexpr double most_blocks = 2147483647.0;  // numbers of 32 bits count their references, two of each

/// m² of both sides of two-sided triangles, and of the fronts of others.
double lit_area(const World& world) {
  double area = 0.0;
  for (std::uint32_t t = 0; t < world.scene().triangles.size(); ++t)
    area += static_cast<double>(world.area(t)) * (world.scene().objects[world.scene().triangle_object[t]].two_sided ? 2.0 : 1.0);
  return area;
}

void count_elements(const Elements& elements, Task& task) {
  task.count("elements", elements.elements().size());
  task.count("leaves", elements.leaves().size());
  task.count("basis_functions", elements.functions());
}

/// At the thresholds asked for, or at larger ones.
Blocks refine(const World& world, const Elements& elements, const Settings& settings, bool tests_visibility, Task& task,
              StageReport& report) {
  const Kernel kernel(world, elements, {settings.kernel, tests_visibility, settings.rays, task.seed()});
  RefinementRule rule{settings.receiver_threshold, settings.sender_threshold,
                      static_cast<std::size_t>(std::min(most_blocks, settings.memory_budget * 1e6 / bytes_a_block))};
  Blocks blocks(world, elements, kernel, rule, task);
  for (int doubling = 0; blocks.refused() && doubling < most_doublings && !task.cancelled(); ++doubling) {
    rule.receiver_threshold = 2.0 * std::max(1e-6, rule.receiver_threshold);
    rule.sender_threshold = 2.0 * std::max(1e-6, rule.sender_threshold);
    report.message =
        fmt::format("the operator would pass memory_budget={:g} MB: made with receiver_threshold={:g} and sender_threshold={:g}",
                    settings.memory_budget, rule.receiver_threshold, rule.sender_threshold);
    blocks = Blocks(world, elements, kernel, rule, task);
  }
  if (blocks.refused()) {
    report.termination = Termination::out_of_budget;
    report.message = fmt::format("memory_budget={:g} MB holds no operator between {} elements: raise it", settings.memory_budget,
                                 elements.elements().size());
  }
  return blocks;
}

}  // namespace

Precomputed precompute(const World& world, const Settings& settings, bool tests_visibility, Task& task, StageReport& report) {
  Precomputed made;
  const double leaf_area = lit_area(world) / settings.leaves;
  made.elements =
      Elements(world, {leaf_area, settings.cuts && tests_visibility, tests_visibility ? settings.exposure_rays : 0}, task);
  if (const std::size_t count = made.elements.refused(); count > 0) {
    report.termination = Termination::out_of_budget;
    report.message = fmt::format(
        "cut faces and long ones in parts make {} elements, and every pair of them is looked at: {} at most; "
        "set cuts=false, or leave long thin faces out of the scene",
        count, ElementOptions().most_elements);
    return made;
  }
  count_elements(made.elements, task);
  task.progress("elements", 0.1);
  if (task.cancelled()) return made;
  Blocks blocks = refine(world, made.elements, settings, tests_visibility, task, report);
  if (task.cancelled() || !succeeded(report.termination)) return made;
  task.count("blocks", blocks.size());
  const float off = hold_to_sums(world, made.elements, settings.closure_rays, blocks, task);
  task.count("closure_error_ppm", static_cast<std::uint64_t>(std::lround(1e6 * static_cast<double>(off))));
  task.progress("sums", 0.8);
  if (task.cancelled()) return made;
  OperatorMaking making = make_operator(made.elements, blocks, settings.compression, settings.precision, task);
  made.transport = std::move(making.transport);
  task.count("links", made.transport.links());
  task.count("coefficients", made.transport.coefficients());
  task.count("dropped_links", making.dropped_links);
  task.count("truncation_ppm", static_cast<std::uint64_t>(std::lround(1e6 * making.dropped_share)));
  task.progress("links", 0.9);
  if (task.cancelled()) return made;
  made.elements.keep_points(static_cast<std::size_t>(settings.direct_points));
  made.reconstruction = Reconstruction(world, made.elements, tests_visibility, task);
  return made;
}

}  // namespace gibench::wavelet
