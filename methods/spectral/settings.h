/// The parameters of relighting over a spectral mesh basis, with the names of Wang, Zhu, Humphreys 2007.
#pragma once

#include "common/method/parameters.h"
#include "common/method/presets.h"

namespace gibench::spectral {

/// Which Laplacian the basis functions are eigenvectors of.
enum class Laplacian {
  cotan,  ///< cotangent weights, orthonormal by area
  graph,  ///< the paper's: 1 and -1/valence, orthonormal by valence
};
/// What holds light where the scene's own mesh is finer than asked for.
enum class NodeKind {
  clusters,  ///< clusters of vertices, down to `vertices`; small loose pieces are joined to their neighbours
  vertices,  ///< the paper's: every vertex of the mesh, every piece by itself
};
/// What the transfer matrix holds.
enum class Mode {
  bounces,       ///< T^s: one bounce; the albedos enter at run time
  fixed_albedo,  ///< T*: all bounces, with the albedos as they were at prepare()
};
/// What 16 bits leave out of the matrices.
enum class Compression {
  judged,    ///< what changes the answers to trial lights by no more than compression_error
  rounding,  ///< the paper's: what rounds to zero
};
enum class DirectAnswer {
  shared,  ///< by the shared evaluator
  basis,   ///< as the transfer sees it: projected onto the basis (the paper's figure 5d)
};

/// Each member is initialised with the default of its parameter.
struct Settings {
  // Sampling mesh.
  int vertices = 0;  ///< wanted; sets the longest edge; 0 here and below: by what the scene needs (needs.h)
  NodeKind nodes = NodeKind::clusters;
  double crease_degrees = 40.0;
  // Basis (section 3.1 and 3.3).
  int part_vertices = 0;
  int basis_functions = 0;  ///< of the whole scene
  Laplacian laplacian = Laplacian::cotan;
  // Transfer (section 3.2).
  Mode mode = Mode::bounces;
  int rays = 0;  ///< of a vertex
  Compression compression = Compression::judged;
  double compression_error = -1.0;  ///< share of the indirect light that judged compression may add; 0: 32-bit, nothing dropped
  // Relighting.
  int bounces = 1000;      ///< most bounces computed
  double residual = 1e-3;  ///< share of the solution that the bounces left out may hold
  DirectAnswer direct = DirectAnswer::shared;
  int direct_points = 4;   ///< of a mesh triangle, where its direct light is taken
  int direct_samples = 1;  ///< light samples at such a point
};

ParameterSchema settings_schema();
std::vector<Preset> presets();
Settings settings_from(const Parameters& parameters);

}  // namespace gibench::spectral
