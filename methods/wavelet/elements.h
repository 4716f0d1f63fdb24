/// Elements and their quadtrees: where the functions of the basis live.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/finite_elements/grouped.h"
#include "common/method/task.h"
#include "common/ray/world.h"
#include "methods/wavelet/haar_step.h"
#include "methods/wavelet/patch.h"

namespace gibench::wavelet {

inline constexpr std::uint32_t none = 0xffffffffU;
/// Points of a node, four in each child, one in each of the children's children.
inline constexpr std::size_t points_a_node = child_count * child_count;

/// A part of an element. Children follow one another, and stand behind their parents.
struct Node {
  Patch patch;
  float area = 0.0F;              ///< m², without what lies inside other geometry
  std::uint32_t first_child = 0;  ///< 0: a leaf
  std::uint32_t parent = none;
  std::uint32_t element = 0;
  std::uint32_t group = none;  ///< of the coefficients of the functions on it; none of leaves that are no root

  bool is_leaf() const { return first_child == 0; }
};

/// One side of a flat piece of the scene: the root of a quadtree.
struct Element {
  Vec3 normal{0.0F};    ///< unit, on the element's side
  float offset = 0.0F;  ///< metres off the surface at which rays begin and end
  std::uint32_t triangle = 0;
  std::uint32_t object = 0;
  bool front = true;
  std::uint32_t root = 0, end = 0;  ///< its nodes
};

/// A place of a node that stands for a sixteenth of it.
struct NodePoint {
  Vec3 position{0.0F};
  float area = 0.0F;  ///< m²; 0: inside other geometry, or behind a surface in the same plane
};

/// The functions on one node that is no leaf, or a root: slot 0 is the smooth function of a root, slots 1 to 3 are wavelets.
struct Group {
  std::uint32_t node = 0;
  std::uint8_t first = 1, end = 4;  ///< slots in use
  std::size_t functions() const { return end - first; }
};

struct ElementOptions {
  double leaf_area = 0.0;  ///< m²: leaves are about as large
  bool cuts = true;        ///< see flat_pieces()
  int exposure_rays = 4;   ///< from each point; all meet black backs: it lies inside geometry; 0: none does
  std::size_t most_elements = std::size_t{1} << 15U;
};

/// The elements of a scene and the nodes of their quadtrees, all of an element's leaves at one depth. Immutable.
class Elements {
 public:
  Elements() = default;
  Elements(const World& world, const ElementOptions& options, Task& task);

  /// How many there would have been where that is more than the options allow: there are none then. 0: they are all there.
  std::size_t refused() const { return refused_; }

  std::span<const Element> elements() const { return elements_; }
  std::span<const Node> nodes() const { return nodes_; }
  std::span<const Group> groups() const { return groups_; }
  std::span<const std::uint32_t> leaves() const { return leaves_; }  ///< nodes
  std::uint32_t leaf_of(std::uint32_t node) const { return leaf_of_node_[node]; }
  const HaarStep& step(std::uint32_t group) const { return steps_[group]; }
  std::size_t functions() const { return functions_; }

  const Element& element_of(std::uint32_t node) const { return elements_[nodes_[node].element]; }
  /// Sixteen; after keep_points() fewer, and of leaves alone.
  std::span<const NodePoint> points(std::uint32_t node) const {
    const std::size_t row = kept_points_ > 0 ? leaf_of_node_[node] : node,
                      count = kept_points_ > 0 ? kept_points_ : points_a_node;
    return std::span(points_).subspan(row * count, count);
  }
  /// Once the kernel needs no more points: so many of each leaf stay, spread over its children, none that is hidden.
  void keep_points(std::size_t of_leaf);
  Vec3 origin(std::uint32_t node, const NodePoint& point) const {
    return point.position + element_of(node).offset * element_of(node).normal;
  }
  /// A point of a node as light arrives there.
  SurfaceSample sample(const World& world, std::uint32_t node, const NodePoint& point) const;

  /// The leaf at a place of the scene's surfaces; none where there is no element.
  std::uint32_t leaf_at(const World& world, const SurfaceSample& sample) const;

  std::size_t bytes() const;

 private:
  void add_element(const Patch& patch, Element element, double leaf_area);
  void find_sides(const World& world);
  void find_points(const World& world, const ElementOptions& options, Task& task);
  void place_points(const World& world, std::uint32_t leaf, int exposure_rays, std::uint64_t seed, RayStream& rays);
  void gather_areas();
  void add_groups();

  std::vector<Element> elements_;
  std::vector<Node> nodes_;
  std::vector<NodePoint> points_;
  std::vector<Group> groups_;
  std::vector<HaarStep> steps_;
  std::vector<std::uint32_t> leaves_, leaf_of_node_;
  std::vector<std::uint32_t> first_triangle_;  ///< of a scene triangle: itself, or the other of its quad, which elements name
  std::optional<Grouped> by_side_;             ///< elements of sides of scene triangles
  std::size_t functions_ = 0;
  std::size_t refused_ = 0;
  std::size_t kept_points_ = 0;  ///< of every leaf; 0: all points of all nodes
};

}  // namespace gibench::wavelet
