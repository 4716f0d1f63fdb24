#include "methods/antiradiance/accessibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "common/finite_elements/polygon_form_factor.h"
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

class Accessibility::Blocked {
 public:
  /// By the blockers' accessibilities in these tables of nodes; one that is empty scales nothing.
  Blocked(std::size_t sectors, std::span<const std::span<const float>> tables)
      : sectors_(sectors), tables_(tables.begin(), tables.end()), scaled_(tables.size() * sectors), most_(sectors) {}

  void start() {
    std::fill(scaled_.begin(), scaled_.end(), 0.0F);
    std::fill(most_.begin(), most_.end(), 0.0F);
    slots_.clear();
    facing_.clear();
    last_sheet_ = several_sheets;
  }

  /// A share of the hemisphere in some sectors, behind which light comes from others.
  void add(std::uint32_t node, float form_factor, const Sectors& here, const Sectors& behind) {
    for (std::size_t table = 0; table < tables_.size(); ++table) {
      float reached = 1.0F;
      if (!tables_[table].empty()) {
        const float* accessible = tables_[table].data() + node * sectors_;
        reached = 0.0F;
        for (std::size_t k = 0; k < 4; ++k) reached += behind.share[k] * accessible[behind.index[k]];
      }
      float* scaled = scaled_.data() + table * sectors_;
      for (std::size_t k = 0; k < 4; ++k) scaled[here.index[k]] += form_factor * here.share[k] * reached;
    }
  }
  /// The same, as part of a sheet that shows one of its sides.
  void add_to_sheet(std::uint32_t sheet, bool shows_front, float form_factor, const Sectors& here) {
    float* facing = side_of(sheet, shows_front);
    for (std::size_t k = 0; k < 4; ++k) facing[here.index[k]] += form_factor * here.share[k];
  }
  /// Whatever lies behind it, a sector is blocked at least as much as by the sheet that blocks most of it.
  void end() {
    for (std::size_t i = 0; i < facing_.size(); ++i) most_[i % sectors_] = std::max(most_[i % sectors_], facing_[i]);
  }

  std::size_t tables() const { return tables_.size(); }
  float of_sector(std::size_t table, std::size_t sector) const {
    return std::max(scaled_[table * sectors_ + sector], most_[sector]);
  }
  std::uint64_t evaluations = 0;

 private:
  float* side_of(std::uint32_t sheet, bool front) {
    if (sheet != last_sheet_) {
      last_sheet_ = sheet;
      const auto [found, is_new] = slots_.try_emplace(sheet, facing_.size());
      if (is_new) facing_.resize(facing_.size() + 2 * sectors_);
      last_slot_ = found->second;
    }
    return facing_.data() + last_slot_ + (front ? 0 : sectors_);
  }

  std::size_t sectors_;
  std::vector<std::span<const float>> tables_;
  std::vector<float> scaled_, most_;
  std::unordered_map<std::uint32_t, std::size_t> slots_;  ///< of the sheets met, in facing_
  std::vector<float> facing_;                             ///< two rows a sheet: of what shows its front, and its back
  std::uint32_t last_sheet_ = several_sheets;
  std::size_t last_slot_ = 0;
};

Accessibility::Accessibility(const Elements& elements, const Hierarchy& hierarchy, float far_enough, int sectors)
    : elements_(elements), hierarchy_(hierarchy), far_enough_(far_enough), sectors_(2) {
  if (sectors <= 1) return;
  bins_.emplace(sectors);
  sectors_ = bins_->count();
}

