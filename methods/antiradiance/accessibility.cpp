#include "methods/antiradiance/accessibility.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "methods/antiradiance/bin_transport.h"
#include "methods/antiradiance/pull.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t leaf_chunk = 64;
constexpr float near_radii = 3.0F;  // of a blocker, within which it is its cell's polygons
constexpr float wide_cone = 0.35F;  // sine: a node bent more than that is opened
constexpr float coplanar = 1e-5F;   // of the distance

/// Point to disc: the limit of the disc-to-disc form for a receiver without area.
float disc_share(const Node& node, float squared, float u, float v, float m) {
  const float t = node.area / (pi * squared + node.area);
  return t * orientation_factor(u, v, m, 0.0F, t);
}

}  // namespace

Accessibility::Accessibility(const Elements& elements, const Hierarchy& hierarchy, float far_enough, int sectors)
    : elements_(elements), hierarchy_(hierarchy), far_enough_(far_enough), sectors_(2) {
  if (sectors <= 1) return;
  bins_.emplace(sectors);
  sectors_ = bins_->count();
}

void Accessibility::compute(int passes, Task& task) {
  leaves_.assign(hierarchy_.leaf_count() * sectors_, 1.0F);
  std::vector<float> before;
  for (int pass = 0; pass < passes && !task.cancelled(); ++pass) {
    pull();
    before = leaves_;
    std::vector<std::uint64_t> evaluations(chunk_count(hierarchy_.leaf_count(), leaf_chunk), 0);
    task.parallel_chunks(hierarchy_.leaf_count(), leaf_chunk, [&](const ChunkRange& range) {
      Blocked blocked(sectors_);
      std::vector<float> shares(sectors_);
      for (std::size_t leaf = range.begin; leaf < range.end; ++leaf) {
        const std::uint32_t element = hierarchy_.order()[leaf];
        const Disc& disc = elements_.disc(element);
        side_shares(disc.normal, shares);
        blocked.start();
        for (const float side : {1.0F, -1.0F}) block({disc.centre, disc.normal, side, element}, blocked);
        for (std::size_t s = 0; s < sectors_; ++s)
          leaves_[leaf * sectors_ + s] = 1.0F - std::min(1.0F, of_sector(blocked, s) / shares[s]);
      }
      evaluations[range.chunk] = blocked.evaluations;
    });
    for (const std::uint64_t count : evaluations) evaluations_ += count;
    task.progress("accessibility pass", static_cast<double>(pass + 1) / passes);
  }
  if (passes > 1)
    for (std::size_t i = 0; i < leaves_.size(); ++i) leaves_[i] = 0.5F * (leaves_[i] + before[i]);
  pull();
}

void Accessibility::pull() {
  nodes_.resize(hierarchy_.size() * sectors_);
  from_leaves_up(
      hierarchy_,
      [&](std::size_t node, std::size_t leaf) {
        std::copy_n(leaves_.data() + leaf * sectors_, sectors_, nodes_.data() + node * sectors_);
      },
      [&](std::size_t node, std::size_t left, std::size_t right, float share) {
        const float *a = nodes_.data() + left * sectors_, *b = nodes_.data() + right * sectors_;
        float* row = nodes_.data() + node * sectors_;
        for (std::size_t s = 0; s < sectors_; ++s) row[s] = mean_by_area(a[s], b[s], share);
      });
}

void Accessibility::Blocked::start() {
  std::fill(scaled.begin(), scaled.end(), 0.0F);
  std::fill(most.begin(), most.end(), 0.0F);
}

void Accessibility::Blocked::end_sheet() {
  for (std::vector<float>& facing : sheet)
    for (std::size_t s = 0; s < most.size(); ++s) most[s] = std::max(most[s], facing[s]), facing[s] = 0.0F;
}

float Accessibility::at(const Vec3& point, const Vec3& normal, std::uint32_t own) const {
  Blocked blocked(sectors_);
  block({point, normal, 1.0F, own}, blocked);
  float sum = 0.0F;
  for (std::size_t s = 0; s < sectors_; ++s) sum += of_sector(blocked, s);
  return 1.0F - std::min(1.0F, sum);
}

float Accessibility::of_side(std::size_t leaf, bool front) const {
  const Vec3& normal = hierarchy_.nodes()[hierarchy_.leaf_node(leaf)].normal;
  std::vector<float> shares(sectors_);
  side_shares(normal, shares);
  float sum = 0.0F;
  for (std::size_t s = 0; s < sectors_; ++s)
    if ((bins_ ? glm::dot(normal, bins_->direction(s)) > 0.0F : s == 0) == front) sum += shares[s] * leaves_[leaf * sectors_ + s];
  return sum;
}

