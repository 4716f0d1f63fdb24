#include "common/geometry/poisson_disc.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "common/core/error.h"
#include "common/core/parallel.h"
#include "common/core/random.h"

namespace gibench {

namespace {

constexpr std::uint64_t stage_key = 0x706f6973736f6eULL;
constexpr std::size_t smallest_batch = 1024, largest_batch = 32768;  // darts
constexpr std::size_t chunk = 512;                                   // darts
constexpr std::uint32_t none = 0xffffffffU;

}  // namespace

/// Hash grid of cells twice the radius wide: a disc reaches into at most eight of them. Samples lie bucket by
/// bucket, so that a cell costs one look-up and one run of memory; those kept since the last rebuild wait in
/// chains. The distance test itself separates cells that share a bucket.
struct PoissonDisc::Grid {
  struct Sample {
    Vec3 position, normal;
  };

  Vec3 origin;
  float radius, cells_per_metre;
  std::vector<std::uint32_t> first;  ///< into `samples`, of each bucket and one more
  std::vector<Sample> samples;
  std::vector<std::uint32_t> recent_heads;  ///< of each bucket of a smaller table
  std::vector<Sample> recent;
  std::vector<std::uint32_t> recent_next;

  Grid(const Vec3& low, float disc_radius, const std::vector<DiscPoint>& points)
      : origin(low), radius(disc_radius), cells_per_metre(0.5F / disc_radius) {
    rebuild(points);
  }

  /// A cell's number along an axis; discs may be so small beside the scene that it does not fit into 32 bits.
  static std::int64_t whole(float cell) { return static_cast<std::int64_t>(std::clamp(cell, -1e18F, 1e18F)); }
  static std::uint32_t hash(std::int64_t x, std::int64_t y, std::int64_t z) {
    const std::uint32_t mixed = static_cast<std::uint32_t>(x) * 0x8da6b343U ^ static_cast<std::uint32_t>(y) * 0xd8163841U ^
                                static_cast<std::uint32_t>(z) * 0xcb1ab31fU;
    return mixed ^ (mixed >> 15);
  }
  Vec3 cell_coordinates(const Vec3& position) const { return (position - origin) * cells_per_metre; }
  std::uint32_t hash_of(const Vec3& position) const {
    const Vec3 cell = glm::floor(cell_coordinates(position));
    return hash(whole(cell.x), whole(cell.y), whole(cell.z));
  }

  void insert(const DiscPoint& point) {
    std::uint32_t& head = recent_heads[hash_of(point.position) & (recent_heads.size() - 1)];
    recent_next.push_back(head);
    head = static_cast<std::uint32_t>(recent.size());
    recent.push_back({point.position, point.normal});
  }
  bool wants_rebuild() const { return recent.size() > 256 + samples.size() / 4; }

  void rebuild(const std::vector<DiscPoint>& points) {
    const std::size_t buckets = std::bit_ceil(std::max<std::size_t>(64, points.size()));
    first.assign(buckets + 1, 0);
    for (const DiscPoint& point : points) ++first[(hash_of(point.position) & (buckets - 1)) + 1];
    for (std::size_t i = 0; i < buckets; ++i) first[i + 1] += first[i];
    samples.resize(points.size());
    std::vector<std::uint32_t> at(first.begin(), first.end() - 1);
    for (const DiscPoint& point : points) samples[at[hash_of(point.position) & (buckets - 1)]++] = {point.position, point.normal};
    recent.clear();
    recent_next.clear();
    recent_heads.assign(std::max<std::size_t>(512, buckets / 2), none);
  }

  static bool too_near(const Sample& sample, const DiscPoint& point, float radius_squared) {
    const Vec3 apart = sample.position - point.position;
    const float distance_squared = glm::dot(apart, apart);
    if (distance_squared >= radius_squared) return false;
    const float cosine = glm::dot(sample.normal, point.normal);
    return cosine > 0.0F && distance_squared < radius_squared * cosine * cosine;
  }

  bool conflicts_in(std::uint32_t cell_hash, const DiscPoint& point) const {
    const float radius_squared = radius * radius;
    const std::size_t bucket = cell_hash & (first.size() - 2);
    for (std::uint32_t i = first[bucket]; i < first[bucket + 1]; ++i)
      if (too_near(samples[i], point, radius_squared)) return true;
    return !recent.empty() && conflicts_with_recent(cell_hash, point);
  }
  bool conflicts_with_recent(std::uint32_t cell_hash, const DiscPoint& point) const {
    for (std::uint32_t i = recent_heads[cell_hash & (recent_heads.size() - 1)]; i != none; i = recent_next[i])
      if (too_near(recent[i], point, radius * radius)) return true;
    return false;
  }

