/// The kinds of change that a scene's edits make, from its lights alone to its shape.
#pragma once

#include <set>
#include <string>

#include "common/scene/scene.h"

namespace gibench {

/// A kind of change, from the smallest to the largest: what a method has to compute again depends on it.
enum class Change {
  lights,       ///< a light, or what a material emits
  albedo,       ///< diffuse reflectances
  material,     ///< anything else about how a surface reflects
  motion,       ///< rigid
  deformation,  ///< other geometry
};
const char* to_string(Change change);

/// Every edit's, taken one after the other; an edit that changes nothing counts for nothing.
std::set<Change> changes_of(const Scene& scene);
/// "none", "lights only", "lights, motion"
std::string names_of(const std::set<Change>& changes);

}  // namespace gibench