void Accessibility::compute(int passes, Task& task) {
  before_.clear(), last_.clear();
  blends_ = passes > 1;
  std::vector<float> leaves(passes > 1 ? hierarchy_.leaf_count() * sectors_ : 0);
  for (int pass = 1; pass < passes && !task.cancelled(); ++pass) {
    std::vector<std::uint64_t> evaluations(chunk_count(hierarchy_.leaf_count(), leaf_chunk), 0);
    const std::array<std::span<const float>, 1> table{last_};
    task.parallel_chunks(hierarchy_.leaf_count(), leaf_chunk, [&](const ChunkRange& range) {
      Blocked blocked(sectors_, table);
      std::vector<float> shares(sectors_);
      for (std::size_t leaf = range.begin; leaf < range.end; ++leaf) {
        const std::uint32_t element = hierarchy_.order()[leaf];
        const Disc& disc = elements_.disc(element);
        side_shares(disc.normal, shares);
        blocked.start();
        for (const float side : {1.0F, -1.0F}) block({disc.centre, disc.normal, side, element}, blocked);
        blocked.end();
        for (std::size_t s = 0; s < sectors_; ++s)
          leaves[leaf * sectors_ + s] = 1.0F - std::min(1.0F, blocked.of_sector(0, s) / shares[s]);
      }
      evaluations[range.chunk] = blocked.evaluations;
    });
    for (const std::uint64_t count : evaluations) evaluations_ += count;
    before_ = std::move(last_);
    last_ = pulled(leaves);
    task.progress("accessibility pass", static_cast<double>(pass) / passes);
  }
}

std::vector<float> Accessibility::pulled(std::span<const float> leaves) const {
  std::vector<float> nodes(hierarchy_.size() * sectors_);
  from_leaves_up(
      hierarchy_,
      [&](std::size_t node, std::size_t leaf) {
        std::copy_n(leaves.data() + leaf * sectors_, sectors_, nodes.data() + node * sectors_);
      },
      [&](std::size_t node, std::size_t left, std::size_t right, float share) {
        const float *a = nodes.data() + left * sectors_, *b = nodes.data() + right * sectors_;
        float* row = nodes.data() + node * sectors_;
        for (std::size_t s = 0; s < sectors_; ++s) row[s] = mean_by_area(a[s], b[s], share);
      });
  return nodes;
}

