#include "methods/wavelet/global_operator.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

namespace gibench::wavelet {

namespace {

constexpr std::size_t row_chunk = 64, made_chunk = 8;  // rows that are multiplied, and that are made

using Square = std::array<std::array<Rgb, child_count>, child_count>;  ///< slots of a receiver × slots of a sender

float largest_of(const Square& square) {
  float largest = 0.0F;
  for (const auto& row : square)
    for (const Rgb& value : row) largest = std::max({largest, std::fabs(value.r), std::fabs(value.g), std::fabs(value.b)});
  return largest;
}

double squares_of(const Square& square) {
  double sum = 0.0;
  for (const auto& row : square)
    for (const Rgb& value : row) sum += static_cast<double>(value.r * value.r + value.g * value.g + value.b * value.b);
  return sum;
}

/// Squares by sender, most of them zero.
class SparseRow {
 public:
  explicit SparseRow(std::size_t groups) : place_(groups, none) {}

  /// Stays where it is until at() is called again.
  Square& at(std::uint32_t group) {
    if (place_[group] == none) {
      place_[group] = static_cast<std::uint32_t>(squares_.size());
      touched_.push_back(group);
      squares_.emplace_back();
    }
    return squares_[place_[group]];
  }
  bool empty() const { return touched_.empty(); }
  void sort() { std::sort(touched_.begin(), touched_.end()); }
  std::span<const std::uint32_t> groups() const { return touched_; }
  const Square& operator[](std::uint32_t group) const { return squares_[place_[group]]; }
  double squares() const {
    double sum = 0.0;
    for (const std::uint32_t group : touched_) sum += squares_of((*this)[group]);
    return sum;
  }

  /// Leaves out what has no coefficient above the threshold.
  void compress(double threshold) {
    std::erase_if(touched_, [&](std::uint32_t group) {
      const bool small = static_cast<double>(largest_of((*this)[group])) <= threshold;
      if (small) place_[group] = none;
      return small;
    });
  }
  void clear() {
    for (const std::uint32_t group : touched_) place_[group] = none;
    touched_.clear();
    squares_.clear();
  }

 private:
  std::vector<Square> squares_;
  std::vector<std::uint32_t> place_, touched_;  ///< place in squares_ of every group; those that have one
};

}  // namespace

struct GlobalOperator::Rows {
  std::vector<std::uint32_t> counts, senders;
  std::vector<Rgb> coefficients;
  std::vector<PowerCount> powers;
  std::size_t bytes() const {
    return (counts.capacity() + senders.capacity()) * sizeof(std::uint32_t) + coefficients.capacity() * sizeof(Rgb);
  }
};

class GlobalOperator::RowMaker {
 public:
  RowMaker(const Elements& elements, const TransportOperator& direct, std::span<const Rgb> reflectance, const SeriesRule& rule,
           const Task& task)
      : elements_(elements),
        direct_(direct),
        reflectance_(reflectance),
        rule_(rule),
        task_(task),
        power_(elements.groups().size()),
        next_(elements.groups().size()),
        sum_(elements.groups().size()) {}

  void make(std::uint32_t receiver, Rows& out) {
    const Group& to = elements_.groups()[receiver];
    // The first power is a row of the unit matrix times the direct operator.
    Square unit{};
    for (std::size_t k = to.first; k < to.end; ++k) unit[k][k] = Rgb(1.0F);
    multiply(to, receiver, unit, next_);
    for (int power = 0; power < rule_.most_powers && !task_.cancelled(); ++power) {
      next_.sort();
      finish_power(power, to, out);
      std::swap(power_, next_);
      next_.clear();
      if (power_.empty()) break;
      for (const std::uint32_t group : power_.groups()) add(power_[group], sum_.at(group));
      if (power + 1 == rule_.most_powers || std::sqrt(power_.squares()) < rounding * std::sqrt(sum_.squares())) break;
      for (const std::uint32_t group : power_.groups()) multiply(to, group, power_[group], next_);
    }
    store(to, out);
    power_.clear();
    next_.clear();
    sum_.clear();
  }

 private:
  static constexpr double rounding = std::numeric_limits<float>::epsilon();

  /// Adds the square, which has `via` as its sender, times the direct operator's row of `via`.
  void multiply(const Group& to, std::uint32_t via, const Square& square, SparseRow& result) {
    const Group& middle = elements_.groups()[via];
    direct_.each_link(elements_, via, [&](std::uint32_t sender, std::span<const float> link) {
      const Group& from = elements_.groups()[sender];
      Square& sum = result.at(sender);
      const float* next = link.data();
      for (std::size_t j = middle.first; j < middle.end; ++j)
        for (std::size_t i = from.first; i < from.end; ++i, ++next)
          for (std::size_t k = to.first; k < to.end; ++k) sum[k][i] += square[k][j] * *next;
    });
  }