/// Those sectors of the four around the direction whose middles lie on the surface's side of it; all where none does.
Accessibility::Sectors Accessibility::sectors_of(const DirectionBins::Place& around, bool front, const Vec3& normal) const {
  if (!bins_) return {{static_cast<std::uint16_t>(front ? 0 : 1)}, {1.0F}};
  Sectors result{bins_->bins_of(around.quad), around.shares};
  float sum = 0.0F;
  for (std::size_t k = 0; k < 4; ++k) {
    if ((glm::dot(normal, bins_->direction(result.index[k])) > 0.0F) != front) result.share[k] = 0.0F;
    sum += result.share[k];
  }
  if (!(sum > 0.0F)) return {result.index, around.shares};
  for (float& share : result.share) share /= sum;
  return result;
}

void Accessibility::side_shares(const Vec3& normal, std::span<float> shares) const {
  if (!bins_) {
    std::fill(shares.begin(), shares.end(), 1.0F);
    return;
  }
  projected_bins(*bins_, normal, shares);
  for (float& share : shares) share = std::fabs(share) / pi;
}

void Accessibility::add(float form_factor, const Vec3& direction, const Vec3& blocker, const float* accessible,
                        const Receiver& receiver, Blocked& blocked) const {
  const DirectionBins::Place around = bins_ ? bins_->place(direction) : DirectionBins::Place{};
  const bool shows_front = glm::dot(direction, blocker) < 0.0F;
  const Sectors behind = sectors_of(around, !shows_front, blocker),
                here = sectors_of(around, receiver.side > 0.0F, receiver.normal);
  float reached = 0.0F;
  for (std::size_t k = 0; k < 4; ++k) reached += behind.share[k] * accessible[behind.index[k]];
  std::vector<float>& sheet = blocked.sheet[shows_front ? 0 : 1];
  for (std::size_t k = 0; k < 4; ++k) {
    const float share = form_factor * here.share[k];
    blocked.scaled[here.index[k]] += share * reached;
    sheet[here.index[k]] += share;
  }
}

/// Part by part: a near cell is seen under many directions.
void Accessibility::block_by_cell(const Node& leaf, const float* accessible, const Receiver& receiver, Blocked& blocked) const {
  const std::uint32_t element = hierarchy_.element(leaf);
  for (const CellPart& part : elements_.parts(element)) {
    const float form_factor =
        elements_.exposed_share(element) * polygon_form_factor(receiver.point, receiver.looks(), part.corners);
    if (!(form_factor > 0.0F)) continue;
    const Vec3 d = 0.25F * (part.corners[0] + part.corners[1] + part.corners[2] + part.corners[3]) - receiver.point;
    const float squared = glm::dot(d, d);
    add(form_factor, squared > 0.0F ? d / std::sqrt(squared) : receiver.looks(), leaf.normal, accessible, receiver, blocked);
  }
}

void Accessibility::block(const Receiver& receiver, Blocked& blocked) const {
  for (const std::uint32_t root : hierarchy_.roots()) {
    // The back of a two-sided sheet is where its front is: one of the two blocks.
    if (elements_.sheet(hierarchy_.order()[hierarchy_.nodes()[root].begin]) % 2 != 0) continue;
    block_by_tree(root, receiver, blocked);
    blocked.end_sheet();
  }
}

void Accessibility::block_by_tree(std::uint32_t root, const Receiver& receiver, Blocked& blocked) const {
  std::array<std::uint32_t, 128> stack{};
  const auto nodes = hierarchy_.nodes();
  const Vec3 normal = receiver.looks();
  std::size_t depth = 0;
  stack[depth++] = root;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const Node& node = nodes[index];
    const Vec3 d = node.centre - receiver.point;
    const float squared = glm::dot(d, d), r = std::sqrt(squared);
    const float disc_reach = std::sqrt(node.area / pi);
    const float u = glm::dot(normal, d), v = -glm::dot(node.normal, d), m = glm::dot(normal, node.normal);
    const float across = std::sqrt(std::max(0.0F, 1.0F - m * m));
    const float stray = node.thickness * std::fabs(m) + (node.reach + 2.0F * disc_reach) * across;
    if (u + stray <= coplanar * (r + node.reach)) continue;
    ++blocked.evaluations;
    const float bound = node.area / (pi * squared + node.area);
    const bool stands = !node.is_leaf() && bound < far_enough_ && node.cone_sine < wide_cone && r > node.reach;
    if (!node.is_leaf() && !stands && depth + 2 <= stack.size()) {
      stack[depth++] = node.right;
      stack[depth++] = index + 1;
      continue;
    }
    if (node.is_leaf() && hierarchy_.element(node) == receiver.own) continue;
    const float* accessible = nodes_.data() + index * sectors_;
    if (node.is_leaf() && (squared < near_radii * near_radii * disc_reach * disc_reach || u < stray))
      block_by_cell(node, accessible, receiver, blocked);
    else if (u > 0.0F && r > 0.0F)
      add(disc_share(node, squared, u / r, std::fabs(v) / r, v < 0.0F ? -m : m), d / r, node.normal, accessible, receiver,
          blocked);
  }
}

}  // namespace gibench::antiradiance
