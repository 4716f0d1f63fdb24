#include "methods/wavelet/kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "common/core/random.h"
#include "common/finite_elements/polygon_form_factor.h"

namespace gibench::wavelet {

namespace {

constexpr std::uint64_t ray_stage = 0x776b65726eULL;
constexpr int most_rounds = 4;
constexpr float near_radii = 3.0F;  // of both nodes together: nearer ones are looked at from all sixteen points

/// Form factors of a polygon from the places of a node, and what is exchanged with each of its children before visibility.
struct View {
  std::array<float, points_a_node> factor{};  ///< of the places: sixteen, or one in each child
  std::size_t places = 0;
  Four exchange{};  ///< m²
};

/// Nothing from the plane of the other element itself, where rounding alone would tell in front from behind.
float factor_at(const Vec3& point, const Vec3& normal, const Node& other, const Element& other_element) {
  if (glm::dot(point - other.patch.corners[0], other_element.normal) <= other_element.offset) return 0.0F;
  return polygon_form_factor(point, normal, std::span(other.patch.corners).first(other.patch.corner_count()));
}

View view_of(const Elements& elements, std::uint32_t from, std::uint32_t to, bool near) {
  const Node &node = elements.nodes()[from], &other = elements.nodes()[to];
  const Vec3& normal = elements.element_of(from).normal;
  const Element& other_element = elements.element_of(to);
  const std::span points = elements.points(from);
  const float other_area = other.patch.area(), exposed = other_area > 0.0F ? other.area / other_area : 0.0F;
  const auto parts = node.patch.parts();
  View view;
  for (std::size_t child = 0; child < child_count; ++child) {
    if (!near) {
      const float factor = exposed * factor_at(parts[child].middle(), normal, other, other_element);
      float area = 0.0F;
      for (std::size_t i = 0; i < child_count; ++i) area += points[child * child_count + i].area;
      view.exchange[child] = area * factor;
      view.factor[view.places++] = factor;
      continue;
    }
    const auto cells = parts[child].parts();
    for (std::size_t i = 0; i < child_count; ++i) {
      const float factor = exposed * factor_at(cells[i].middle(), normal, other, other_element);
      view.exchange[child] += points[child * child_count + i].area * factor;
      view.factor[view.places++] = factor;
    }
  }
  return view;
}

float largest_of(const View& view) { return *std::max_element(view.factor.begin(), view.factor.begin() + view.places); }

float sum_of(const Four& values) { return (values[0] + values[1]) + (values[2] + values[3]); }

/// What the places of a node differ by. Their own places do not reach its ends: a slope goes on there.
float spread_of(const View& view, const Four& open) {
  float low = view.factor[0] * open[0], high = low;
  const std::size_t in_child = view.places / child_count;
  for (std::size_t i = 0; i < view.places; ++i) {
    const float value = view.factor[i] * open[i / in_child];
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return (high - low) * (in_child == 1 ? 2.0F : 4.0F / 3.0F);
}

}  // namespace

/// Rays that were tried and those that were free, for every child of both nodes.
struct Kernel::Sight {
  Four receiver_tried{}, receiver_free{}, sender_tried{}, sender_free{};
  float tried() const { return sum_of(receiver_tried); }
  float free() const { return sum_of(receiver_free); }
  bool mixed() const { return free() > 0.0F && free() < tried(); }
  /// Where no ray of a child was tried it is as open as all; `untried`: how open that is where none was tried at all.
  static Four open(const Four& tried, const Four& free, float untried) {
    const float all = sum_of(tried), share = all > 0.0F ? sum_of(free) / all : untried;
    Four result{};
    for (std::size_t i = 0; i < child_count; ++i) result[i] = tried[i] > 0.0F ? free[i] / tried[i] : share;
    return result;
  }
};

Exchange Kernel::between(std::uint32_t receiver, std::uint32_t sender, RayStream& rays) const {
  const Node &to = elements_.nodes()[receiver], &from = elements_.nodes()[sender];
  Exchange result;
  if (!(to.area > 0.0F && from.area > 0.0F)) return result;
  if (options_.form == KernelForm::samples) return of_samples(receiver, sender, rays);
  const float distance = glm::length(to.patch.middle() - from.patch.middle());
  const bool near = distance < near_radii * (to.patch.radius() + from.patch.radius());
  const View here = view_of(elements_, receiver, sender, near), there = view_of(elements_, sender, receiver, near);
  if (!(sum_of(here.exchange) > 0.0F) && !(sum_of(there.exchange) > 0.0F)) return result;
  const Sight sight = options_.tests_visibility ? look(receiver, sender, rays) : Sight{};
  const float untried = options_.tests_visibility ? 0.0F : 1.0F;  // points that all face away see nothing of each other
  const Four open_here = Sight::open(sight.receiver_tried, sight.receiver_free, untried),
             open_there = Sight::open(sight.sender_tried, sight.sender_free, untried);
  for (std::size_t i = 0; i < child_count; ++i) {
    result.receiver[i] = here.exchange[i] * open_here[i];
    result.sender[i] = there.exchange[i] * open_there[i];
  }
  const float to_receiver = std::sqrt(to.area / from.area), to_sender = 1.0F / to_receiver;
  const float sum_here = sum_of(result.receiver), sum_there = sum_of(result.sender);
  if (!(sum_here > 0.0F && sum_there > 0.0F)) {
    // Of the rays that were tried one may have been missed; where none was tried, all.
    const float missed = options_.tests_visibility ? 1.0F / std::max(1.0F, sight.tried()) : 0.0F;
    result.receiver_spread = missed * largest_of(here) * to_receiver;
    result.sender_spread = missed * largest_of(there) * to_sender;
    return result;
  }
  result.total = 0.5F * (sum_here + sum_there);
  for (std::size_t i = 0; i < child_count; ++i) {
    result.receiver[i] *= result.total / sum_here;
    result.sender[i] *= result.total / sum_there;
  }
  result.receiver_spread = spread_of(here, open_here) * to_receiver;
  result.sender_spread = spread_of(there, open_there) * to_sender;
  return result;
}

/// Of large nodes a few rays may miss the gap that light goes through: more are tried until some are free and some are not.
Kernel::Sight Kernel::look(std::uint32_t receiver, std::uint32_t sender, RayStream& rays) const {
  Sight sight;
  RandomStream random(options_.seed, ray_stage, mix_keys(receiver, sender));
  const bool leaves = elements_.nodes()[receiver].is_leaf() && elements_.nodes()[sender].is_leaf();
  for (int round = 0; round < (leaves ? 1 : most_rounds) && !sight.mixed(); ++round)
    for (int left = options_.rays; left > 0; left -= static_cast<int>(points_a_node))
      trace(receiver, sender, std::min(left, static_cast<int>(points_a_node)), random, rays, sight);
  return sight;
}

/// Pairs of points that face each other.
struct Kernel::Segments {
  std::array<Ray, points_a_node> rays;
  std::array<std::array<std::size_t, 2>, points_a_node> children{};  ///< of the receiver and of the sender
  std::size_t count = 0, drawn = 0;                                  ///< drawn: those that face away among them
};

/// Each point of either node has one of at most sixteen rays.
Kernel::Segments Kernel::draw(std::uint32_t receiver, std::uint32_t sender, int count, RandomStream& random) const {
  Segments segments;
  const Vec3 &normal = elements_.element_of(receiver).normal, &other_normal = elements_.element_of(sender).normal;
  const std::uint64_t shift = random.next_bits();
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    const std::size_t i = (7 * k + (shift & 15)) % points_a_node, j = (11 * k + (shift >> 8 & 15)) % points_a_node;
    const NodePoint &to = elements_.points(receiver)[i], &from = elements_.points(sender)[j];
    if (!(to.area > 0.0F && from.area > 0.0F)) continue;
    ++segments.drawn;
    const Vec3 origin = elements_.origin(receiver, to), way = elements_.origin(sender, from) - origin;
    if (!(glm::dot(way, normal) > 0.0F && glm::dot(way, other_normal) < 0.0F)) continue;
    segments.rays[segments.count] = {origin, 0.0F, way, 1.0F};
    segments.children[segments.count++] = {i / child_count, j / child_count};
  }
  return segments;
}

void Kernel::trace(std::uint32_t receiver, std::uint32_t sender, int count, RandomStream& random, RayStream& rays,
                   Sight& sight) const {
  const Segments segments = draw(receiver, sender, count, random);
  std::array<std::uint8_t, points_a_node> occluded{};
  rays.occlusions(std::span(segments.rays).first(segments.count), std::span(occluded).first(segments.count));
  for (std::size_t k = 0; k < segments.count; ++k) {
    const float free = occluded[k] != 0 ? 0.0F : 1.0F;
    sight.receiver_tried[segments.children[k][0]] += 1.0F;
    sight.receiver_free[segments.children[k][0]] += free;
    sight.sender_tried[segments.children[k][1]] += 1.0F;
    sight.sender_free[segments.children[k][1]] += free;
  }
}

/// Equation 4 of the text by quasi-random pairs, and its oracle: (max K − min K) times either area. No more is exchanged than
/// either side has area.
Exchange Kernel::of_samples(std::uint32_t receiver, std::uint32_t sender, RayStream& rays) const {
  const Node &to = elements_.nodes()[receiver], &from = elements_.nodes()[sender];
  Exchange result;
  RandomStream random(options_.seed, ray_stage, mix_keys(receiver, sender));
  Four of_receiver{}, of_sender{};
  float low = std::numeric_limits<float>::infinity(), high = 0.0F, sum = 0.0F, drawn = 0.0F;
  for (int left = options_.rays; left > 0; left -= static_cast<int>(points_a_node)) {
    const Segments segments = draw(receiver, sender, std::min(left, static_cast<int>(points_a_node)), random);
    std::array<std::uint8_t, points_a_node> occluded{};
    if (options_.tests_visibility)
      rays.occlusions(std::span(segments.rays).first(segments.count), std::span(occluded).first(segments.count));
    drawn += static_cast<float>(segments.drawn);
    if (segments.count < segments.drawn) low = 0.0F;
    for (std::size_t k = 0; k < segments.count; ++k) {
      const Vec3& way = segments.rays[k].direction;
      const float squared = glm::dot(way, way);
      const float cosines =
          -glm::dot(way, elements_.element_of(receiver).normal) * glm::dot(way, elements_.element_of(sender).normal);
      const float value = occluded[k] != 0 ? 0.0F : cosines / (pi * squared * squared);
      low = std::min(low, value);
      high = std::max(high, value);
      sum += value;
      of_receiver[segments.children[k][0]] += value;
      of_sender[segments.children[k][1]] += value;
    }
  }
  if (!(sum > 0.0F)) return result;
  result.total = std::min({sum / drawn * to.area * from.area, to.area, from.area});
  for (std::size_t i = 0; i < child_count; ++i) {
    result.receiver[i] = of_receiver[i] / sum * result.total;
    result.sender[i] = of_sender[i] / sum * result.total;
  }
  result.receiver_spread = (high - low) * to.area;
  result.sender_spread = (high - low) * from.area;
  return result;
}

}  // namespace gibench::wavelet
