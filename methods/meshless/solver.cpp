#include "methods/meshless/solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "common/core/random.h"
#include "common/finite_elements/bounce_series.h"
#include "common/finite_elements/surface_point.h"
#include "common/method/series_termination.h"

namespace gibench::meshless {

namespace {

constexpr std::uint64_t gather_stage = 0x676174686572ULL;
constexpr std::uint64_t direct_stage = 0x64697265637473ULL;
constexpr std::size_t gather_chunk = 4;   // points
constexpr std::size_t direct_chunk = 64;  // points
constexpr double gather_noise = 0.03;     // that direct light evaluated at the hits may bring into a gather, of the mean
constexpr double most_hit_samples = 4.0;  // at a hit, to keep to that; noisier direct light goes through the basis …
constexpr double point_noise = 0.3;       // … with this much noise at a basis point: a gather sees hundreds of them
constexpr double most_point_samples = 1024.0;

RgbDouble magnitude_mean(const Coefficients& coefficients) {
  const Hierarchy& hierarchy = coefficients.hierarchy();
  RgbDouble sum;
  for (std::uint32_t point = 0; point < hierarchy.level_size(0); ++point) {
    const Rgb value = coefficients[point];
    sum += hierarchy.coarsest_share(point) * RgbDouble(std::fabs(value.r), std::fabs(value.g), std::fabs(value.b));
  }
  return sum;
}

/// How far the series has come, from the last two bounces, channel by channel.
struct Convergence {
  RgbDouble ratio;         ///< of the last bounce to the one before, area means
  RgbDouble tail_factor;   ///< Σ of all later bounces over the last one, were the ratio to stay
  double residual = 0.0;   ///< share of the solution in the bounces left out
  double departure = 0.0;  ///< share of the solution by which that tail would be wrong
};

Convergence judge(const Coefficients& last, const Coefficients& before, const Coefficients& sum) {
  Convergence result;
  const RgbDouble last_mean = coarsest_mean(last), before_mean = coarsest_mean(before), total = magnitude_mean(sum);
  const std::uint32_t count = last.hierarchy().level_size(0);
  for (int channel = 0; channel < 3; ++channel) {
    if (!(total[channel] > 0.0)) continue;
    const double ratio = before_mean[channel] > 0.0 ? std::max(0.0, last_mean[channel] / before_mean[channel]) : 0.0;
    const double factor = ratio / share_lost(ratio);
    double departure = 0.0;
    for (std::uint32_t point = 0; point < count; ++point)
      departure += last.hierarchy().coarsest_share(point) *
                   std::fabs(static_cast<double>(last[point][channel]) - ratio * static_cast<double>(before[point][channel]));
    result.ratio[channel] = ratio;
    result.tail_factor[channel] = factor;
    result.residual = std::max(result.residual, last_mean[channel] * factor / total[channel]);
    result.departure = std::max(result.departure, departure * factor / total[channel]);
  }
  return result;
}

class Solver {
 public:
  Solver(const World& world, const Transport& transport, const DirectLight& light, const Settings& settings, int channels,
         Task& task)
      : world_(world),
        transport_(transport),
        light_(light),
        settings_(settings),
        channels_(channels),
        task_(task),
        gatherer_(world, settings.rays),
        coarsest_gatherer_(world, std::max(settings.rays, settings.coarsest_rays)) {
    look_at_direct_light();
  }

  bool first_bounce_from_basis() const { return first_bounce_from_basis_; }

  Coefficients direct() {
    const PointValues values = [this](std::span<const std::uint32_t> points, std::span<Estimate> out) {
      sample_direct(points, out);
    };
    RefinementRule rule = rule_of(0.0);
    rule.full_level = static_cast<std::uint32_t>(settings_.direct_full_level);
    return approximate(transport_.hierarchy, values, rule, task_);
  }

  /// Mean direct irradiance over the surfaces and the channels, W/m².
  double direct_mean() const { return direct_mean_; }

  /// Bounce `number`, of at most `bound`; the means are those of the bounces before it and of the one just before.
  Coefficients bounce(const Sender& sender, int number, int bound, double solution_mean, double previous_mean) {
    const PointValues values = [&](std::span<const std::uint32_t> points, std::span<Estimate> out) {
      gather(sender, number, points, out);
    };
    RefinementRule rule = rule_of(solution_mean);
    rule.previous_mean = previous_mean;
    rule.terms_left = bound - number;
    Coefficients made = approximate(transport_.hierarchy, values, rule, task_);
    task_.count("basis_functions", made.size());
    return made;
  }

