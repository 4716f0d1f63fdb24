#include "methods/antiradiance/bin_transport.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "common/core/prefetch.h"
#include "methods/antiradiance/pull.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t leaf_chunk = 32, bin_chunk = 16, mask_chunk = 128;
constexpr std::size_t wanted_subtrees = 512;  // that are gathered side by side
constexpr float per_weight = 1.0F / 255.0F;
constexpr std::size_t links_ahead = 12;  // whose senders' rows, all over a table of many megabytes, are on their way meanwhile

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

/// Three numbers more, which the last bin's four reach into.
BinTransport::BinTransport(const Hierarchy& hierarchy, const LinkTable& links, const DirectionBins& bins)
    : hierarchy_(hierarchy),
      links_(links),
      bins_(bins),
      row_(bins.count() * channels),
      units_(hierarchy.size()),
      exitant_(hierarchy.size() * row_ + channels) {}

void BinTransport::send(std::uint32_t node, std::span<const float> radiance) {
  float largest = 0.0F;
  for (const float value : radiance) largest = std::max(largest, std::fabs(value));
  units_[node] = largest / most_units;
  const float per_unit = largest > 0.0F ? most_units / largest : 0.0F;
  ScaledNumber* out = exitant(node);
  for (std::size_t i = 0; i < row_; ++i)
    out[i] = static_cast<ScaledNumber>(std::lrint(std::clamp(radiance[i] * per_unit, -most_units, most_units)));
}