  /// Calls test(hash) for the up to eight cells that the point's disc reaches, its own first, until one is true.
  template <class Test>
  bool any_cell(const DiscPoint& point, Test&& test) const {
    const Vec3 coordinates = cell_coordinates(point.position);
    const Vec3 home = glm::floor(coordinates);
    const Vec3 inside = coordinates - home;
    const std::int64_t x = whole(home.x), y = whole(home.y), z = whole(home.z);
    const std::int64_t dx = inside.x < 0.5F ? -1 : 1, dy = inside.y < 0.5F ? -1 : 1, dz = inside.z < 0.5F ? -1 : 1;
    for (int corner = 0; corner < 8; ++corner)
      if (test(hash(x + ((corner & 1) != 0 ? dx : 0), y + ((corner & 2) != 0 ? dy : 0), z + ((corner & 4) != 0 ? dz : 0))))
        return true;
    return false;
  }
  bool conflicts(const DiscPoint& point) const {
    return any_cell(point, [&](std::uint32_t cell_hash) { return conflicts_in(cell_hash, point); });
  }
};

PoissonDisc::PoissonDisc(const World& world, std::vector<SurfaceSide> sides, PoissonDiscOptions options)
    : world_(world), sides_(std::move(sides)), options_(std::move(options)) {
  std::erase_if(sides_, [&](const SurfaceSide& side) { return !(world_.area(side.triangle) > 0.0F); });
  for (const SurfaceSide& side : sides_) area_ += static_cast<double>(world_.area(side.triangle));
  build_alias_table();
}

/// Vose's alias method: a side by its area in constant time.
void PoissonDisc::build_alias_table() {
  const std::size_t count = sides_.size();
  alias_.resize(count);
  std::vector<double> share(count);
  std::vector<std::uint32_t> small, large;
  for (std::uint32_t i = 0; i < count; ++i) {
    share[i] = static_cast<double>(world_.area(sides_[i].triangle)) * static_cast<double>(count) / area_;
    (share[i] < 1.0 ? small : large).push_back(i);
  }
  while (!small.empty() && !large.empty()) {
    const std::uint32_t poor = small.back(), rich = large.back();
    small.pop_back();
    alias_[poor] = {static_cast<float>(share[poor]), rich};
    share[rich] -= 1.0 - share[poor];
    if (share[rich] < 1.0) {
      large.pop_back();
      small.push_back(rich);
    }
  }
  for (std::uint32_t i : small) alias_[i] = {1.0F, i};
  for (std::uint32_t i : large) alias_[i] = {1.0F, i};
}

DiscPoint PoissonDisc::propose(std::uint64_t number) const {
  RandomStream random(options_.seed, stage_key, number);
  const double slot = random.next_double() * static_cast<double>(alias_.size());
  std::size_t index = std::min(static_cast<std::size_t>(slot), alias_.size() - 1);
  if (random.next_float() >= alias_[index].threshold) index = alias_[index].other;
  const float root = std::sqrt(random.next_float());
  const float second = random.next_float();
  const SurfaceSide& side = sides_[index];
  const Vec3& normal = world_.normal(side.triangle);
  return {world_.position(side.triangle, {root * (1.0F - second), root * second}), side.front ? normal : -normal, side};
}

/// Throws a batch and marks the darts that no sample kept so far and no test turns down.
void PoissonDisc::test_batch(std::vector<DiscPoint>& darts, std::vector<std::uint8_t>& alive, const Grid& grid) const {
  parallel_chunks(options_.threads, darts.size(), chunk, [&](const ChunkRange& range) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      darts[i] = propose(proposals_ + i);
      alive[i] = grid.conflicts(darts[i]) ? 0 : 1;
    }
  });
  if (!options_.test) return;
  std::vector<DiscPoint> survivors;
  for (std::size_t i = 0; i < darts.size(); ++i)
    if (alive[i] != 0) survivors.push_back(darts[i]);
  std::vector<std::uint8_t> keep(survivors.size(), 1);
  options_.test(survivors, keep);
  for (std::size_t i = 0, survivor = 0; i < darts.size(); ++i)
    if (alive[i] != 0) alive[i] = keep[survivor++];
}

std::vector<DiscPoint> PoissonDisc::add_level(float radius) {
  GIBENCH_CHECK(radius > 0.0F, "a disc has a positive radius");
  const std::size_t first = kept_.size();
  if (sides_.empty()) return {};
  Grid grid(world_.bounds_min(), radius, kept_);
  std::vector<DiscPoint> darts;
  std::vector<std::uint8_t> alive;
  int failed_in_a_row = 0;
  while (failed_in_a_row < options_.failures && !(options_.cancelled && options_.cancelled())) {
    darts.resize(std::clamp(std::bit_ceil(kept_.size() / 2), smallest_batch, largest_batch));
    alive.resize(darts.size());
    test_batch(darts, alive, grid);
    std::size_t i = 0;
    if (grid.wants_rebuild()) grid.rebuild(kept_);
    const std::size_t recent_before = grid.recent.size();
    for (; i < darts.size() && failed_in_a_row < options_.failures; ++i) {
      // Only samples of this batch are news to a dart that is still alive.
      const auto conflicts_now = [&](std::uint32_t cell_hash) { return grid.conflicts_with_recent(cell_hash, darts[i]); };
      if (alive[i] == 0 || (grid.recent.size() > recent_before && grid.any_cell(darts[i], conflicts_now))) {
        ++failed_in_a_row;
        continue;
      }
      failed_in_a_row = 0;
      kept_.push_back(darts[i]);
      grid.insert(darts[i]);
    }
    proposals_ += i;
  }
  return {kept_.begin() + static_cast<std::ptrdiff_t>(first), kept_.end()};
}

std::vector<SurfaceSide> lit_sides(const World& world, std::span<const std::uint8_t> wanted) {
  const Scene& scene = world.scene();
  GIBENCH_CHECK(wanted.size() == scene.objects.size(), "one entry for each object");
  std::vector<SurfaceSide> sides;
  for (std::uint32_t object = 0; object < scene.objects.size(); ++object) {
    if (wanted[object] == 0) continue;
    const Object& o = scene.objects[object];
    for (std::uint32_t triangle = o.triangle_begin; triangle < o.triangle_end; ++triangle) {
      sides.push_back({triangle, true});
      if (o.two_sided) sides.push_back({triangle, false});
    }
  }
  return sides;
}

}  // namespace gibench