float Accessibility::at(const Vec3& point, const Vec3& normal, std::uint32_t own, std::span<float> open) const {
  const std::array<std::span<const float>, 2> tables{last_, before_};
  Blocked blocked(sectors_, std::span(tables).first(blends_ ? 2 : 1));
  blocked.start();
  block({point, normal, 1.0F, own}, blocked);
  blocked.end();
  std::vector<float> shares(open.empty() ? 0 : sectors_);
  if (!open.empty()) side_shares(normal, shares);
  std::fill(open.begin(), open.end(), 0.0F);
  const float weight = 1.0F / static_cast<float>(blocked.tables());
  float result = 0.0F;
  for (std::size_t table = 0; table < blocked.tables(); ++table) {
    float sum = 0.0F;
    for (std::size_t s = 0; s < sectors_; ++s) {
      const float taken = blocked.of_sector(table, s);
      sum += taken;
      if (!open.empty() && (!bins_ || glm::dot(normal, bins_->direction(s)) > 0.0F))
        open[s] += weight * std::max(0.0F, shares[s] - taken);
    }
    result += weight * (1.0F - std::min(1.0F, sum));
  }
  return result;
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

void Accessibility::add(float form_factor, const Vec3& direction, std::uint32_t blocker, const Receiver& receiver,
                        Blocked& blocked) const {
  const Node& node = hierarchy_.nodes()[blocker];
  const DirectionBins::Place around = bins_ ? bins_->place(direction) : DirectionBins::Place{};
  const bool shows_front = glm::dot(direction, node.normal) < 0.0F;
  const Sectors behind = sectors_of(around, !shows_front, node.normal),
                here = sectors_of(around, receiver.side > 0.0F, receiver.normal);
  blocked.add(blocker, form_factor, here, behind);
  // Sides alone are taken as in the text.
  if (bins_ && node.sheet != several_sheets) blocked.add_to_sheet(node.sheet, shows_front, form_factor, here);
}

/// Part by part: a near cell is seen under many directions.
void Accessibility::block_by_cell(std::uint32_t leaf, const Receiver& receiver, Blocked& blocked) const {
  const std::uint32_t element = hierarchy_.element(hierarchy_.nodes()[leaf]);
  if (elements_.parts(element).empty()) {
    block_by_points(leaf, receiver, blocked);
    return;
  }
  for (const CellPart& part : elements_.parts(element)) {
    const float form_factor =
        elements_.exposed_share(element) * polygon_form_factor(receiver.point, receiver.looks(), part.corners);
    if (!(form_factor > 0.0F)) continue;
    const Vec3 d = 0.25F * (part.corners[0] + part.corners[1] + part.corners[2] + part.corners[3]) - receiver.point;
    const float squared = glm::dot(d, d);
    add(form_factor, squared > 0.0F ? d / std::sqrt(squared) : receiver.looks(), leaf, receiver, blocked);
  }
}

/// Point by point, each as a disc with its share of the area, whichever side it shows.
void Accessibility::block_by_points(std::uint32_t leaf, const Receiver& receiver, Blocked& blocked) const {
  const std::uint32_t element = hierarchy_.element(hierarchy_.nodes()[leaf]);
  const auto points = elements_.points(element);
  float exposed = 0.0F;
  for (const CellPoint& point : points)
    if (point.exposed) exposed += 1.0F;
  const float area = elements_.disc(element).area / std::max(1.0F, exposed);
  for (const CellPoint& point : points) {
    if (!point.exposed) continue;
    const Vec3 d = 0.5F * (point.origin + point.behind) - receiver.point;
    const float squared = glm::dot(d, d), u = glm::dot(receiver.looks(), d), v = std::fabs(glm::dot(point.normal, d));
    if (u > 0.0F) add(u * v * area / (squared * (pi * squared + area)), d / std::sqrt(squared), leaf, receiver, blocked);
  }
}

void Accessibility::block(const Receiver& receiver, Blocked& blocked) const {
  // The back of a two-sided sheet is where its front is: one of the two blocks.
  for (std::size_t root = 0; root < hierarchy_.roots().size(); ++root)
    if (!hierarchy_.is_of_backs(root)) block_by_tree(hierarchy_.roots()[root], receiver, blocked);
}

void Accessibility::block_by_tree(std::uint32_t root, const Receiver& receiver, Blocked& blocked) const {
  const auto nodes = hierarchy_.nodes();
  const Vec3 normal = receiver.looks();
  visit_down(nodes, root, [&](std::uint32_t index) {
    const Node& node = nodes[index];
    const Vec3 d = node.centre - receiver.point;
    const float squared = glm::dot(d, d), r = std::sqrt(squared);
    const float disc_reach = std::sqrt(node.area / pi);
    const float u = glm::dot(normal, d), v = -glm::dot(node.normal, d), m = glm::dot(normal, node.normal);
    const float across = std::sqrt(std::max(0.0F, 1.0F - m * m));
    const float stray = node.thickness * std::fabs(m) + (node.reach + 2.0F * disc_reach) * across;
    if (u + stray <= coplanar * (r + node.reach)) return false;
    ++blocked.evaluations;
    const float bound = node.area / (pi * squared + node.area);
    const bool stands = !node.is_leaf() && bound < far_enough_ && node.cone_sine < wide_cone && r > node.reach;
    if (!node.is_leaf() && !stands) return true;
    if (node.is_leaf() && hierarchy_.element(node) == receiver.own) return false;
    if (node.is_leaf() && (squared < near_radii * near_radii * disc_reach * disc_reach || u < stray))
      block_by_cell(index, receiver, blocked);
    else if (u > 0.0F && r > 0.0F)
      add(disc_share(node, squared, u / r, std::fabs(v) / r, v < 0.0F ? -m : m), d / r, index, receiver, blocked);
    return false;
  });
}

}  // namespace gibench::antiradiance
