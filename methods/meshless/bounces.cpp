#include "methods/meshless/bounces.h"

#include <fmt/format.h>

#include <utility>

#include "common/method/series_termination.h"

namespace gibench::meshless {

SeriesBound::SeriesBound(const Settings& settings, const std::optional<int>& max_bounces)
    : bounces{max_bounces && *max_bounces <= settings.bounces ? max_bounces : std::nullopt, settings.bounces, settings.residual},
      may_extrapolate(!max_bounces && settings.extrapolate) {}

BounceSum::BounceSum(Coefficients first, const SeriesBound& bound, double residual, Task& task)
    : may_extrapolate_(bound.may_extrapolate),
      residual_(residual),
      task_(task),
      series_(bound.bounces),
      last_(std::move(first)),
      sum_(last_) {
  series_.add();
  task_.progress("bounce 1", series_.progress());
}

void BounceSum::add(Coefficients next) {
  add_scaled(sum_, next, Rgb(1.0F));
  const Convergence state = judge(next, last_, sum_);
  last_ = std::move(next);
  series_.add(largest(state.ratio), state.residual);
  task_.progress(fmt::format("bounce {}", series_.bounces()), series_.progress(), state.residual);
  if (series_.settled() || !tail_is_known(state)) return;
  add_scaled(sum_, last_, Rgb(state.tail_factor));
  series_.settle();
}

/// Whether the last bounces were so alike that all later ones follow from their ratio.
bool BounceSum::tail_is_known(const Convergence& state) const {
  return may_extrapolate_ && series_.bounces() >= 3 && series_.fades() && state.departure < residual_;
}

IndirectLight refined_bounces(LightAtPoints& light, const Transport& transport, const Coefficients* direct,
                              const Settings& settings, const SeriesBound& bound, Task& task) {
  const auto mean_of = [](const Coefficients& made) { return channel_mean(coarsest_mean(made)); };
  const auto gathered = [&](const Sender& sender, int number, double solution_mean, double previous_mean) {
    RefinementRule rule = light.rule();
    rule.solution_mean = solution_mean;
    rule.previous_mean = previous_mean;
    rule.terms_left = bound.bounces.last() - number;
    const PointValues values = [&](std::span<const std::uint32_t> points, std::span<Estimate> out) {
      light.gather(sender, number, points, out);
    };
    Coefficients made = approximate(transport.hierarchy, values, rule, task);
    task.count("basis_functions", made.size());
    return made;
  };
  BounceSum bounces(direct != nullptr ? gathered(light.sender_of(*direct), 1, 0.0, mean_of(*direct))
                                      : gathered(light.direct_sender(), 1, 0.0, light.direct_mean()),
                    bound, settings.residual, task);
  while (bounces.series().goes_on() && !task.cancelled())
    bounces.add(
        gathered(light.sender_of(bounces.last()), bounces.series().next(), mean_of(bounces.sum()), mean_of(bounces.last())));
  task.count("bounces", static_cast<std::uint64_t>(bounces.series().bounces()));
  return {bounces.sum(), termination_of(bounces.series()), bounces.series().message()};
}

}  // namespace gibench::meshless
