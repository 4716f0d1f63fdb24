/// A world with its basis points, for tests of the basis.
#pragma once

#include "common/core/random.h"
#include "common/geometry/surface_sampling.h"
#include "methods/meshless/coefficients.h"
#include "methods/meshless/groups.h"
#include "methods/meshless/hierarchy.h"
#include "methods/meshless/placement.h"
#include "methods/meshless/settings.h"

namespace gibench::meshless::test {

inline Settings default_settings() { return settings_from(Parameters(settings_schema(), {})); }

struct BasisScene {
  World world;
  Settings settings;
  Groups groups;
  Hierarchy hierarchy;

  explicit BasisScene(Scene scene, Settings wanted = default_settings()) : world(std::move(scene), 1), settings(wanted) {
    Task task;
    groups = make_groups(world, settings.grouping);
    hierarchy = Hierarchy(place_points(world, groups, settings, task), groups.count, settings, task);
  }

  Place place(const SurfaceSample& sample) const { return {sample.position, sample.normal, groups.of(sample)}; }
  std::vector<Place> places(std::size_t count) const {
    std::vector<Place> made;
    for (const SurfaceSample& sample : area_uniform_samples(world, count, 17)) made.push_back(place(sample));
    return made;
  }

  /// Eq. 10 on all points of the levels up to the last given.
  template <class Function>
  Coefficients approximate_fully(std::uint32_t last_level, Function&& function) const {
    Coefficients made(hierarchy);
    for (std::uint32_t level = 0; level <= last_level; ++level) {
      std::vector<Rgb> values;
      for (std::uint32_t p = hierarchy.level_begin(level); p < hierarchy.level_begin(level + 1); ++p)
        values.push_back(function(hierarchy.place(p)) - (level > 0 ? made.evaluate(hierarchy.place(p), level - 1) : Rgb()));
      for (std::uint32_t p = hierarchy.level_begin(level); p < hierarchy.level_begin(level + 1); ++p)
        made.set(p, values[p - hierarchy.level_begin(level)]);
    }
    return made;
  }
};

}  // namespace gibench::meshless::test
