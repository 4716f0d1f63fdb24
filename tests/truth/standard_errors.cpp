#include "standard_errors.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "asking.h"

namespace gibench::truth {

namespace {

constexpr double rounding = 1e-4;  // relative; what single precision may cost a noise-free value
constexpr double aim = 0.005;      // relative standard error that the samples are chosen for
constexpr std::int64_t pilot_samples = 512, most_samples = 1 << 15;
constexpr int replicates = 64;

double relative_error_of(const Answer& answer, const Question& question) {
  double worst = 0.0;
  for (int c = 0; c < 3; ++c)
    if (question.value[c] > 0.0) worst = std::max(worst, answer.standard_error[c] / question.value[c]);
  return worst;
}

/// Whether the question's paths are one ray long: cheap, but what they rarely meet has to be met some times.
bool short_paths(const Question& question) { return question.bounces == 0 || question.quantity == Quantity::accessibility; }

/// The samples, a power of two, that bring a relative standard error of `pilot` at `pilot_samples` down to the aim.
std::int64_t samples_for(const Question& question, double pilot) {
  const double wanted = static_cast<double>(pilot_samples) * (pilot / aim) * (pilot / aim);
  std::int64_t samples = short_paths(question) ? 8192 : 1024;
  while (static_cast<double>(samples) < wanted && samples < most_samples) samples *= 2;
  return samples;
}

/// Mean over the channels of the squared z-scores; empty for an answer without noise.
std::optional<double> squared_score(const Answer& answer, const Question& question) {
  double sum = 0.0;
  int channels = 0;
  for (int c = 0; c < 3; ++c) {
    const double scale = std::fabs(question.value[c]);
    if (!(answer.standard_error[c] > rounding * scale)) continue;
    const double sigma = std::hypot(answer.standard_error[c], question.uncertainty[c], 0.2 * rounding * scale);
    const double z = (answer.value[c] - question.value[c]) / sigma;
    sum += z * z;
    ++channels;
  }
  if (channels == 0) return std::nullopt;
  return sum / channels;
}

bool within_errors(const Answer& answer, const Question& question) {
  for (int c = 0; c < 3; ++c) {
    const double allowed =
        std::max(4.0 * answer.standard_error[c] + question.uncertainty[c], rounding * std::fabs(question.value[c]));
    if (!(std::fabs(answer.value[c] - question.value[c]) <= allowed)) return false;
  }
  return true;
}

/// Sum of squared scores and how many there are.
struct ChiSquare {
  double sum = 0.0;
  int count = 0;
  void add(const std::optional<double>& squared) {
    if (squared) sum += *squared, ++count;
  }
  /// Scores from 64 replicates are Student's t with 63 degrees of freedom: the mean square is 63/61.
  double expected() const { return count * (replicates - 1.0) / (replicates - 3.0); }
  double tolerance() const { return 4.0 * std::sqrt(2.2 * count) + 4.0; }
};

class PathTracedCase {
 public:
  PathTracedCase(const MethodRule& rule, const TruthCase& truth, const std::vector<std::vector<Question>>& groups)
      : rule_(rule), entry_(find_method(rule.method)), world_(*truth.world), groups_(groups) {}

  /// Asks with samples chosen by a pilot (of another seed, so that the choice biases nothing); one that is further off than four
  /// standard errors is asked once more, with four times the samples and another seed: chance does not strike twice.
  ChiSquare run() {
    ChiSquare chi;
    for (const auto& group : groups_) {
      for (const auto& [samples, questions] : by_samples(group)) {
        const std::vector<Answer> answers = ask(entry_, world_, questions, run_with(samples, 2));
        for (std::size_t i = 0; i < questions.size(); ++i) {
          chi.add(squared_score(answers[i], questions[i]));
          check(answers[i], questions[i], samples);
        }
      }
    }
    return chi;
  }

 private:
  std::map<std::int64_t, std::vector<Question>> by_samples(const std::vector<Question>& group) const {
    std::map<std::int64_t, std::vector<Question>> result;
    std::vector<Question> points;
    for (const Question& question : group) {
      if (question.place == Place::mean) result[short_paths(question) ? 32 : 8].push_back(question);
      else points.push_back(question);
    }
    const std::vector<Answer> pilot = ask(entry_, world_, points, run_with(pilot_samples, 1));
    for (std::size_t i = 0; i < points.size(); ++i)
      result[samples_for(points[i], relative_error_of(pilot[i], points[i]))].push_back(points[i]);
    return result;
  }

  Run run_with(std::int64_t samples, std::uint64_t seed) const {
    Run run{rule_.settings, seed, 64, 16};
    run.settings.emplace_back("samples", fmt::format("{}", samples));
    run.settings.emplace_back("replicates", fmt::format("{}", replicates));
    return run;
  }

  void check(const Answer& answer, const Question& question, std::int64_t samples) {
    if (within_errors(answer, question)) return;
    fmt::print("asked again: {}\n", tell(answer, question));
    const Answer again = ask(entry_, world_, {question}, run_with(4 * samples, 3)).front();
    EXPECT_TRUE(within_errors(again, question)) << tell(answer, question) << "\nagain: " << tell(again, question);
  }

  const MethodRule& rule_;
  const MethodEntry& entry_;
  const World& world_;
  const std::vector<std::vector<Question>>& groups_;
};

}  // namespace

void hold_to_standard_errors(const MethodRule& rule, const TruthCase& truth, const std::vector<std::vector<Question>>& groups) {
  const ChiSquare chi = PathTracedCase(rule, truth, groups).run();
  fmt::print("{}: chi-square {:.1f} of {} scores\n", truth.id, chi.sum, chi.count);
  EXPECT_NEAR(chi.sum, chi.expected(), chi.tolerance());
}

}  // namespace gibench::truth
