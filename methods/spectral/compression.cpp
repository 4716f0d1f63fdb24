#include "methods/spectral/compression.h"

#include <algorithm>
#include <cmath>

namespace gibench::spectral {

namespace {

constexpr int halvings = 20;
constexpr double lowest_threshold = 1e-8;     // of the one that leaves out everything
constexpr double error_of_eight_bits = 0.02;  // from there on: below it single points would notice
constexpr double least_spread = 1e-3;         // of the largest: no function is taken to carry nothing

double squared(const Rgb4& c) {
  const auto r = static_cast<double>(c.r), g = static_cast<double>(c.g), b = static_cast<double>(c.b);
  return r * r + g * g + b * b;
}

/// Mean square of every column's coefficients over the lights.
std::vector<double> mean_squares(const std::vector<std::vector<Rgb4>>& lights, std::size_t columns) {
  std::vector<double> squares(columns, 0.0);
  for (const std::vector<Rgb4>& light : lights)
    for (std::size_t c = 0; c < columns; ++c) squares[c] += squared(light[c]) / (3.0 * static_cast<double>(lights.size()));
  return squares;
}

/// Root mean square of the coefficients, by order over all parts and over their weight; more in parts that a light is close to.
std::vector<float> spread_of_columns(const SpectralBasis& basis, const std::vector<std::vector<Rgb4>>& lights) {
  const std::vector<double> own = mean_squares(lights, basis.columns());
  std::vector<double> part_weight, usual, weights;  // the latter two by order
  for (const SpectralBasis::Part& part : basis.parts()) {
    double sum = 0.0;
    for (std::uint32_t slot = part.begin; slot < part.end; ++slot) sum += static_cast<double>(basis.weight()[slot]);
    part_weight.push_back(sum);
    if (usual.size() < part.functions) usual.resize(part.functions, 0.0), weights.resize(part.functions, 0.0);
    for (std::uint32_t order = 0; order < part.functions; ++order) {
      weights[order] += sum;
      usual[order] += own[part.column + order];
    }
  }
  double largest = 0.0;
  for (std::size_t order = 0; order < usual.size(); ++order) {
    usual[order] = weights[order] > 0.0 ? std::sqrt(usual[order] / weights[order]) : 0.0;
    largest = std::max(largest, usual[order]);
  }
  std::vector<float> spread(basis.columns(), 1.0F);
  for (std::size_t p = 0; p < basis.parts().size(); ++p) {
    const SpectralBasis::Part& part = basis.parts()[p];
    for (std::uint32_t order = 0; order < part.functions; ++order) {
      const double by_order = std::max({usual[order], least_spread * largest, 1e-30}) * std::sqrt(part_weight[p]);
      spread[part.column + order] = static_cast<float>(std::max(by_order, std::sqrt(own[part.column + order])));
    }
  }
  return spread;
}

using Answers = std::vector<std::vector<Rgb4>>;  // one per light and row

/// What a pilot's rows truly are, twice.
std::span<const float> truth(const PilotBlock& pilot, std::size_t which) {
  return pilot.others[which].empty() ? pilot.rows : pilot.others[which];
}

/// The pilots, and the lights that they are asked about.
class Trial {
 public:
  Trial(std::span<const PilotBlock> pilots, const std::vector<std::vector<Rgb4>>& lights, std::vector<float> constant, Task& task)
      : pilots_(pilots), lights_(lights), constant_(std::move(constant)), task_(task) {
    for (std::size_t which = 0; which < 2; ++which) whole_[which] = answers(which, {});
    for (const PilotBlock& pilot : pilots) areas_.insert(areas_.end(), pilot.areas.begin(), pilot.areas.end());
  }

  /// How much truncation changes the answers, root mean square over lights.
  double change(const Truncation& truncation) const {
    const Answers truncated[2] = {answers(0, truncation), answers(1, truncation)};
    double sum = 0.0;
    int counted = 0;  // lights that reach anything
    for (std::size_t light = 0; light < lights_.size(); ++light) {
      RgbDouble squares, changes;
      for (std::size_t row = 0; row < areas_.size(); ++row) {
        const RgbDouble first{Rgb(whole_[0][light][row])}, second{Rgb(whole_[1][light][row])};
        squares += areas_[row] * (first * second);
        changes += areas_[row] *
                   ((RgbDouble(Rgb(truncated[0][light][row])) - first) * (RgbDouble(Rgb(truncated[1][light][row])) - second));
      }
      for (int c = 0; c < 3; ++c)
        if (squares[c] > 0.0) sum += changes[c] / squares[c], ++counted;
    }
    return counted > 0 ? std::sqrt(std::max(0.0, sum / counted)) : 0.0;
  }

 private:
  /// Through a matrix of the pilots alone; truncated as their rows are.
  Answers answers(std::size_t which, const Truncation& truncation) const {
    TransferMatrix matrix(truncation, constant_);
    TransferMatrix::Section section(matrix);
    for (const PilotBlock& pilot : pilots_)
      section.add_block(truth(pilot, which), truncation.importance.empty() ? truth(pilot, which) : pilot.rows);
    matrix.append(section);
    Answers result;
    for (const std::vector<Rgb4>& light : lights_) matrix.multiply(light, result.emplace_back(matrix.rows()), task_);
    return result;
  }

  std::span<const PilotBlock> pilots_;
  const std::vector<std::vector<Rgb4>>& lights_;
  std::vector<float> constant_;
  Task& task_;
  Answers whole_[2];
  std::vector<double> areas_;
};

double threshold_that_drops_all(std::span<const PilotBlock> pilots, const std::vector<float>& importance) {
  double largest = 1e-30;
  for (const PilotBlock& pilot : pilots)
    for (std::size_t i = 0; i < pilot.rows.size(); ++i)
      largest = std::max(largest, static_cast<double>(std::fabs(pilot.rows[i]) * importance[i % importance.size()]));
  return 2.0 * largest;
}

}  // namespace

std::vector<std::size_t> pilot_blocks(std::size_t blocks, std::size_t most) {
  const std::size_t count = std::min(most, blocks);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < count; ++i) chosen.push_back((2 * i + 1) * blocks / (2 * count));
  return chosen;
}

Truncation choose_truncation(const SpectralBasis& basis, const TrialLights& lights, std::span<const PilotBlock> pilots,
                             double error, Task& task) {
  Truncation truncation{spread_of_columns(basis, lights.usual), 0.0F, false, error >= error_of_eight_bits};
  const Trial trial(pilots, lights.judges, basis.constant(), task);
  double high = threshold_that_drops_all(pilots, truncation.importance), low = high * lowest_threshold;
  for (int i = 0; i < halvings && !task.cancelled(); ++i) {
    const double middle = std::sqrt(low * high);
    truncation.threshold = static_cast<float>(middle);
    (trial.change(truncation) > error ? high : low) = middle;
  }
  truncation.threshold = static_cast<float>(low);
  return truncation;
}

Truncation truncation_for(const CompressionWish& wish, const SpectralBasis& basis,
                          const std::function<std::vector<PilotBlock>()>& pilots, Task& task) {
  if (wish.kind == Compression::rounding) return {std::vector<float>(basis.columns(), 1.0F), 0.0F, true};
  if (!wish.judged()) return {};
  const std::vector<PilotBlock> made = pilots();
  if (task.cancelled()) return {};
  return choose_truncation(basis, wish.lights, made, wish.error, task);
}

}  // namespace gibench::spectral