  /// Reflects at the senders, and compresses.
  void finish_power(int power, const Group& to, Rows& out) {
    for (const std::uint32_t group : next_.groups()) {
      const Rgb& albedo = reflectance_[elements_.nodes()[elements_.groups()[group].node].element];
      for (auto& row : next_.at(group))
        for (Rgb& value : row) value *= albedo;
    }
    next_.compress(rule_.threshold);
    if (next_.empty()) return;
    if (out.powers.size() <= static_cast<std::size_t>(power)) out.powers.resize(static_cast<std::size_t>(power) + 1);
    PowerCount& count = out.powers[static_cast<std::size_t>(power)];
    count.links += next_.groups().size();
    count.squares += next_.squares();
    for (const std::uint32_t group : next_.groups()) count.coefficients += to.functions() * elements_.groups()[group].functions();
  }

  static void add(const Square& from, Square& to) {
    for (std::size_t k = 0; k < child_count; ++k)
      for (std::size_t i = 0; i < child_count; ++i) to[k][i] += from[k][i];
  }

  void store(const Group& to, Rows& out) {
    sum_.sort();
    out.counts.push_back(static_cast<std::uint32_t>(sum_.groups().size()));
    for (const std::uint32_t group : sum_.groups()) {
      const Group& from = elements_.groups()[group];
      out.senders.push_back(group);
      for (std::size_t k = to.first; k < to.end; ++k)
        for (std::size_t i = from.first; i < from.end; ++i) out.coefficients.push_back(sum_[group][k][i]);
    }
  }

  const Elements& elements_;
  const TransportOperator& direct_;
  std::span<const Rgb> reflectance_;
  const SeriesRule& rule_;
  const Task& task_;
  SparseRow power_, next_, sum_;
};

GlobalOperator::GlobalOperator(const Elements& elements, const TransportOperator& direct, std::span<const Rgb> reflectance,
                               const SeriesRule& rule, Task& task) {
  const std::size_t groups = elements.groups().size();
  std::vector<Rows> parts(chunk_count(groups, made_chunk));
  // Twice: the parts, and what they are put into.
  std::atomic<std::size_t> bytes{0};
  const auto passes = [&] { return 2 * bytes.load(std::memory_order_relaxed) > rule.most_bytes; };
  task.parallel_chunks(groups, made_chunk, [&](const ChunkRange& range) {
    if (passes()) return;
    RowMaker maker(elements, direct, reflectance, rule, task);
    for (std::size_t group = range.begin; group < range.end && !task.cancelled(); ++group)
      maker.make(static_cast<std::uint32_t>(group), parts[range.chunk]);
    bytes.fetch_add(parts[range.chunk].bytes(), std::memory_order_relaxed);
  });
  refused_ = passes();
  if (refused_ || task.cancelled()) return;
  row_begin_.assign(1, 0);
  for (Rows& part : parts) {
    for (const std::uint32_t count : part.counts) row_begin_.push_back(row_begin_.back() + count);
    senders_.insert(senders_.end(), part.senders.begin(), part.senders.end());
    coefficients_.insert(coefficients_.end(), part.coefficients.begin(), part.coefficients.end());
    if (powers_.size() < part.powers.size()) powers_.resize(part.powers.size());
    for (std::size_t p = 0; p < part.powers.size(); ++p) {
      powers_[p].links += part.powers[p].links;
      powers_[p].coefficients += part.powers[p].coefficients;
      powers_[p].squares += part.powers[p].squares;
    }
    part = {};
  }
  std::size_t at = 0;
  for (std::size_t receiver = 0; receiver < groups; ++receiver) {
    coefficient_begin_.push_back(at);
    for (std::uint32_t link = row_begin_[receiver]; link < row_begin_[receiver + 1]; ++link)
      at += elements.groups()[receiver].functions() * elements.groups()[senders_[link]].functions();
  }
}

void GlobalOperator::apply(const Elements& elements, std::span<const Rgb> in, std::span<Rgb> out, Task& task) const {
  const std::span groups = elements.groups();
  task.parallel_chunks(groups.size(), row_chunk, [&](const ChunkRange& range) {
    for (std::size_t receiver = range.begin; receiver < range.end; ++receiver) {
      const Group& to = groups[receiver];
      std::array<Rgb, child_count> sum{};
      const Rgb* next = coefficients_.data() + coefficient_begin_[receiver];
      for (std::uint32_t link = row_begin_[receiver]; link < row_begin_[receiver + 1]; ++link) {
        const Group& from = groups[senders_[link]];
        for (std::size_t k = to.first; k < to.end; ++k)
          for (std::size_t i = from.first; i < from.end; ++i) sum[k] += in[senders_[link] * child_count + i] * *next++;
      }
      for (std::size_t k = 0; k < child_count; ++k) out[receiver * child_count + k] = sum[k];
    }
  });
}

std::size_t GlobalOperator::bytes() const {
  return (row_begin_.capacity() + senders_.capacity()) * sizeof(std::uint32_t) +
         coefficient_begin_.capacity() * sizeof(std::size_t) + coefficients_.capacity() * sizeof(Rgb);
}

}  // namespace gibench::wavelet
