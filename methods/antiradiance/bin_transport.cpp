#include "methods/antiradiance/bin_transport.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "common/core/prefetch.h"
#include "methods/antiradiance/pull.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t node_chunk = 32, leaf_chunk = 32, bin_chunk = 16, mask_chunk = 128;
constexpr float per_weight = 1.0F / 255.0F;
constexpr std::size_t links_ahead = 12;  // whose senders' rows, all over a table of many megabytes, are on their way meanwhile

void add_scaled(Light4& to, const Light4& from, float factor) {
  for (int c = 0; c < 4; ++c) to.v[c] += factor * from.v[c];
}

}  // namespace

void projected_bins(const DirectionBins& bins, const Vec3& normal, std::span<float> projected) {
  float front = 0.0F, back = 0.0F;
  for (std::size_t b = 0; b < bins.count(); ++b) {
    const float cosine = glm::dot(normal, bins.direction(b));
    const float size = std::max(std::fabs(cosine), bins.least_cosine());
    projected[b] = cosine > 0.0F ? size : -size;
    (cosine > 0.0F ? front : back) += size;
  }
  for (std::size_t b = 0; b < bins.count(); ++b) projected[b] *= pi / (projected[b] > 0.0F ? front : back);
}

void make_masks(const Hierarchy& hierarchy, const DirectionBins& bins, std::span<const Vec3> ways, LinkTable& links, Task& task) {
  const auto nodes = hierarchy.nodes();
  links.masks.resize(links.size());
  task.parallel_chunks(nodes.size(), mask_chunk, [&](const ChunkRange& range) {
    for (std::size_t p = range.begin; p < range.end; ++p)
      for (std::uint32_t link = links.row_begin[p]; link < links.row_begin[p + 1]; ++link) {
        const Sender sender = links.senders[link];
        const Node& from = nodes[sender.node()];
        const DirectionBins::Place place = bins.place(ways[link]);
        links.masks[link] = {place.quad, bins.mask(place, from.normal, sender.from_back() ? -1.0F : 1.0F),
                             bins.mask(place, nodes[p].normal, sender.to_back() ? 1.0F : -1.0F)};
      }
  });
}

BinTransport::BinTransport(const Hierarchy& hierarchy, const LinkTable& links, const DirectionBins& bins)
    : hierarchy_(hierarchy),
      links_(links),
      bins_(bins),
      exitant_(hierarchy.size() * bins.count()),
      incident_(hierarchy.size() * bins.count()) {}

void BinTransport::transport_sources(std::span<const Rgb> radiosity, const Vector& lobes, Vector& incident, Task& task) {
  const std::size_t count = bins_.count();
  task.parallel_chunks(hierarchy_.leaf_count(), leaf_chunk, [&](const ChunkRange& range) {
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf) {
      const std::uint32_t node = hierarchy_.leaf_node(leaf);
      const Rgb radiance = radiosity[leaf] / pi;
      const float* more = lobes.size() > 0 ? lobes.data() + leaf * count * 4 : nullptr;
      for (std::size_t b = 0; b < count; ++b) {
        const bool front = glm::dot(hierarchy_.nodes()[node].normal, bins_.direction(b)) > 0.0F;
        Light4 light = front ? Light4{{radiance.r, radiance.g, radiance.b, 0.0F}} : Light4{};
        for (std::size_t c = 0; front && more != nullptr && c < 3; ++c) light.v[c] += more[4 * b + c];
        exitant(node)[b] = light;
      }
    }
  });
  unoccluded(incident, task);
}

void BinTransport::transport_through(const Vector& arriving, Vector& incident, Task& task) {
  local_pass(arriving, true, nullptr, task);
  unoccluded(incident, task);
}

void BinTransport::transport(const Vector& arriving, const Reflection& reflection, Vector& incident, Task& task) {
  local_pass(arriving, true, &reflection, task);
  unoccluded(incident, task);
}

void BinTransport::transport_reflected(const Vector& arriving, const Reflection& reflection, Vector& incident, Task& task) {
  local_pass(arriving, false, &reflection, task);
  unoccluded(incident, task);
}

