#include "common/spaces/proximity_joins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "common/core/error.h"
#include "common/spaces/place_tree.h"

namespace gibench {

namespace {

constexpr std::uint32_t none = 0xffffffffU;
constexpr int doublings = 8;
constexpr std::array<float, 2> least_cosines{0.8F, 0.3F};
constexpr std::size_t places_a_chunk = 1024;

/// What has been joined to one, and its area.
class Pieces {
 public:
  Pieces(std::span<const Place> places, std::span<const std::uint32_t> piece) : of_place_(places.size()) {
    std::vector<std::uint32_t> order(places.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return piece[a] < piece[b]; });
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i == 0 || piece[order[i]] != piece[order[i - 1]]) parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
      of_place_[order[i]] = static_cast<std::uint32_t>(parent_.size() - 1);
    }
    area_.assign(parent_.size(), 0.0);
    for (std::size_t i = 0; i < places.size(); ++i) area_[of_place_[i]] += static_cast<double>(places[i].area);
    total_area_ = std::accumulate(area_.begin(), area_.end(), 0.0);
    count_ = parent_.size();
  }

  std::size_t count() const { return count_; }
  double total_area() const { return total_area_; }
  /// Places know their piece directly once this was called after joins.
  void settle() {
    for (std::uint32_t& own : of_place_) own = root(own);
  }
  std::uint32_t of_place(std::uint32_t place) const { return of_place_[place]; }  ///< as last settled
  double area(std::uint32_t of_root) const { return area_[of_root]; }
  std::size_t most_numbers() const { return parent_.size(); }
  bool join(std::uint32_t a, std::uint32_t b) {
    a = root(a), b = root(b);
    if (a == b) return false;
    if (std::pair(area_[a], b) < std::pair(area_[b], a)) std::swap(a, b);
    parent_[b] = a;
    area_[a] += area_[b];
    --count_;
    return true;
  }

 private:
  std::uint32_t root(std::uint32_t of) {
    while (parent_[of] != of) of = parent_[of] = parent_[parent_[of]];
    return of;
  }

  std::vector<std::uint32_t> of_place_, parent_;
  std::vector<double> area_;
  double total_area_ = 0.0;
  std::size_t count_ = 0;
};

/// Bounds of one round.
struct Reach {
  float distance, least_cosine;
};

/// The nearest place of another piece that a place found.
struct Found {
  float distance = std::numeric_limits<float>::infinity();
  std::uint32_t from = none, to = none;
  bool operator<(const Found& o) const { return std::tie(distance, from, to) < std::tie(o.distance, o.from, o.to); }
};

/// Normals as a cone.
struct Cone {
  Vec3 axis{0.0F};
  float angle = pi;  ///< no normal is further from the axis
};

float angle_between(const Vec3& a, const Vec3& b) { return std::acos(std::clamp(glm::dot(a, b), -1.0F, 1.0F)); }

Cone cone_around(const Cone& a, const Cone& b) {
  const Vec3 sum = a.axis + b.axis;
  const float length = glm::length(sum);
  if (!(length > 1e-3F)) return {};
  const Vec3 axis = sum / length;
  return {axis, std::max(angle_between(axis, a.axis) + a.angle, angle_between(axis, b.axis) + b.angle)};
}

/// Searches over the trees, whose nodes know whether they are of one piece alone.
class NearestOthers {
 public:
  NearestOthers(std::span<const Place> places, const PlaceTree& tree, Pieces& pieces)
      : places_(places),
        tree_(tree),
        pieces_(pieces),
        piece_of_node_(tree.nodes().size()),
        cones_(tree.nodes().size()),
        root_of_place_(places.size()) {
    for (std::size_t i = cones_.size(); i-- > 0;) {  // children come after parents
      const PlaceNode& node = tree.nodes()[i];
      cones_[i] =
          node.is_leaf() ? Cone{places[tree.order()[node.begin]].normal, 0.0F} : cone_around(cones_[i + 1], cones_[node.right]);
    }
    for (const std::uint32_t root : tree.roots())
      for (std::uint32_t i = tree.nodes()[root].begin; i < tree.nodes()[root].end; ++i) root_of_place_[tree.order()[i]] = root;
    settle();
  }

  /// After joins.
  void settle() {
    pieces_.settle();
    const auto nodes = tree_.nodes();
    for (std::size_t i = nodes.size(); i-- > 0;) {
      const PlaceNode& node = nodes[i];
      if (node.is_leaf()) piece_of_node_[i] = pieces_.of_place(tree_.order()[node.begin]);
      else piece_of_node_[i] = piece_of_node_[i + 1] == piece_of_node_[node.right] ? piece_of_node_[node.right] : none;
    }
  }

  /// What the pieces that ask find, the best of each, by piece.
  template <class Asks>
  std::vector<Found> search(const Reach& reach, const Asks& asks, Task& task) {
    std::vector<Found> of_place(places_.size());
    std::vector<std::uint64_t> visited(chunk_count(places_.size(), places_a_chunk));
    task.parallel_chunks(places_.size(), places_a_chunk, [&](const ChunkRange& range) {
      std::vector<std::uint32_t> stack;
      for (std::size_t i = range.begin; i < range.end; ++i) {  // neighbours after one another
        const std::uint32_t place = tree_.order()[i];
        if (asks(pieces_.of_place(place))) of_place[place] = nearest(place, reach, stack, visited[range.chunk]);
      }
    });
    visits_ = std::accumulate(visited.begin(), visited.end(), visits_);
    std::vector<Found> best(pieces_.most_numbers());
    for (std::uint32_t i = 0; i < places_.size(); ++i)
      if (of_place[i].to != none) best[pieces_.of_place(i)] = std::min(best[pieces_.of_place(i)], of_place[i]);
    return best;
  }

