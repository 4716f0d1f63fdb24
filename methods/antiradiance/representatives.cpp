#include "methods/antiradiance/representatives.h"

#include <algorithm>
#include <limits>

namespace gibench::antiradiance {

namespace {

constexpr std::size_t most = 16;  // of an element
constexpr std::size_t element_chunk = 64;

}  // namespace

/// The furthest from those chosen so far is the next (Gonzalez 1985).
Representatives::Representatives(const SamplingMesh& mesh, const Grouped& members, Task& task) {
  const std::size_t elements = members.groups();
  of_vertex_.resize(members.items.size());
  of_element_.begin.assign(elements + 1, 0);
  for (std::size_t e = 0; e < elements; ++e)
    of_element_.begin[e + 1] = of_element_.begin[e] + static_cast<std::uint32_t>(std::min(most, members.of(e).size()));
  of_element_.vertices.resize(of_element_.begin.back());
  const auto vertices = mesh.vertices();
  task.parallel_chunks(elements, element_chunk, [&](const ChunkRange& range) {
    std::vector<float> squared;
    for (std::size_t e = range.begin; e < range.end; ++e) {
      const auto own = members.of(e);
      const auto chosen = std::span(of_element_.vertices).subspan(of_element_.begin[e], std::min(most, own.size()));
      if (own.size() <= most) {
        std::copy(own.begin(), own.end(), chosen.begin());
        for (const std::uint32_t v : own) of_vertex_[v] = v;
        continue;
      }
      squared.assign(own.size(), std::numeric_limits<float>::infinity());
      std::size_t next = 0;
      for (std::uint32_t& one : chosen) {
        one = own[next];
        for (std::size_t i = 0; i < own.size(); ++i) {
          const Vec3 d = vertices[own[i]].position - vertices[one].position;
          const float now = glm::dot(d, d);
          if (now < squared[i]) squared[i] = now, of_vertex_[own[i]] = one;
        }
        next = static_cast<std::size_t>(std::max_element(squared.begin(), squared.end()) - squared.begin());
      }
    }
  });
}

}  // namespace gibench::antiradiance
