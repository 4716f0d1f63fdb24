/// The part of a scene's surfaces on which methods are compared.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/ray/world.h"

namespace gibench {

/// Geometry that nobody sees must not decide a comparison.
struct SurfaceDomain {
  /// Which surfaces.
  enum class Kind {
    seen,    ///< what a camera of the scene sees, or what one diffuse reflection reaches from what it sees
    all,     ///< every side that light can leave and that is not sealed away from all light and all cameras
    whole,   ///< every side that light can leave, whatever reaches it
    objects  ///< the objects of `names`
  };
  Kind kind = Kind::all;
  std::vector<std::string> names;  ///< of objects, or of those "name/…" that a model file was split into

  bool operator==(const SurfaceDomain&) const = default;
};

/// "seen", "all", "whole", or the names joined by commas.
std::string to_string(const SurfaceDomain& domain);

/// The domain of such a text for a scene; an empty one is "seen" where the scene has a camera and "all" elsewhere. Throws
/// InputError at `place` for "seen" without a camera and for names that no object has, near ones listed.
SurfaceDomain surface_domain_of(const std::string& text, const Scene& scene, const std::string& place);

/// What a domain is for a scene.
struct DomainFacts {
  std::optional<double>
      sealed_share;              ///< of the area of the sides that light can leave: left out of `all`; empty: another domain
  bool nothing_reached = false;  ///< `all` where no light reaches any such side: nothing is left out
  /// Both in a sentence; empty where there is nothing to tell.
  std::string note() const;
};

/// `count` samples, stratified by area over the sides of the domain that light can leave (both sides of two-sided objects);
/// degenerate triangles get none, and coincident ones only where they are in front. The same seed gives the same samples for any
/// number of threads (0: all cores). Fewer where a thousand draws met nothing of the domain, none where it has no area.
///
/// Sealed are those parts of sides (SideCells) to which SideLight finds no way, neither of light nor of sight. What is sealed
/// depends on the scene and its lights, not on the seed.
///
/// A point belongs to `seen` where it is in the picture of a camera and nothing is between, or where one of 16 cosine-distributed
/// rays from it meets such a point on its lit side: what is reached by less than a sixteenth of its light is in part left out.
std::vector<SurfaceSample> domain_samples(const World& world, const SurfaceDomain& domain, std::size_t count, std::uint64_t seed,
                                          int threads = 0, DomainFacts* facts = nullptr);

}  // namespace gibench