  std::uint64_t visits() const { return visits_; }

 private:
  float distance_to(const Vec3& position, const PlaceNode& node) const {
    return glm::length(node.centre - position) - 1.00001F * node.radius;
  }

  Found nearest(std::uint32_t asking, const Reach& reach, std::vector<std::uint32_t>& stack, std::uint64_t& visited) const {
    const Place& own = places_[asking];
    const std::uint32_t own_piece = pieces_.of_place(asking);
    const float widest = std::acos(reach.least_cosine) + 1e-3F;
    Found best;
    float within = reach.distance;
    stack.assign(1, root_of_place_[asking]);
    while (!stack.empty()) {
      const std::uint32_t index = stack.back();
      stack.pop_back();
      ++visited;
      const PlaceNode& node = tree_.nodes()[index];
      if (piece_of_node_[index] == own_piece || distance_to(own.position, node) > within) continue;
      if (node.is_leaf()) {
        const std::uint32_t other = tree_.order()[node.begin];
        const Found found{glm::length(places_[other].position - own.position), asking, other};
        if (found.distance <= within && glm::dot(own.normal, places_[other].normal) >= reach.least_cosine && found < best)
          best = found, within = found.distance;
        continue;
      }
      if (angle_between(own.normal, cones_[index].axis) > widest + cones_[index].angle) continue;
      const bool left_first =
          distance_to(own.position, tree_.nodes()[index + 1]) <= distance_to(own.position, tree_.nodes()[node.right]);
      stack.push_back(left_first ? node.right : index + 1);
      stack.push_back(left_first ? index + 1 : node.right);
    }
    return best;
  }

  std::span<const Place> places_;
  const PlaceTree& tree_;
  Pieces& pieces_;
  std::vector<std::uint32_t> piece_of_node_;  ///< none: of several
  std::vector<Cone> cones_;                   ///< of every node
  std::vector<std::uint32_t> root_of_place_;
  std::uint64_t visits_ = 0;
};

/// Joins what finds something within reach, the smallest first, until nothing does or few enough are left.
class Joining {
 public:
  Joining(std::span<const Place> places, Pieces pieces, std::size_t wanted, const PlaceTree& tree)
      : wanted_(wanted), pieces_(std::move(pieces)), others_(places, tree, pieces_) {}

  bool is_done() const { return pieces_.count() <= wanted_; }

  void join_within(const Reach& reach, Task& task) {
    const double own_share = pieces_.total_area() / static_cast<double>(wanted_);
    bool joined = true;
    while (joined && !is_done() && !task.cancelled()) {
      const std::vector<Found> found = others_.search(
          reach, [&](std::uint32_t asking) { return pieces_.area(asking) <= own_share; }, task);
      joined = join_smallest_first(found);
      if (joined) others_.settle();
    }
  }

  std::vector<Join> take_joins() { return std::move(joins_); }
  std::uint64_t visits() const { return others_.visits(); }

 private:
  bool join_smallest_first(const std::vector<Found>& found) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < found.size(); ++i)
      if (found[i].to != none) order.push_back(i);
    std::vector<double> area(found.size());
    for (const std::uint32_t i : order) area[i] = pieces_.area(i);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return std::pair(area[a], found[a]) < std::pair(area[b], found[b]); });
    bool joined = false;
    for (const std::uint32_t i : order) {
      if (is_done()) break;
      if (!pieces_.join(i, pieces_.of_place(found[i].to))) continue;
      joins_.push_back({found[i].from, found[i].to});
      joined = true;
    }
    return joined;
  }

  std::size_t wanted_;
  Pieces pieces_;
  NearestOthers others_;
  std::vector<Join> joins_;
};

}  // namespace

std::vector<Join> join_small_pieces(std::span<const Place> places, std::span<const std::uint32_t> piece,
                                    std::size_t pieces_wanted, float first_distance, Task& task) {
  GIBENCH_CHECK(piece.size() == places.size(), "one piece for each place");
  const std::size_t wanted = std::max<std::size_t>(1, pieces_wanted);
  Pieces pieces(places, piece);
  if (pieces.count() <= wanted) return {};
  const PlaceTree tree(places, task);
  if (task.cancelled()) return {};
  Joining joining(places, std::move(pieces), wanted, tree);
  float distance = first_distance;
  for (int doubling = 0; doubling <= doublings && !joining.is_done(); ++doubling, distance *= 2.0F)
    for (const float least_cosine : least_cosines) joining.join_within({distance, least_cosine}, task);
  joining.join_within({0.5F * distance, 0.0F}, task);
  std::vector<Join> joins = joining.take_joins();
  task.count("join_visits", joining.visits());
  task.count("piece_joins", joins.size());
  return joins;
}

}  // namespace gibench
