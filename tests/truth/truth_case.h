/// The closed-form and converged cases of cases/*.json: a scene, and questions whose answers are known.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/core/rgb.h"
#include "common/method/quantity.h"
#include "common/ray/world.h"

namespace gibench::truth {

/// Where light is asked for.
enum class Place {
  point,   ///< a point of a surface
  sensor,  ///< a point in space with a normal: a virtual irradiance meter
  mean,    ///< the mean over the area of named objects
};

struct Question {
  std::string id;
  Place place = Place::point;
  Quantity quantity = Quantity::irradiance;
  Component component = Component::total;
  std::optional<int> bounces;         ///< at most so many reflections; empty: no bound
  Vec3d point{0}, normal{0};          ///< file coordinates, metres
  Vec3d direction{0};                 ///< of radiance: unit, leaving the surface
  std::vector<std::string> surfaces;  ///< of a mean: objects
  std::vector<std::string> emitters;  ///< of a form factor: the objects that alone emit, radiance 1
  bool smooth = false;                ///< the faces stand for a smooth surface: the normal is the question's, not the face's
  double factor = 1.0;                ///< the answer is to be multiplied by this
  RgbDouble value;                    ///< the truth
  RgbDouble uncertainty;              ///< and how well it is known
};

struct TruthCase {
  std::string id, title;
  std::vector<std::string> tags;
  std::shared_ptr<const World> world;  ///< of its scene; cases run beside one another, so one thread builds it
  std::vector<Question> questions;

  const Scene& scene() const { return world->scene(); }
  bool has_tag(const std::string& tag) const;
};

/// The ids of all cases, in order.
std::vector<std::string> case_ids();
TruthCase load_case(const std::string& id);

}  // namespace gibench::truth
