/// The oracle: whether a sender and a receiver are linked, taken apart, or see nothing of each other; eight senders at a time.
#pragma once

#include <cstddef>
#include <span>

#include "methods/antiradiance/hierarchy.h"
#include "methods/antiradiance/lanes.h"
#include "methods/antiradiance/links.h"
#include "methods/antiradiance/refinement_rule.h"

namespace gibench::antiradiance {

/// Of eight pairs with one receiver. Sets of lanes are disjoint; pairs in none of them are dropped.
struct Verdicts {
  unsigned link = 0, split_sender = 0, split_receiver = 0;
  Float8 factors;  ///< of the links
  Index8 sides;    ///< of the links, as in Sender::bits
  Index8 right;    ///< the senders' second children
};

class Oracle {
 public:
  /// `nodes` and what `rule` refers to must outlive the oracle; `mean_area` is the elements', m².
  Oracle(std::span<const Node> nodes, const RefinementRule& rule, float mean_area)
      : nodes_(nodes.data()),
        radiosity_(rule.radiosity.empty() ? nullptr : rule.radiosity.data()),
        fronts_(rule.facing == Facing::fronts),
        limit_(rule.tolerance),
        per_power_(rule.mean_radiosity * mean_area > 0.0F ? 1.0F / (rule.mean_radiosity * mean_area) : 0.0F) {}

  Verdicts judge(const Node& p, const Index8& senders, const Mask8& valid) const;

 private:
  static constexpr float coplanar = 1e-5F;        // of the pair's extent: below this height over a plane nothing is seen
  static constexpr float doubtful_share = 0.25F;  // of the tolerance, for pairs that lie across each other's plane or are bent
  static constexpr float varying_share = 0.1F;    // likewise for the variation of the sender's light
  static constexpr float uneven_share = 0.005F;   // of the tolerance, times distance over reach: for a receiver's unevenness
  static constexpr float bent_sine = 0.35F;       // of a normal cone, about 20 degrees

  Float8 importance(const Float8& exchange, const Node& p, const Index8& senders) const {
    if (radiosity_ == nullptr) return exchange / p.area;
    Float8 radiosity;
    for (std::size_t k = 0; k < lanes; ++k) radiosity[k] = radiosity_[senders[k]];
    return exchange * radiosity * per_power_;
  }

  const Node* nodes_;
  const float* radiosity_;
  bool fronts_;
  float limit_, per_power_;
};

[[gnu::always_inline]] inline Verdicts Oracle::judge(const Node& p, const Index8& senders, const Mask8& valid) const {
  const auto [x, y, z, q_reach] = load_quads<offsetof(Node, centre)>(nodes_, senders);
  const auto [nx, ny, nz, q_area] = load_quads<offsetof(Node, normal)>(nodes_, senders);
  const auto [q_thickness, q_cone, right, unused] = load_quads<offsetof(Node, thickness)>(nodes_, senders);
  static_assert(offsetof(Node, right) == offsetof(Node, thickness) + 8);

  const Float8 dx = x - p.centre.x, dy = y - p.centre.y, dz = z - p.centre.z;
  const Float8 squared = dx * dx + dy * dy + dz * dz, r = square_root(squared);
  // Adding nothing makes every zero a positive one: signs are sides below.
  const Float8 signed_u = p.normal.x * dx + p.normal.y * dy + p.normal.z * dz + 0.0F,
               signed_v = -(nx * dx + ny * dy + nz * dz) + 0.0F;
  const Float8 m = p.normal.x * nx + p.normal.y * ny + p.normal.z * nz;
  const Float8 along = magnitude(m), across = square_root(larger(all(0.0F), 1.0F - m * m));
  const Float8 extent = r + p.reach + q_reach, flat = coplanar * extent;
  // How far the heights over the other's plane may stray from those of the centres.
  const Float8 stray_u = q_thickness * along + q_reach * across + p.thickness + extent * p.cone_sine;
  const Float8 stray_v = p.thickness * along + p.reach * across + q_thickness + extent * q_cone;
  const Float8 u = magnitude(signed_u), v = magnitude(signed_v);
  const bool black_back = !fronts_ && p.black_back;
  const Mask8 sees = ((black_back ? u : signed_u) + stray_u > flat) & ((fronts_ ? signed_v : v) + stray_v > flat) & valid;

  const Float8 exchange = coaxial_exchange(squared, p.area, q_area);
  const Float8 to_unit = 1.0F / larger(r, all(1e-30F)), one = all(1.0F);
  const Float8 cosines = smaller(one, (u + stray_u) * to_unit) * smaller(one, (v + stray_v) * to_unit);
  const Mask8 doubtful = (u < stray_u) | (v < stray_v) | (q_cone > bent_sine) | mask_of(p.cone_sine > bent_sine);
  const Float8 limit = doubtful ? all(limit_ * doubtful_share) : all(limit_);
  const Float8 weight = importance(exchange * cosines, p, senders);
  // The sender's light is its mean: where it varies as the form factor does, the error is of the second order.
  const Mask8 too_much = (weight > limit) | (weight * q_reach * to_unit > limit * varying_share);
  // A link's light is the same all over the receiver: its error there is of the first order in the receiver's size.
  const Mask8 too_wide = weight * p.reach * to_unit > limit * uneven_share;
  const Mask8 is_inner = std::bit_cast<Index8>(right) != 0U, p_leaf = mask_of(p.is_leaf());
  const Mask8 split_sender = sees & too_much & is_inner & (p_leaf | (q_area >= p.area));
  const Mask8 split_receiver = sees & (too_much | too_wide) & ~p_leaf & ~split_sender;

  const Index8 sign = Index8{} + Sender::back_sends, back_u = std::bit_cast<Index8>(signed_u) & sign,
               back_v = std::bit_cast<Index8>(signed_v) & sign;
  const Index8 wrong = fronts_ ? back_u | back_v : p.black_back ? Index8{} : back_u;
  const Float8 per_r = r > 0.0F ? to_unit : all(0.0F), s = pi * squared + p.area + q_area;
  const Float8 facing = std::bit_cast<Float8>(std::bit_cast<Index8>(m) ^ back_u ^ back_v);
  Verdicts found;
  found.factors = exchange * orientation_factor(u * per_r, v * per_r, facing, p.area / s, q_area / s) / p.area;
  found.sides = back_v | back_u >> 1;
  static_assert(Sender::back_receives == Sender::back_sends >> 1);
  found.right = std::bit_cast<Index8>(right);
  found.link = bits_of(sees & ~split_sender & ~split_receiver & (wrong == 0U) & (found.factors > 0.0F));
  found.split_sender = bits_of(split_sender);
  found.split_receiver = bits_of(split_receiver);
  return found;
}

}  // namespace gibench::antiradiance
