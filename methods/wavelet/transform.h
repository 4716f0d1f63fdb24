/// The Haar transform over all elements: from means over the leaves to coefficients and back.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "methods/wavelet/elements.h"

namespace gibench::wavelet {

/// Coefficients of one function on all surfaces: four slots a group, those that a group does not use are zero. The functions are
/// orthonormal over the surfaces' area.
template <class Value>
using Coefficients = std::vector<Value>;

template <class Value>
Coefficients<Value> coefficients_of(const Elements& elements, std::span<const Value> leaf_means) {
  const std::span nodes = elements.nodes();
  std::vector<Value> smooth(nodes.size());
  Coefficients<Value> result(elements.groups().size() * child_count);
  for (std::size_t n = nodes.size(); n-- > 0;) {
    const Node& node = nodes[n];
    if (node.is_leaf()) smooth[n] = leaf_means[elements.leaf_of(static_cast<std::uint32_t>(n))] * std::sqrt(node.area);
    if (node.group == none) continue;
    std::array<Value, child_count> functions{};
    if (node.is_leaf()) {
      functions[0] = smooth[n];
    } else {
      std::array<Value, child_count> children{};
      for (std::size_t c = 0; c < child_count; ++c) children[c] = smooth[node.first_child + c];
      functions = elements.step(node.group).up(children);
      smooth[n] = functions[0];
    }
    const Group& group = elements.groups()[node.group];
    for (std::size_t k = group.first; k < group.end; ++k) result[node.group * child_count + k] = functions[k];
  }
  return result;
}

/// Means over the leaves; zero where a leaf has no area.
template <class Value>
std::vector<Value> leaf_means_of(const Elements& elements, std::span<const Value> coefficients) {
  const std::span nodes = elements.nodes();
  std::vector<Value> smooth(nodes.size()), means(elements.leaves().size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const Node& node = nodes[n];
    if (node.group != none) {
      std::array<Value, child_count> functions{};
      for (std::size_t k = 0; k < child_count; ++k) functions[k] = coefficients[node.group * child_count + k];
      if (node.parent == none) smooth[n] = functions[0];
      functions[0] = smooth[n];
      if (!node.is_leaf()) {
        const std::array<Value, child_count> children = elements.step(node.group).down(functions);
        for (std::size_t c = 0; c < child_count; ++c) smooth[node.first_child + c] = children[c];
      }
    }
    if (node.is_leaf() && node.area > 0.0F)
      means[elements.leaf_of(static_cast<std::uint32_t>(n))] = smooth[n] * (1.0F / std::sqrt(node.area));
  }
  return means;
}

}  // namespace gibench::wavelet
