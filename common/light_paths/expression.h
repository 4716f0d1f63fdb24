/// Light-path expressions: a subset of the syntax of the Open Shading Language that says which light paths are meant.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/light_paths/path_event.h"

namespace gibench {

/// One operator or event of an expression.
struct PathNode {
  /// What the node is.
  enum class Kind { event, sequence, choice, repeat };
  Kind kind = Kind::event;
  PathEvents events;               ///< event: any of these
  std::vector<PathNode> children;  ///< sequence and choice: two or more; repeat: one
  int least = 0;                   ///< repeat
  std::optional<int> most;         ///< repeat; empty: no end
};

/// From the camera to the light. Events: `C` camera, `R` and `T` reflection and transmission of any kind, `D` `G` `S`
/// diffuse, glossy and mirror-like scattering of any type, `L` light without a surface, `O` emitting surface, `B`
/// background, `.` any event. `<RD>` fixes type and kind; in its two places stand a letter, `.` or a group, and the kind
/// may be left out. `[LO]` is any of a group, `[^L]` any event but those. `*`, `+`, `{m,n}`, `{m,}` and `{n}` repeat,
/// `|` chooses, `()` holds together. Spaces mean nothing. Not taken from the language: labels, `V`, `s`.
struct PathExpression {
  std::string text;
  PathNode root;
};

/// The place that errors name: "light paths 'C.*[LOB]'", of a long expression its beginning.
std::string place_of_light_paths(const std::string& text);

/// Throws InputError that gives the position (from 1) in the text and what was expected there.
PathExpression parse_light_paths(const std::string& text);

}  // namespace gibench
