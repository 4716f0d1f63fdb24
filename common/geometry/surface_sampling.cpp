#include "common/geometry/surface_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "common/core/parallel.h"
#include "common/core/random.h"

namespace gibench {

namespace {

constexpr std::uint64_t stage_key = 0x73616d706c6573ULL;
constexpr int most_draws = 1000;  // of one sample
constexpr std::size_t chunk_size = 64;

/// A part of one side of a triangle.
struct Piece {
  std::uint32_t triangle;
  bool front;
  std::array<Vec2, 3> corners;  ///< barycentrics
};

constexpr std::array<Vec2, 3> whole_triangle{Vec2(0.0F, 0.0F), Vec2(1.0F, 0.0F), Vec2(0.0F, 1.0F)};
constexpr int most_cuts = 16;  // in four, of one triangle

/// Pieces of the sides that light can leave, and their cumulative area.
class Pieces {
 public:
  Pieces(const World& world, const SampledPart& part) : world_(world), part_(part) {
    const Scene& scene = world.scene();
    std::vector<char> kept(scene.objects.size(), 1);
    for (std::uint32_t object = 0; part.keeps_object && object < kept.size(); ++object)
      kept[object] = part.keeps_object(object) ? 1 : 0;
    for (std::uint32_t t = 0; t < scene.triangles.size(); ++t)
      if (world.area(t) > 0.0F && kept[scene.triangle_object[t]] != 0) add(t, whole_triangle, world.area(t), 0);
  }

  bool empty() const { return pieces_.empty(); }
  /// The piece at this fraction of the area.
  const Piece& at(double fraction) const {
    const auto found = std::upper_bound(area_up_to_.begin(), area_up_to_.end() - 1, area_up_to_.back() * fraction);
    return pieces_[static_cast<std::size_t>(found - area_up_to_.begin())];
  }

 private:
  void add(std::uint32_t triangle, const std::array<Vec2, 3>& corners, float area, int cuts) {
    if (!part_.may_keep_in) return keep(triangle, corners, area);
    const std::array<Vec3, 3> positions{world_.position(triangle, corners[0]), world_.position(triangle, corners[1]),
                                        world_.position(triangle, corners[2])};
    const Vec3 low = glm::min(glm::min(positions[0], positions[1]), positions[2]);
    const Vec3 high = glm::max(glm::max(positions[0], positions[1]), positions[2]);
    if (!part_.may_keep_in(low, high)) return;
    if (cuts == most_cuts || glm::length(high - low) <= part_.piece_size) return keep(triangle, corners, area);
    const auto& [a, b, c] = corners;
    const Vec2 ab = 0.5F * (a + b), bc = 0.5F * (b + c), ca = 0.5F * (c + a);
    for (const std::array<Vec2, 3>& child : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      add(triangle, child, 0.25F * area, cuts + 1);
  }

  void keep(std::uint32_t triangle, const std::array<Vec2, 3>& corners, float area) {
    const Scene& scene = world_.scene();
    const int sides = scene.objects[scene.triangle_object[triangle]].two_sided ? 2 : 1;
    for (int side = 0; side < sides; ++side) {
      if (part_.keeps_side && !part_.keeps_side(triangle, side == 0)) continue;
      pieces_.push_back({triangle, side == 0, corners});
      area_up_to_.push_back((area_up_to_.empty() ? 0.0 : area_up_to_.back()) + static_cast<double>(area));
    }
  }

  const World& world_;
  const SampledPart& part_;
  std::vector<Piece> pieces_;
  std::vector<double> area_up_to_;  ///< m²
};

/// A point of the piece, where it is in front of all that coincides with it and belongs to the part.
std::optional<SurfaceSample> draw(const World& world, const SampledPart& part, const Piece& piece, RandomStream& random) {
  const float root = std::sqrt(random.next_float());
  const float second = random.next_float();
  const auto& [a, b, c] = piece.corners;
  const Vec2 place = a + root * (1.0F - second) * (b - a) + root * second * (c - a);
  const Vec3 normal = piece.front ? world.normal(piece.triangle) : -world.normal(piece.triangle);
  if (!world.coincident().shows(piece.triangle, place.x, place.y, -normal)) return std::nullopt;
  const SurfaceSample sample = world.sample_at(piece.triangle, place, normal);
  return !part.keeps || part.keeps(sample, random) ? std::optional(sample) : std::nullopt;
}

}  // namespace

std::vector<SurfaceSample> area_uniform_samples(const World& world, std::size_t count, std::uint64_t seed) {
  return area_uniform_samples(world, SampledPart{}, count, seed, 1);
}

std::vector<SurfaceSample> area_uniform_samples(const World& world, const SampledPart& part, std::size_t count,
                                                std::uint64_t seed, int threads) {
  const Pieces pieces(world, part);
  if (pieces.empty()) return {};
  std::vector<std::optional<SurfaceSample>> drawn(count);
  const auto draw_one = [&](std::size_t i) {
    RandomStream random(seed, stage_key, i);
    const double fraction = (static_cast<double>(i) + random.next_double()) / static_cast<double>(count);
    // A draw that met what is behind, or outside of the part, goes anywhere else.
    drawn[i] = draw(world, part, pieces.at(fraction), random);
    for (int again = 0; !drawn[i] && again < most_draws; ++again)
      drawn[i] = draw(world, part, pieces.at(random.next_double()), random);
  };
  parallel_chunks(threads, count, chunk_size, [&](const ChunkRange& range) {
    for (std::size_t i = range.begin; i < range.end; ++i) draw_one(i);
  });
  std::vector<SurfaceSample> samples;
  samples.reserve(count);
  for (const std::optional<SurfaceSample>& sample : drawn)
    if (sample) samples.push_back(*sample);
  return samples;
}

}  // namespace gibench
