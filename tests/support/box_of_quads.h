/// A box whose six quads face inwards or outwards, one-sided or two-sided.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "common/scene/made_scenes.h"

namespace gibench::test {

inline void add_box(made::SceneBuilder& builder, const std::string& name, std::uint32_t material, const Vec3& low,
                    const Vec3& high, bool inwards, bool two_sided) {
  std::vector<Vec3> corners;
  for (unsigned i = 0; i < 8; ++i)
    corners.push_back({(i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y, (i & 4U) != 0 ? high.z : low.z});
  std::vector<std::array<std::uint32_t, 4>> faces{{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                  {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  if (inwards)
    for (auto& face : faces) std::swap(face[1], face[3]);
  builder.object(name, material, corners, faces, two_sided);
}

}  // namespace gibench::test
