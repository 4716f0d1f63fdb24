#include "methods/meshless/transport_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gibench::meshless {

namespace {

constexpr std::size_t row_chunk = 64;  // rows

/// Of the ball of a basis function, seen from a receiver: 2π (1 − cos θ), the half sphere from inside.
float solid_angle(float radius, const Vec3& apart) {
  const float squared_sine = std::min(1.0F, radius * radius / glm::dot(apart, apart));
  return 2.0F * pi * (1.0F - std::sqrt(1.0F - squared_sine));
}

}  // namespace

struct TransportRows::Sums {
  std::vector<Rgb> weights;  ///< of every sender
  std::vector<std::uint32_t> met;
  std::vector<std::pair<std::uint32_t, float>> covering;  ///< of one hit and level

  explicit Sums(std::size_t senders) : weights(senders) {}
  void add(std::uint32_t sender, const Rgb& weight) {
    if (is_black(weights[sender])) met.push_back(sender);
    weights[sender] += weight;
  }
};

TransportRows::TransportRows(const Hierarchy& hierarchy, const Groups& groups, std::uint32_t levels, double epsilon_omega,
                             int channels)
    : hierarchy_(hierarchy),
      groups_(groups),
      levels_(std::min(levels, hierarchy.levels())),
      epsilon_omega_(static_cast<float>(epsilon_omega)),
      channels_(static_cast<std::uint32_t>(channels)),
      rows_(hierarchy.level_begin(levels_)) {}

void TransportRows::keep(std::uint32_t point, const Gatherer& gatherer, GatherBuffers& buffers) {
  Sums sums(rows_.size());
  const float share = 1.0F / static_cast<float>(gatherer.rays());
  for (std::size_t i = 0; i < buffers.lit.size(); ++i)
    if (!add_hit(buffers.lit[i], hierarchy_.position(point), buffers.albedos[i] * share, sums)) ++buffers.counts.uncovered;
  std::sort(sums.met.begin(), sums.met.end());
  Row& row = rows_[point];
  row.reflectance = gatherer.reflectance(buffers);
  row.senders.assign(sums.met.begin(), sums.met.end());
  row.weights.reserve(row.senders.size() * channels_);
  for (const std::uint32_t sender : row.senders)
    for (std::uint32_t channel = 0; channel < channels_; ++channel)
      row.weights.push_back(sums.weights[sender][static_cast<int>(channel)]);
}

/// The levels as Expansion::evaluate_seen takes them: down to balls of the threshold's solid angle. False: none covers the hit.
bool TransportRows::add_hit(const SurfaceSample& hit, const Vec3& receiver, const Rgb& share, Sums& sums) const {
  const Place at{hit.position, hit.normal, groups_.of(hit)};
  bool covered = false;
  for (std::uint32_t level = 0; level < levels_; ++level) {
    sums.covering.clear();
    float weights = 0.0F, angles = 0.0F;
    hierarchy_.visit_covering(level, at, [&](std::uint32_t sender, float weight) {
      sums.covering.emplace_back(sender, weight);
      weights += weight;
      angles += solid_angle(hierarchy_.radius(sender), hierarchy_.position(sender) - receiver);
    });
    if (sums.covering.empty()) continue;
    covered = true;
    for (const auto& [sender, weight] : sums.covering) sums.add(sender, share * (weight / weights));
    if (angles < epsilon_omega_ * static_cast<float>(sums.covering.size())) break;
  }
  return covered || hierarchy_.covered(at);
}

std::vector<Estimate> TransportRows::apply(const Coefficients& sent, Task& task) const {
  std::vector<Rgb> values(rows_.size());
  for (std::uint32_t point = 0; point < values.size(); ++point) values[point] = sent[point];
  std::vector<Estimate> arriving(rows_.size());
  task.parallel_chunks(rows_.size(), row_chunk, [&](const ChunkRange& range) {
    for (std::size_t point = range.begin; point < range.end; ++point) arriving[point] = irradiance(rows_[point], values);
  });
  return arriving;
}

Estimate TransportRows::irradiance(const Row& row, const std::vector<Rgb>& sent) const {
  Estimate made;
  if (channels_ == 1) {
    float sum = 0.0F;
    for (std::size_t i = 0; i < row.senders.size(); ++i) sum += row.weights[i] * sent[row.senders[i]].r;
    made.value = Rgb(sum);
  } else {
    for (std::size_t i = 0; i < row.senders.size(); ++i) {
      const float* weight = &row.weights[3 * i];
      made.value += Rgb(weight[0], weight[1], weight[2]) * sent[row.senders[i]];
    }
  }
  const float reflected = largest(row.reflectance.value);
  if (reflected > 0.0F) made.deviation = row.reflectance.deviation * std::max(0.0F, largest(made.value)) / reflected;
  return made;
}

std::size_t TransportRows::links() const {
  std::size_t sum = 0;
  for (const Row& row : rows_) sum += row.senders.size();
  return sum;
}

std::size_t TransportRows::bytes() const {
  std::size_t sum = rows_.capacity() * sizeof(Row);
  for (const Row& row : rows_) sum += row.senders.capacity() * sizeof(std::uint32_t) + row.weights.capacity() * sizeof(float);
  return sum;
}

}  // namespace gibench::meshless
