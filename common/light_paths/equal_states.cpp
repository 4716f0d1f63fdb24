#include "common/light_paths/equal_states.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace gibench {

namespace {

/// States by one event backwards: those that lead to a state lie together.
class Predecessors {
 public:
  Predecessors(const Followers& next, std::size_t event) : begin_(next.size() + 1, 0), states_(next.size()) {
    for (const auto& followers : next) ++begin_[followers[event] + std::size_t{1}];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<std::uint32_t> place(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t state = 0; state < next.size(); ++state) states_[place[next[state][event]]++] = state;
  }

  template <class Visit>
  void for_each(std::uint32_t state, const Visit& visit) const {
    for (std::uint32_t i = begin_[state]; i < begin_[state + 1]; ++i) visit(states_[i]);
  }

 private:
  std::vector<std::uint32_t> begin_, states_;
};

/// States in parts, which lie one after another in one list: marked ones come first, and can be split off.
class Partition {
 public:
  explicit Partition(const std::vector<std::uint32_t>& kind) : order_(kind.size()), place_(kind.size()), part_(kind.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    std::stable_sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) { return kind[a] < kind[b]; });
    for (std::uint32_t i = 0; i < order_.size(); ++i) {
      if (i == 0 || kind[order_[i]] != kind[order_[i - 1]]) parts_.push_back({i, i, 0});
      parts_.back().end = i + 1;
      place_[order_[i]] = i;
      part_[order_[i]] = static_cast<std::uint32_t>(parts_.size() - 1);
    }
  }

  std::size_t size() const { return parts_.size(); }
  std::uint32_t size_of(std::uint32_t part) const { return parts_[part].end - parts_[part].begin; }
  std::vector<std::uint32_t> states_of(std::uint32_t part) const {
    return {order_.begin() + parts_[part].begin, order_.begin() + parts_[part].end};
  }
  const std::vector<std::uint32_t>& part_of_states() const { return part_; }

  /// Once for each state until its part is split.
  void mark(std::uint32_t state, std::vector<std::uint32_t>& touched) {
    Part& part = parts_[part_[state]];
    if (part.marked++ == 0) touched.push_back(part_[state]);
    const std::uint32_t to = part.begin + part.marked - 1, from = place_[state];
    std::swap(order_[to], order_[from]);
    place_[order_[from]] = from;
    place_[state] = to;
  }

  /// Takes the marks away. Those that were marked become a new part where others stay behind: whether they do.
  bool split(std::uint32_t number) {
    const Part whole = parts_[number];
    parts_[number].marked = 0;
    if (whole.marked == whole.end - whole.begin) return false;
    const std::uint32_t middle = whole.begin + whole.marked;
    parts_[number].begin = middle;
    for (std::uint32_t i = whole.begin; i < middle; ++i) part_[order_[i]] = static_cast<std::uint32_t>(parts_.size());
    parts_.push_back({whole.begin, middle, 0});
    return true;
  }

 private:
  struct Part {
    std::uint32_t begin = 0, end = 0, marked = 0;
  };
  std::vector<std::uint32_t> order_, place_, part_;
  std::vector<Part> parts_;
};

}  // namespace

std::vector<std::uint32_t> parts_of_equal_states(const Followers& next, const std::vector<std::uint32_t>& kind) {
  std::vector<Predecessors> before;
  for (std::size_t event = 0; event < scattering_events.size(); ++event) before.emplace_back(next, event);
  Partition partition(kind);
  std::vector<std::uint32_t> open(partition.size()), touched;
  std::iota(open.begin(), open.end(), 0U);
  std::vector<bool> is_open(partition.size(), true);
  while (!open.empty()) {
    const std::uint32_t splitter = open.back();
    open.pop_back();
    is_open[splitter] = false;
    const std::vector<std::uint32_t> into = partition.states_of(splitter);  // as it is now: it may be split below
    for (const Predecessors& predecessors : before) {
      touched.clear();
      for (const std::uint32_t state : into)
        predecessors.for_each(state, [&](std::uint32_t earlier) { partition.mark(earlier, touched); });
      for (const std::uint32_t part : touched) {
        if (!partition.split(part)) continue;
        const auto made = static_cast<std::uint32_t>(partition.size() - 1);
        const bool takes_new = is_open[part] || partition.size_of(made) < partition.size_of(part);
        is_open.push_back(takes_new);
        open.push_back(takes_new ? made : part);
        if (!takes_new) is_open[part] = true;
      }
    }
  }
  return partition.part_of_states();
}

}  // namespace gibench
