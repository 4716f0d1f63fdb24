/// Facts about the sides of a scene's surfaces: how much is lit, seen, sealed, and which objects show the wrong side.
#pragma once

#include <string>
#include <vector>

#include "common/method/task.h"
#include "common/ray/world.h"

namespace gibench {

/// The fronts or the backs of an object, black ones included.
struct SideFacts {
  double lit_area = 0.0;   ///< m², reached by light (SideLight::is_reached); of black backs: by as much
  double seen_area = 0.0;  ///< m², seen by a camera, directly or by one diffuse reflection
  double power = 0.0;      ///< W that arrive, mean of the channels
};

/// Both sides of one object.
struct ObjectSides {
  std::string name;
  bool two_sided = false;
  double area = 0.0;  ///< m², one side
  SideFacts front, back;
};

/// What is lit, seen and sealed of a scene.
struct SpaceReport {
  double area = 0.0;  ///< m² of all sides that light can leave: the fronts, and the backs of two-sided objects
  // Of that area, m²:
  double lit_fronts = 0.0, lit_backs = 0.0, seen_fronts = 0.0, seen_backs = 0.0;
  double sealed = 0.0;           ///< neither lit nor seen
  bool nothing_reached = false;  ///< no light reaches any side that light can leave: all count as lit
  std::vector<ObjectSides> objects;
  std::vector<std::string> warnings;  ///< of sides that look wrong, each a sentence
};

/// Of the scene with its own lights and cameras, to the accuracy of SideLight.
SpaceReport report_spaces(const World& world, Task& task);

}  // namespace gibench
