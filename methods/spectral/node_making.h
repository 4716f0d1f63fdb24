/// The making of nodes: the vertices of a mesh that is finer than asked for come together in clusters.
#pragma once

#include "common/method/task.h"
#include "common/spaces/side_light.h"
#include "methods/spectral/interpolation.h"
#include "methods/spectral/nodes.h"
#include "methods/spectral/surface_graph.h"

namespace gibench::spectral {

/// Clusters of vertices, about `wanted` of them where light reaches, half as many more where it is bright, and some elsewhere.
/// Vertices come together that are of one material, on one side, both reached by light or both not, face nearly the same way and
/// see one another. A piece of the mesh that is as large as several nodes keeps to itself; smaller ones come together with
/// others.
Nodes cluster_vertices(const World& world, const SamplingMesh& mesh, const Interpolation& interpolation, const SideLight& light,
                       std::size_t wanted, Task& task);

/// The graph of the nodes, without edges between those that do not see each other.
SurfaceGraph graph_of(const World& world, const SamplingMesh& mesh, const Interpolation& interpolation, const Nodes& nodes,
                      Task& task);

/// Joins small pieces of the graph with what is near them, faces the same way and sees them, where there are many more than
/// `wanted`. `near`: metres, where it begins to look.
void join_pieces(const World& world, const SamplingMesh& mesh, const Nodes& nodes, std::size_t wanted, float near,
                 SurfaceGraph& graph, Task& task);

}  // namespace gibench::spectral
