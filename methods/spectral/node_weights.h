/// The weights that nodes have at the vertices of the mesh: how values of clusters are spread over it without steps.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/method/task.h"
#include "methods/spectral/nodes.h"
#include "methods/spectral/surface_graph.h"

namespace gibench::spectral {

/// How much of a vertex's value comes from the node in a slot.
struct NodeWeight {
  std::uint32_t slot;  ///< the node's number until renumber() is called
  float weight;        ///< not negative; those of a vertex have sum 1
};

class NodeWeights {
 public:
  NodeWeights() = default;
  /// A vertex that is its node's only one has its value. Elsewhere the vertex's node and those one and two edges away in the
  /// graph, of the same material and of one kind of space, weigh (1 − d²/12)², d the distance from the vertex in standard
  /// deviations of the node's area (half a side of a rectangle over √3): 1 at the node, 0 at the next of its size, smooth
  /// between. These weights are then tilted so that the weighted mean of the nodes' places comes as near to the vertex as it can
  /// with none below zero: what is linear stays so.
  NodeWeights(const World& world, const SamplingMesh& mesh, const Nodes& nodes, const SurfaceGraph& graph, Task& task);

  /// From nodes to slots.
  void renumber(std::span<const std::uint32_t> slot_of_node);

  /// Calls add(slot, weight) for the nodes of a vertex.
  template <class Add>
  void each(std::uint32_t vertex, const Add& add) const {
    if (begin_.empty()) return add(weights_[vertex].slot, 1.0F);
    for (std::uint32_t i = begin_[vertex]; i < begin_[vertex + 1]; ++i) add(weights_[i].slot, weights_[i].weight);
  }

  std::size_t bytes() const { return begin_.size() * sizeof(std::uint32_t) + weights_.size() * sizeof(NodeWeight); }

 private:
  std::vector<std::uint32_t> begin_;  ///< of every vertex, and one more; empty: one weight a vertex
  std::vector<NodeWeight> weights_;
};

}  // namespace gibench::spectral