  BasisSender sender_of(const Coefficients& coefficients) const {
    return BasisSender(coefficients, transport_.groups, settings_.epsilon_omega);
  }
  DirectSender direct_sender() const { return DirectSender(light_, hit_samples_); }

 private:
  /// Estimates at the coarsest samples show how noisy one light sample is, and so how many are needed, and where.
  void look_at_direct_light() {
    std::vector<std::uint32_t> points(transport_.hierarchy.level_size(0));
    std::iota(points.begin(), points.end(), 0U);
    std::vector<Estimate> values(points.size());
    sample_direct(points, values);
    double largest_mean = 0.0, variance = 0.0;
    for (const std::uint32_t point : points) {
      const Estimate& estimate = values[point];
      const double share = transport_.hierarchy.coarsest_share(point);
      direct_mean_ += share * channel_mean(RgbDouble(estimate.value));
      largest_mean += share * static_cast<double>(largest(estimate.value));
      variance += share * std::pow(static_cast<double>(estimate.deviation), 2);
    }
    const double relative_variance = largest_mean > 0.0 ? variance * point_samples_ / (largest_mean * largest_mean) : 0.0;
    const double at_hits = relative_variance / (settings_.rays * gather_noise * gather_noise);
    first_bounce_from_basis_ = settings_.first_bounce == FirstBounce::basis ||
                               (settings_.first_bounce == FirstBounce::automatic && at_hits > most_hit_samples);
    hit_samples_ = std::max(hit_samples_, static_cast<int>(std::ceil(std::min(at_hits, most_hit_samples))));
    const double at_points = std::min(relative_variance / (point_noise * point_noise), most_point_samples);
    point_samples_ = std::max(point_samples_, static_cast<int>(std::ceil(at_points)));
  }

  RefinementRule rule_of(double solution_mean) const {
    RefinementRule rule;
    rule.epsilon_e = settings_.epsilon_e;
    rule.noise_guard = settings_.noise_guard;
    rule.corrections = settings_.corrections;
    rule.solution_mean = solution_mean;
    rule.channels = channels_;
    return rule;
  }

  SurfaceSample sample(std::uint32_t point) const {
    const Hierarchy& hierarchy = transport_.hierarchy;
    const Vec3& front = world_.normal(hierarchy.triangle(point));
    return surface_sample(world_, hierarchy.triangle(point), hierarchy.position(point),
                          hierarchy.on_front(point) ? front : -front);
  }

  void gather(const Sender& sender, int number, std::span<const std::uint32_t> points, std::span<Estimate> out) {
    std::vector<std::uint64_t> levels(chunk_count(points.size(), gather_chunk)), evaluations(levels.size()),
        uncovered(levels.size());
    task_.parallel_chunks(points.size(), gather_chunk, [&](const ChunkRange& range) {
      RayStream rays = task_.rays(world_);
      GatherBuffers buffers;
      for (std::size_t i = range.begin; i < range.end; ++i) {
        const std::uint64_t key = mix_keys(mix_keys(task_.seed(), gather_stage), static_cast<std::uint64_t>(number), points[i]);
        const Gatherer& gatherer = points[i] < transport_.hierarchy.level_begin(1) ? coarsest_gatherer_ : gatherer_;
        out[i] = gatherer.irradiance(sample(points[i]), key, sender, rays, buffers);
      }
      levels[range.chunk] = buffers.counts.levels_used;
      evaluations[range.chunk] = buffers.evaluations;
      uncovered[range.chunk] = buffers.counts.uncovered;
    });
    task_.count("samples_gathered", points.size());
    for (std::uint64_t count : levels) task_.count("sender_levels", count);
    for (std::uint64_t count : evaluations) task_.count("sender_evaluations", count);
    for (std::uint64_t count : uncovered) task_.count("uncovered_hits", count);
  }

  void sample_direct(std::span<const std::uint32_t> points, std::span<Estimate> out) {
    task_.parallel_chunks(points.size(), direct_chunk, [&](const ChunkRange& range) {
      RayStream rays = task_.rays(world_);
      direct_estimates(points.subspan(range.begin, range.end - range.begin), rays, out.subspan(range.begin));
    });
    task_.count("direct_samples", points.size());
  }

  /// Two independent halves give the value and its deviation.
  void direct_estimates(std::span<const std::uint32_t> points, RayStream& rays, std::span<Estimate> out) const {
    std::vector<SurfaceSample> samples;
    std::vector<std::uint64_t> keys;
    for (const std::uint32_t point : points)
      for (const std::uint64_t half : {0U, 1U}) {
        samples.push_back(sample(point));
        keys.push_back(mix_keys(mix_keys(task_.seed(), direct_stage, point), half));
      }
    std::vector<Rgb> light(samples.size());
    light_.irradiance(samples, keys, std::max(1, point_samples_ / 2), rays, light);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Rgb &first = light[2 * i], &second = light[2 * i + 1], apart = first - second;
      out[i] = {0.5F * (first + second), 0.5F * std::max({std::fabs(apart.r), std::fabs(apart.g), std::fabs(apart.b)})};
    }
  }

