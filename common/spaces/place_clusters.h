/// Clusters of loose geometry: places that lie together and face the same way, down to a count.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/method/task.h"
#include "common/spaces/place.h"

namespace gibench {

/// How far places come together.
struct ClusterLimits {
  std::size_t most_clusters = 1;
  float least_cosine = 0.5F;  ///< between the normal of a member and the mean of its cluster
};

/// The cluster of every place, numbered from 0 on so that neighbours have near numbers. No cluster mixes labels. Of each label a
/// tree halved in space is cut at a radius, the same for all, and what the cut leaves together is parted by normals; the radius
/// is the smallest, found by bisection, that leaves at most `most_clusters`. What lies apart from all else within a quarter of
/// that radius, and has no more area than a ball of that size, has to keep to a right angle about its mean normal only; within a
/// sixteenth to nothing: crumbs do not take up the clusters. More labels than clusters: one cluster for each label. No more
/// places than clusters: each is its own, in order. O(n log n); visits are counted as `cluster_visits`.
std::vector<std::uint32_t> cluster_places(std::span<const Place> places, const ClusterLimits& limits, Task& task);

/// One more than the largest; 0 of none.
std::size_t cluster_count(std::span<const std::uint32_t> cluster_of_place);

}  // namespace gibench
