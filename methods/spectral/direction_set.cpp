#include "methods/spectral/direction_set.h"

#include <algorithm>
#include <cmath>

#include "common/core/error.h"
#include "common/core/random.h"
#include "common/core/sobol.h"
#include "common/finite_elements/morton.h"

namespace gibench::spectral {

namespace {

constexpr std::uint64_t set_stage = 0x726179736574ULL, turn_stage = 0x7475726eULL;

/// Columns in, columns out: a loop that the compiler turns into vector instructions.
void turn_columns(const DirectionSet::Turn& turn, const float* elevation, const float* cosine, const float* sine,
                  DirectionBatch& batch) {
  for (std::size_t i = 0; i < batch.count; ++i) {
    const float shifted = elevation[i] + turn.shift;
    const float squared = shifted >= 1.0F ? shifted - 1.0F : shifted;
    const float radius = std::sqrt(squared), height = std::sqrt(std::max(0.0F, 1.0F - squared));
    const float along = radius * cosine[i], across = radius * sine[i];
    batch.x[i] = along * turn.tangent.x + across * turn.bitangent.x + height * turn.normal.x;
    batch.y[i] = along * turn.tangent.y + across * turn.bitangent.y + height * turn.normal.y;
    batch.z[i] = along * turn.tangent.z + across * turn.bitangent.z + height * turn.normal.z;
  }
}

}  // namespace

DirectionSet::DirectionSet(int rays, std::uint64_t seed) {
  const SobolSequence sequence(mix_keys(seed, set_stage));
  std::vector<SobolPair> points;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(rays); ++i) points.push_back(sequence.pair(i, 0));
  std::sort(points.begin(), points.end(),
            [](const SobolPair& a, const SobolPair& b) { return along_morton_curve(a.x, a.y) < along_morton_curve(b.x, b.y); });
  for (const SobolPair& point : points) {
    const Vec2 u = point.unit();
    elevation_.push_back(u.x);
    cosine_.push_back(std::cos(2.0F * pi * u.y));
    sine_.push_back(std::sin(2.0F * pi * u.y));
  }
}

DirectionSet::Turn DirectionSet::turn(std::uint64_t seed, std::uint32_t vertex, const Vec3& normal) {
  RandomStream random(seed, turn_stage, vertex);
  const float shift = random.next_float(), angle = 2.0F * pi * random.next_float();
  const float cosine = std::cos(angle), sine = std::sin(angle);
  const Frame frame(normal);
  return {shift, cosine * frame.tangent + sine * frame.bitangent, cosine * frame.bitangent - sine * frame.tangent, normal};
}

void DirectionSet::directions(const Turn& turn, std::size_t begin, DirectionBatch& batch) const {
  batch.count = std::min(DirectionBatch::capacity, size() - begin);
  turn_columns(turn, elevation_.data() + begin, cosine_.data() + begin, sine_.data() + begin, batch);
}

void DirectionSet::directions(const Turn& turn, std::span<const std::uint32_t> places, DirectionBatch& batch) const {
  GIBENCH_CHECK(places.size() <= DirectionBatch::capacity, "a batch holds the directions asked for");
  batch.count = places.size();
  std::array<float, DirectionBatch::capacity> elevation, cosine, sine;
  for (std::size_t i = 0; i < places.size(); ++i) {
    elevation[i] = elevation_[places[i]];
    cosine[i] = cosine_[places[i]];
    sine[i] = sine_[places[i]];
  }
  turn_columns(turn, elevation.data(), cosine.data(), sine.data(), batch);
}

}  // namespace gibench::spectral
