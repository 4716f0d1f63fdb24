/// The sums that blocks are held to: what arrives where every surface sends the same.
#pragma once

#include "common/method/task.h"
#include "methods/wavelet/blocks.h"
#include "methods/wavelet/elements.h"

namespace gibench::wavelet {

/// Under radiosity one everywhere, a leaf of a closed scene from which rays meet nothing but lit sides gets exactly one, and no
/// leaf gets more: an opening may be too small for the rays of any leaf. Quadrature and sampled visibility miss that by a little,
/// which many bounces between bright walls make large: so every block is multiplied by a factor of each of its ends, found by
/// iteration, the same for light either way. `rays`: of every leaf; 0: no leaf counts as closed in. Counts `closed_leaves`;
/// returns by how much a leaf is off at most at the end.
float hold_to_sums(const World& world, const Elements& elements, int rays, Blocks& blocks, Task& task);

/// Irradiance on the leaves under radiosity one everywhere.
std::vector<float> uniform_response(const Elements& elements, const Blocks& blocks, std::span<const float> factor_of_node,
                                    Task& task);

}  // namespace gibench::wavelet
