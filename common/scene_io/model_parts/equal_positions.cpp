#include "common/scene_io/model_parts/equal_positions.h"

#include <array>
#include <cstring>
#include <glm/common.hpp>
#include <unordered_map>

#include "common/core/hash.h"

namespace gibench {

namespace {

/// Compared bit by bit, so that NaN equals itself.
struct Bits {
  std::array<float, 3> position;
  bool operator==(const Bits& other) const { return std::memcmp(&position, &other.position, sizeof position) == 0; }
};
struct HashOfBits {
  std::size_t operator()(const Bits& bits) const { return hash_bytes(&bits.position, sizeof bits.position); }
};

}  // namespace

std::vector<std::uint32_t> first_of_equal(std::span<const Vec3d> positions) {
  std::vector<std::uint32_t> first(positions.size());
  if (positions.empty()) return first;
  Vec3d low = positions[0], high = positions[0];
  for (const Vec3d& position : positions) low = glm::min(low, position), high = glm::max(high, position);
  const Vec3d centre = low + 0.5 * (high - low);
  std::unordered_map<Bits, std::uint32_t, HashOfBits> known;
  known.reserve(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3 local(positions[i] - centre);
    const Bits bits{{local.x + 0.0F, local.y + 0.0F, local.z + 0.0F}};  // -0 becomes 0
    first[i] = known.try_emplace(bits, static_cast<std::uint32_t>(i)).first->second;
  }
  return first;
}

}  // namespace gibench