void BinTransport::transport_sources(std::span<const Rgb> radiosity, const Vector& lobes, Vector& incident, Task& task) {
  task.parallel_chunks(hierarchy_.leaf_count(), leaf_chunk, [&](const ChunkRange& range) {
    std::vector<float> out(row_);
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf) {
      const std::uint32_t node = hierarchy_.leaf_node(leaf);
      const Rgb radiance = radiosity[leaf] / pi;
      const float* more = lobes.size() > 0 ? lobes.data() + leaf * row_ : nullptr;
      for (std::size_t b = 0; b < bins_.count(); ++b) {
        const bool front = glm::dot(hierarchy_.nodes()[node].normal, bins_.direction(b)) > 0.0F;
        for (std::size_t c = 0; c < channels; ++c) {
          const std::size_t at = channels * b + c;
          out[at] = front ? radiance[static_cast<int>(c)] + (more != nullptr ? more[at] : 0.0F) : 0.0F;
        }
      }
      send(node, out);
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
  task.parallel_chunks(hierarchy_.leaf_count(), leaf_chunk, [&](const ChunkRange& range) {
    std::vector<float> projected(bins_.count()), out(row_);
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf) {
      const std::uint32_t node = hierarchy_.leaf_node(leaf);
      const bool black_back = hierarchy_.nodes()[node].black_back;
      const float* in = arriving.data() + leaf * row_;
      projected_bins(bins_, hierarchy_.nodes()[node].normal, projected);
      Rgb front;
      for (std::size_t b = 0; b < bins_.count(); ++b) {
        const bool on_front = projected[b] < 0.0F;
        const float taken = through && (on_front || black_back) ? -1.0F / std::fabs(projected[b]) : 0.0F;
        for (std::size_t c = 0; c < channels; ++c) {
          const float light = in[channels * b + c];
          if (on_front) front[static_cast<int>(c)] += light;
          out[channels * b + c] = taken * light;
        }
      }
      if (reflection != nullptr) {
        const float closure = reflection->closure.empty() ? 1.0F : reflection->closure[leaf];
        const Rgb reflected = front * reflection->albedo[leaf] * (closure / pi);
        for (std::size_t b = 0; b < bins_.count(); ++b)
          for (std::size_t c = 0; projected[b] > 0.0F && c < channels; ++c)
            out[channels * b + c] += reflected[static_cast<int>(c)];
        if (reflection->glossy != nullptr && reflection->glossy->is_glossy(leaf))
          reflection->glossy->reflect(leaf, hierarchy_.nodes()[node].normal, projected, in, closure, out.data());
      }
      send(node, out);
    }
  });
}

/// Bin by bin, from the leaves up: means by the area that each child shows to the bin. None is larger than the children's.
void BinTransport::pull(Task& task) {
  from_leaves_up(
      hierarchy_, [](std::size_t, std::size_t) {},
      [&](std::size_t node, std::size_t left, std::size_t right, float) {
        units_[node] = std::max(units_[left], units_[right]);
      });
  const auto nodes = hierarchy_.nodes();
  task.parallel_chunks(bins_.count(), bin_chunk, [&](const ChunkRange& range) {
    from_leaves_up(
        hierarchy_, [](std::size_t, std::size_t) {},
        [&](std::size_t node, std::size_t left, std::size_t right, float share) {
          const float per_unit = units_[node] > 0.0F ? 1.0F / units_[node] : 0.0F;
          const float of_left = units_[left] * per_unit, of_right = units_[right] * per_unit;
          const ScaledNumber *a = exitant(left), *b = exitant(right);
          ScaledNumber* out = exitant(node);
          const bool bent = nodes[left].normal != nodes[right].normal;
          for (std::size_t bin = range.begin; bin < range.end; ++bin) {
            float own = share;
            if (bent) {
              const float shown = share * cosine(nodes[left], bin);
              own = shown / (shown + (1.0F - share) * cosine(nodes[right], bin));
            }
            for (std::size_t i = bin * channels; i < (bin + 1) * channels; ++i) {
              const float mean = mean_by_area(static_cast<float>(a[i]) * of_left, static_cast<float>(b[i]) * of_right, own);
              out[i] = static_cast<ScaledNumber>(std::lrint(mean));
            }
          }
        });
  });
}

void BinTransport::prefetch_sent(std::size_t link) const {
  if (link >= links_.size()) return;
  const ScaledNumber* from = exitant(links_.senders[link].node());
  for (const auto bin : bins_.bins_of(links_.masks[link].quad)) prefetch(from + channels * bin);
}

/// Sender's exitant light in the bins of the link, times form factor and mask.
void BinTransport::gather(std::uint32_t node, float* arriving) const {
  for (std::uint32_t link = links_.row_begin[node]; link < links_.row_begin[node + 1]; ++link) {
    prefetch_sent(link + links_ahead);
    const LinkMask& mask = links_.masks[link];
    const auto& quad = bins_.bins_of(mask.quad);
    const std::uint32_t sender = links_.senders[link].node();
    const ScaledNumber* from = exitant(sender);
    FourFloats light{};
    for (std::size_t k = 0; k < 4; ++k) light += load_four(from + channels * quad[k]) * static_cast<float>(mask.send.weights[k]);
    light *= links_.factors[link] * (pi * per_weight * per_weight) * units_[sender];
    for (std::size_t k = 0; k < 4; ++k) {
      float* to = arriving + channels * quad[k];
      const auto weight = static_cast<float>(mask.receive.weights[k]);
      for (std::size_t c = 0; c < channels; ++c) to[c] += light[c] * weight;
    }
  }
}

void BinTransport::pass_down(const Node& node, const Node& child, const float* arriving, float* at_child) const {
  if (node.normal == child.normal) {
    std::copy_n(arriving, row_, at_child);
    return;
  }
  for (std::size_t b = 0; b < bins_.count(); ++b) {
    const float shown = cosine(child, b) / cosine(node, b);
    for (std::size_t c = 0; c < channels; ++c) at_child[channels * b + c] = shown * arriving[channels * b + c];
  }
}

void BinTransport::gather_below(std::uint32_t node, std::vector<float>& rows, std::size_t depth, Vector& incident) const {
  const Node& own = hierarchy_.nodes()[node];
  if (own.is_leaf()) {
    std::memcpy(incident.data() + own.begin * row_, rows.data() + depth * row_, row_ * sizeof(float));
    return;
  }
  if (rows.size() < (depth + 2) * row_) rows.resize((depth + 2) * row_);
  for (const std::uint32_t child : {node + 1, own.right}) {
    pass_down(own, hierarchy_.nodes()[child], rows.data() + depth * row_, rows.data() + (depth + 1) * row_);
    gather(child, rows.data() + (depth + 1) * row_);
    gather_below(child, rows, depth + 1, incident);
  }
}

/// From the roots down level by level until there are enough nodes, then each with everything below it.
void BinTransport::unoccluded(Vector& incident, Task& task) {
  pull(task);
  incident.setZero(vector_size());
  const auto nodes = hierarchy_.nodes();
  std::vector<std::uint32_t> level(hierarchy_.roots().begin(), hierarchy_.roots().end());
  std::vector<float> rows(level.size() * row_, 0.0F);
  const auto gather_level = [&] {
    task.parallel_chunks(level.size(), 1,
                         [&](const ChunkRange& range) { gather(level[range.begin], rows.data() + range.begin * row_); });
  };
  gather_level();
  const auto is_inner = [&](std::uint32_t node) { return !nodes[node].is_leaf(); };
  while (level.size() < wanted_subtrees && std::any_of(level.begin(), level.end(), is_inner)) {
    std::vector<std::uint32_t> next;
    std::vector<float> next_rows;
    for (std::size_t i = 0; i < level.size(); ++i) {
      const float* row = rows.data() + i * row_;
      if (!is_inner(level[i])) {
        std::copy_n(row, row_, incident.data() + nodes[level[i]].begin * row_);
        continue;
      }
      for (const std::uint32_t child : {level[i] + 1, nodes[level[i]].right}) {
        next.push_back(child);
        next_rows.resize(next_rows.size() + row_);
        pass_down(nodes[level[i]], nodes[child], row, next_rows.data() + next_rows.size() - row_);
      }
    }
    level = std::move(next);
    rows = std::move(next_rows);
    gather_level();
  }
  task.parallel_chunks(level.size(), 1, [&](const ChunkRange& range) {
    std::vector<float> below(rows.begin() + static_cast<std::ptrdiff_t>(range.begin * row_),
                             rows.begin() + static_cast<std::ptrdiff_t>((range.begin + 1) * row_));
    gather_below(level[range.begin], below, 0, incident);
  });
}

/// J makes radiance −1 of an irradiance of one on the projected solid angle of each bin.
std::vector<float> BinTransport::depths(Task& task) {
  Vector ones(vector_size()), arriving;
  task.parallel_chunks(hierarchy_.leaf_count(), leaf_chunk, [&](const ChunkRange& range) {
    std::vector<float> projected(bins_.count());
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf) {
      projected_bins(bins_, hierarchy_.nodes()[hierarchy_.leaf_node(leaf)].normal, projected);
      for (std::size_t i = 0; i < row_; ++i) ones.data()[leaf * row_ + i] = std::fabs(projected[i / channels]);
    }
  });
  transport_through(ones, arriving, task);
  std::vector<Rgb> fronts(hierarchy_.leaf_count());
  irradiance(arriving, fronts, task);
  std::vector<float> depths;
  for (const Rgb& front : fronts) depths.push_back(-front.g / pi);
  return depths;
}

void BinTransport::irradiance(const Vector& arriving, std::span<Rgb> fronts, Task& task) const {
  task.parallel_chunks(hierarchy_.leaf_count(), leaf_chunk, [&](const ChunkRange& range) {
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf) {
      const Vec3& normal = hierarchy_.nodes()[hierarchy_.leaf_node(leaf)].normal;
      const float* in = arriving.data() + leaf * row_;
      Rgb sum;
      for (std::size_t b = 0; b < bins_.count(); ++b)
        if (!(glm::dot(normal, bins_.direction(b)) > 0.0F))
          sum += Rgb(in[channels * b], in[channels * b + 1], in[channels * b + 2]);
      fronts[leaf] = sum;
    }
  });
}

}  // namespace gibench::antiradiance
