#include "methods/spectral/needs.h"

#include <algorithm>

namespace gibench::spectral {

namespace {

constexpr int usual_vertices = 8000, vertices_of_fine_scenes = 16000;
constexpr std::size_t triangles_a_vertex = 2;  // of a fine scene, at least
constexpr int usual_functions = 1024, usual_part = 1000, usual_rays = 1024;
constexpr double nodes_a_function = 5.5;
constexpr int most_functions = 56000;  // columns have 16 bits, and every part ends in a block of eight
constexpr int part_of_clusters = 500, rays_of_clusters = 2048;
constexpr double usual_error = 0.01, error_of_clusters = 0.02;

}  // namespace

void settle_vertices(std::size_t triangles, Settings& settings) {
  if (settings.vertices > 0) return;
  const bool fine = settings.nodes == NodeKind::clusters && triangles > triangles_a_vertex * vertices_of_fine_scenes;
  settings.vertices = fine ? vertices_of_fine_scenes : usual_vertices;
}

void settle_basis(const Nodes& nodes, Settings& settings) {
  const bool clusters = !nodes.are_vertices();
  // All bounces in one matrix: it is dense, and inverted.
  const bool may_be_many = clusters && settings.mode == Mode::bounces;
  const int by_nodes =
      may_be_many ? std::min(most_functions, static_cast<int>(static_cast<double>(nodes.size()) / nodes_a_function)) : 0;
  if (settings.basis_functions == 0) settings.basis_functions = std::max(usual_functions, by_nodes);
  if (settings.part_vertices == 0) settings.part_vertices = clusters ? part_of_clusters : usual_part;
  if (settings.rays == 0) settings.rays = clusters ? rays_of_clusters : usual_rays;
  if (settings.compression_error < 0.0) settings.compression_error = clusters ? error_of_clusters : usual_error;
}

}  // namespace gibench::spectral
