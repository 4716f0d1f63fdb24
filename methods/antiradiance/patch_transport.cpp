#include "methods/antiradiance/patch_transport.h"

#include <algorithm>

#include "methods/antiradiance/pull.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t node_chunk = 128;
constexpr float most_raised = 1.5F;

}  // namespace

void PatchTransport::transport(std::span<const Rgb> fronts, std::span<const Rgb> backs, std::span<Rgb> arriving,
                               Task& task) const {
  const auto nodes = hierarchy_.nodes();
  const std::vector<Rgb> from_fronts = pull(hierarchy_, fronts),
                         from_backs = backs.empty() ? std::vector<Rgb>() : pull(hierarchy_, backs);
  std::vector<Rgb> incident(nodes.size());
  task.parallel_chunks(nodes.size(), node_chunk, [&](const ChunkRange& range) {
    for (std::size_t p = range.begin; p < range.end; ++p) {
      Rgb sum;
      for (std::uint32_t link = links_.row_begin[p]; link < links_.row_begin[p + 1]; ++link) {
        const Sender sender = links_.senders[link];
        if (sender.to_back() || (sender.from_back() && from_backs.empty())) continue;
        sum += (sender.from_back() ? from_backs : from_fronts)[sender.node()] * links_.factors[link];
      }
      incident[p] = sum;
    }
  });
  for (std::size_t p = 0; p < nodes.size(); ++p) {
    if (nodes[p].is_leaf()) {
      arriving[nodes[p].begin] = incident[p];
      continue;
    }
    incident[p + 1] += incident[p];
    incident[nodes[p].right] += incident[p];
  }
}

std::vector<float> normalisation(std::span<const float> sums, std::span<const float> closed) {
  std::vector<float> factors(sums.size(), 1.0F);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (!(sums[i] > 0.0F)) continue;
    factors[i] = closed.empty() ? std::min(1.0F, 1.0F / sums[i]) : std::min(most_raised, closed[i] / sums[i]);
  }
  return factors;
}

}  // namespace gibench::antiradiance
