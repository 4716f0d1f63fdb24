#include "methods/spectral/compression.h"

#include <algorithm>
#include <cmath>

namespace gibench::spectral {

namespace {

constexpr std::size_t most_pilots = 32;  // blocks
constexpr int halvings = 20;
constexpr double lowest_threshold = 1e-8;  // of the one that leaves out everything
constexpr double least_spread = 1e-3;      // of the largest: no function is taken to carry nothing

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
    if (usual.size() < part.width) usual.resize(part.width, 0.0), weights.resize(part.width, 0.0);
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
    for (std::uint32_t order = 0; order < part.width; ++order) {
      const double by_order = std::max({usual[order], least_spread * largest, 1e-30}) * std::sqrt(part_weight[p]);
      spread[part.column + order] = static_cast<float>(std::max(by_order, std::sqrt(own[part.column + order])));
    }
  }
  return spread;
}

using Answers = std::vector<std::vector<Rgb4>>;  // one a light and row

/// The pilots' answers through a matrix of just those rows.
template <class RowsOf>
Answers answers(std::span<const PilotBlock> pilots, const RowsOf& rows_of, const Truncation& truncation,
                const std::vector<float>& constant, const std::vector<std::vector<Rgb4>>& lights, Task& task) {
  TransferMatrix matrix(truncation, constant);
  TransferMatrix::Section section(matrix);
  for (const PilotBlock& pilot : pilots) section.add_block(rows_of(pilot));
  matrix.append(section);
  Answers result;
  for (const std::vector<Rgb4>& light : lights) matrix.multiply(light, result.emplace_back(matrix.rows()), task);
  return result;
}

/// The pilots without truncation, and by other rays.
struct Judge {
  Answers whole, others[2];
  std::vector<double> areas;

  /// What truncation adds to the squared error of the answers to a light, as a share of their squares: of the light that it
  /// hurts most.
  double added_error(const Answers& truncated) const {
    double worst = 0.0;
    for (std::size_t light = 0; light < whole.size(); ++light) {
      RgbDouble squares, added;
      for (std::size_t row = 0; row < areas.size(); ++row) {
        const RgbDouble own(Rgb(whole[light][row]));
        const RgbDouble off = RgbDouble(Rgb(truncated[light][row])) - own;
        // (x − A)(x − B) of the truncated answer less that of the answer itself.
        RgbDouble doubted = off;
        for (const Answers& other : others)
          if (!other.empty()) doubted += own - RgbDouble(Rgb(other[light][row]));
        squares += areas[row] * (own * own);
        added += areas[row] * (off * doubted);
      }
      for (int c = 0; c < 3; ++c)
        if (squares[c] > 0.0) worst = std::max(worst, added[c] / squares[c]);
    }
    return std::sqrt(worst);
  }
};

double threshold_that_drops_all(std::span<const PilotBlock> pilots, const std::vector<float>& importance) {
  double largest = 1e-30;
  for (const PilotBlock& pilot : pilots)
    for (std::size_t i = 0; i < pilot.rows.size(); ++i)
      largest = std::max(largest, static_cast<double>(std::fabs(pilot.rows[i]) * importance[i % importance.size()]));
  return 2.0 * largest;
}

}  // namespace

std::vector<std::size_t> pilot_blocks(std::size_t blocks) {
  const std::size_t count = std::min(most_pilots, blocks);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < count; ++i) chosen.push_back((2 * i + 1) * blocks / (2 * count));
  return chosen;
}

Truncation choose_truncation(const SpectralBasis& basis, const std::vector<std::vector<Rgb4>>& lights,
                             std::span<const PilotBlock> pilots, double error, Task& task) {
  const std::vector<float> constant = basis.constant();
  Truncation truncation{spread_of_columns(basis, lights), 0.0F};
  Judge judge;
  judge.whole = answers(
      pilots, [](const PilotBlock& pilot) { return std::span(pilot.rows); }, {}, constant, lights, task);
  for (std::size_t i = 0; i < 2; ++i)
    if (!pilots.empty() && !pilots.front().others[i].empty())
      judge.others[i] = answers(
          pilots, [i](const PilotBlock& pilot) { return std::span(pilot.others[i]); }, {}, constant, lights, task);
  for (const PilotBlock& pilot : pilots) judge.areas.insert(judge.areas.end(), pilot.areas.begin(), pilot.areas.end());
  double high = threshold_that_drops_all(pilots, truncation.importance), low = high * lowest_threshold;
  for (int i = 0; i < halvings && !task.cancelled(); ++i) {
    const double middle = std::sqrt(low * high);
    truncation.threshold = static_cast<float>(middle);
    const Answers truncated = answers(
        pilots, [](const PilotBlock& pilot) { return std::span(pilot.rows); }, truncation, constant, lights, task);
    (judge.added_error(truncated) > error ? high : low) = middle;
  }
  truncation.threshold = static_cast<float>(low);
  return truncation;
}

}  // namespace gibench::spectral