/// K and J work on different hemispheres of what leaves: what arrives on the front is reflected on the front and goes
/// through to the back. Light that arrives on a black back goes through to the front, as antiradiance beside the reflected.
void BinTransport::local_pass(const Vector& arriving, bool through, const Reflection* reflection, Task& task) {
  const std::size_t count = bins_.count();
  task.parallel_chunks(hierarchy_.leaf_count(), leaf_chunk, [&](const ChunkRange& range) {
    std::vector<float> projected(count);
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf) {
      const std::uint32_t node = hierarchy_.leaf_node(leaf);
      const bool black_back = hierarchy_.nodes()[node].black_back;
      const float* in = arriving.data() + leaf * count * 4;
      Light4* out = exitant(node);
      projected_bins(bins_, hierarchy_.nodes()[node].normal, projected);
      Light4 front;
      for (std::size_t b = 0; b < count; ++b) {
        const bool on_front = projected[b] < 0.0F;
        const float taken = through && (on_front || black_back) ? -1.0F / std::fabs(projected[b]) : 0.0F;
        for (std::size_t c = 0; c < 4; ++c) {
          const float light = in[4 * b + c];
          if (on_front) front.v[c] += light;
          out[b].v[c] = taken * light;
        }
      }
      if (reflection == nullptr) continue;
      const float closure = reflection->closure.empty() ? 1.0F : reflection->closure[leaf];
      const Rgb reflected = Rgb(front.v[0], front.v[1], front.v[2]) * reflection->albedo[leaf] * (closure / pi);
      const Light4 radiance{{reflected.r, reflected.g, reflected.b, 0.0F}};
      for (std::size_t b = 0; b < count; ++b)
        if (projected[b] > 0.0F) add_scaled(out[b], radiance, 1.0F);
      if (reflection->glossy != nullptr && reflection->glossy->is_glossy(leaf))
        reflection->glossy->reflect(leaf, hierarchy_.nodes()[node].normal, projected, in, closure, out->v);
    }
  });
}

/// Bin by bin, from the leaves up.
void BinTransport::pull(Task& task) {
  task.parallel_chunks(bins_.count(), bin_chunk, [&](const ChunkRange& range) {
    from_leaves_up(
        hierarchy_, [](std::size_t, std::size_t) {},
        [&](std::size_t node, std::size_t left, std::size_t right, float share) {
          const Light4 *a = exitant(left), *b = exitant(right);
          Light4* out = exitant(node);
          for (std::size_t bin = range.begin; bin < range.end; ++bin)
            for (std::size_t c = 0; c < 4; ++c) out[bin].v[c] = mean_by_area(a[bin].v[c], b[bin].v[c], share);
        });
  });
}

void BinTransport::prefetch_sent(std::size_t link) const {
  if (link >= links_.size()) return;
  const Light4* from = exitant(links_.senders[link].node());
  for (const auto bin : bins_.bins_of(links_.masks[link].quad)) prefetch(from + bin);
}

/// Sender's exitant light in the bins of the link, times form factor and mask, into the receiver's incident row.
void BinTransport::gather(Task& task) {
  task.parallel_chunks(hierarchy_.size(), node_chunk, [&](const ChunkRange& range) {
    for (std::size_t p = range.begin; p < range.end; ++p) {
      Light4* row = incident(p);
      std::fill(row, row + bins_.count(), Light4{});
      for (std::uint32_t link = links_.row_begin[p]; link < links_.row_begin[p + 1]; ++link) {
        prefetch_sent(link + links_ahead);
        const LinkMask& mask = links_.masks[link];
        const auto& quad = bins_.bins_of(mask.quad);
        const Light4* from = exitant(links_.senders[link].node());
        Light4 light;
        for (std::size_t k = 0; k < 4; ++k) add_scaled(light, from[quad[k]], static_cast<float>(mask.send.weights[k]));
        const float factor = links_.factors[link] * (pi * per_weight * per_weight);
        for (std::size_t k = 0; k < 4; ++k) add_scaled(row[quad[k]], light, factor * static_cast<float>(mask.receive.weights[k]));
      }
    }
  });
}

void BinTransport::push(Task& task) {
  const auto nodes = hierarchy_.nodes();
  task.parallel_chunks(bins_.count(), bin_chunk, [&](const ChunkRange& range) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].is_leaf()) continue;
      const Light4* from = incident(i);
      for (Light4* to : {incident(i + 1), incident(nodes[i].right)})
        for (std::size_t b = range.begin; b < range.end; ++b) add_scaled(to[b], from[b], 1.0F);
    }
  });
}

void BinTransport::unoccluded(Vector& incident_leaves, Task& task) {
  pull(task);
  gather(task);
  push(task);
  incident_leaves.resize(vector_size());
  const std::size_t row = bins_.count() * 4;
  if (task.cancelled()) {
    incident_leaves.setZero();
    return;
  }
  task.parallel_chunks(hierarchy_.leaf_count(), leaf_chunk, [&](const ChunkRange& range) {
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf)
      std::memcpy(incident_leaves.data() + leaf * row, incident(hierarchy_.leaf_node(leaf)), row * sizeof(float));
  });
}

void BinTransport::irradiance(const Vector& arriving, std::span<Rgb> fronts, Task& task) const {
  task.parallel_chunks(hierarchy_.leaf_count(), leaf_chunk, [&](const ChunkRange& range) {
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf) {
      const Vec3& normal = hierarchy_.nodes()[hierarchy_.leaf_node(leaf)].normal;
      const float* in = arriving.data() + leaf * bins_.count() * 4;
      Rgb sum;
      for (std::size_t b = 0; b < bins_.count(); ++b)
        if (!(glm::dot(normal, bins_.direction(b)) > 0.0F)) sum += Rgb(in[4 * b], in[4 * b + 1], in[4 * b + 2]);
      fronts[leaf] = sum;
    }
  });
}

}  // namespace gibench::antiradiance