  const World& world_;
  const Transport& transport_;
  const DirectLight& light_;
  const Settings& settings_;
  int channels_;
  Task& task_;
  Gatherer gatherer_, coarsest_gatherer_;
  double direct_mean_ = 0.0;
  bool first_bounce_from_basis_ = false;
  int hit_samples_ = settings_.direct_samples;          ///< light samples at a hit
  int point_samples_ = settings_.basis_direct_samples;  ///< at a basis point
};

void add_scaled(Coefficients& sum, const Coefficients& term, const Rgb& factor) {
  for (std::uint32_t point : term.sorted_points()) sum.add(point, term[point] * factor);
}

/// The Neumann series after direct light: i_{j+1} = T i_j, b = Σ i_j.
class Bounces {
 public:
  Bounces(Solver& solver, const Settings& settings, const Wanted& wanted, Task& task)
      : solver_(solver),
        settings_(settings),
        may_extrapolate_(!wanted.max_bounces && settings.extrapolate),
        channels_(wanted.channels),
        task_(task),
        series_(bound_of(settings, wanted)) {}

  void run(const Coefficients* direct, const Hierarchy& hierarchy, Solution& solution) {
    const int most = series_.last();
    Coefficients sum(hierarchy, channels_);
    Coefficients last = direct != nullptr ? solver_.bounce(solver_.sender_of(*direct), 1, most, 0.0, mean_of(*direct))
                                          : solver_.bounce(solver_.direct_sender(), 1, most, 0.0, solver_.direct_mean());
    add_scaled(sum, last, Rgb(1.0F));
    series_.add();
    task_.progress("bounce 1", 1.0 / most);
    while (series_.goes_on() && !task_.cancelled()) {
      Coefficients next = solver_.bounce(solver_.sender_of(last), series_.next(), most, mean_of(sum), mean_of(last));
      add_scaled(sum, next, Rgb(1.0F));
      const Convergence state = judge(next, last, sum);
      last = std::move(next);
      series_.add(largest(state.ratio), state.residual);
      task_.progress(fmt::format("bounce {}", series_.bounces()), series_.progress(), state.residual);
      if (!series_.settled() && tail_is_known(state)) {
        add_scaled(sum, last, Rgb(state.tail_factor));
        series_.settle();
      }
    }
    task_.count("bounces", static_cast<std::uint64_t>(series_.bounces()));
    solution.termination = termination_of(series_);
    solution.message = series_.message();
    task_.count("solution_functions", sum.size());
    solution.indirect.emplace(sum);
  }

 private:
  /// A plan that allows more bounces than are computed bounds nothing.
  static BounceBound bound_of(const Settings& settings, const Wanted& wanted) {
    const bool plan_bounds = wanted.max_bounces && *wanted.max_bounces <= settings.bounces;
    return {plan_bounds ? wanted.max_bounces : std::nullopt, settings.bounces, settings.residual};
  }
  static double mean_of(const Coefficients& coefficients) { return channel_mean(coarsest_mean(coefficients)); }

  /// Whether the last bounces were so alike that all later ones follow from their ratio.
  bool tail_is_known(const Convergence& state) const {
    return may_extrapolate_ && series_.bounces() >= 3 && series_.fades() && state.departure < settings_.residual;
  }

  Solver& solver_;
  const Settings& settings_;
  bool may_extrapolate_;
  int channels_;
  Task& task_;
  BounceSeries series_;
};

}  // namespace

Solution solve(const World& world, const Transport& transport, const DirectLight& light, const Settings& settings,
               const Wanted& wanted, Task& task) {
  Solution solution;
  Solver solver(world, transport, light, settings, wanted.channels, task);
  std::optional<Coefficients> direct;
  if (settings.direct == DirectAnswer::basis || (wanted.indirect && solver.first_bounce_from_basis())) {
    direct.emplace(solver.direct());
    task.progress("direct light", 0.1);
  }
  if (settings.direct == DirectAnswer::basis) solution.direct.emplace(*direct);
  if (wanted.indirect && !task.cancelled())
    Bounces(solver, settings, wanted, task)
        .run(solver.first_bounce_from_basis() ? &*direct : nullptr, transport.hierarchy, solution);
  return solution;
}

}  // namespace gibench::meshless
