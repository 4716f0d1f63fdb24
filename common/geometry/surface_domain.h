/// The part of a scene's surfaces on which methods are compared.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/ray/world.h"

namespace gibench {

/// Geometry that nobody sees must not decide a comparison.
struct SurfaceDomain {
  /// Which surfaces.
  enum class Kind {
    seen,    ///< what a camera of the scene sees, or what one diffuse reflection reaches from what it sees
    all,     ///< every side that light can leave
    objects  ///< the objects of `names`
  };
  Kind kind = Kind::all;
  std::vector<std::string> names;  ///< of objects, or of those "name/…" that a model file was split into

  bool operator==(const SurfaceDomain&) const = default;
};

/// "seen", "all", or the names joined by commas.
std::string to_string(const SurfaceDomain& domain);

/// The domain of such a text for a scene; an empty one is "seen" where the scene has a camera and "all" elsewhere. Throws
/// InputError at `place` for "seen" without a camera and for names that no object has, near ones listed.
SurfaceDomain surface_domain_of(const std::string& text, const Scene& scene, const std::string& place);

/// `count` samples, stratified by area over the sides of the domain that light can leave (both sides of two-sided objects);
/// degenerate triangles get none, and coincident ones only where they are in front. The same seed gives the same samples for any
/// number of threads (0: all cores). Fewer where a thousand draws met nothing of the domain, none where it has no area.
///
/// A point belongs to `seen` where it is in the picture of a camera and nothing is between, or where one of 16 cosine-distributed
/// rays from it meets such a point on its lit side: what is reached by less than a sixteenth of its light is in part left out.
std::vector<SurfaceSample> domain_samples(const World& world, const SurfaceDomain& domain, std::size_t count, std::uint64_t seed,
                                          int threads = 0);

}  // namespace gibench
