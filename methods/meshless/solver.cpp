#include "methods/meshless/solver.h"

#include "methods/meshless/coarse_bounces.h"

namespace gibench::meshless {

Solution solve(const World& world, const Transport& transport, const DirectLight& light, const Settings& settings,
               const Wanted& wanted, Task& task) {
  Solution solution;
  LightAtPoints at_points(world, transport, light, settings, wanted.channels, task);
  std::optional<Coefficients> direct;
  if (settings.direct == DirectAnswer::basis || (wanted.indirect && at_points.first_bounce_from_basis())) {
    direct.emplace(at_points.direct());
    task.progress("direct light", 0.1);
  }
  if (settings.direct == DirectAnswer::basis) solution.direct.emplace(*direct);
  if (!wanted.indirect || task.cancelled()) return solution;
  const Coefficients* const sent = at_points.first_bounce_from_basis() ? &*direct : nullptr;
  const SeriesBound bound(settings, wanted.max_bounces);
  const IndirectLight indirect = settings.bounce_levels > 0 ? coarse_bounces(at_points, transport, sent, settings, bound, task)
                                                            : refined_bounces(at_points, transport, sent, settings, bound, task);
  task.count("solution_functions", indirect.coefficients.size());
  solution.termination = indirect.termination;
  solution.message = indirect.message;
  solution.indirect.emplace(indirect.coefficients);
  return solution;
}

}  // namespace gibench::meshless
