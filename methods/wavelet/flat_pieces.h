/// The flat pieces that elements are made of: the scene's faces, cut where other surfaces stand on them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/ray/world.h"
#include "methods/wavelet/patch.h"

namespace gibench::wavelet {

struct FlatPiece {
  Patch patch;                 ///< seen from the front
  Vec3 normal{0.0F};           ///< unit, of the front
  std::uint32_t triangle = 0;  ///< of the scene, in the same plane
};

struct FlatPieces {
  std::vector<FlatPiece> pieces;
  std::size_t quads_by_triangle = 0;   ///< quads that are not planar, not convex, or cross themselves
  std::size_t faces_without_area = 0;  ///< or hidden by a twin; also one triangle of such a quad
};

/// Planar convex quads are pieces as they are, all other faces are pieces by triangle; what has no area, or is hidden by a twin,
/// is none. With `cuts`, lines on which another face meets a piece from one of its sides part it, so that no function of the
/// basis lies on both sides of a wall; each of the parts is a convex polygon, in quads and triangles. Long quads come in a row of
/// nearly square ones. Faces above `most_cut_faces` are left uncut: every pair is looked at.
FlatPieces flat_pieces(const World& world, bool cuts);

inline constexpr std::size_t most_cut_faces = 4096;

}  // namespace gibench::wavelet
