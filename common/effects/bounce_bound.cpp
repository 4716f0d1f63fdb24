#include "common/effects/bounce_bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/scene/material_kinds.h"

namespace gibench {

namespace {

constexpr int most_bounces = 1000;  // a bound beyond it spares nobody anything

/// The least n with share^(n+1) ≤ tolerance.
std::optional<int> least_bounces(double share, double tolerance) {
  double left = share;
  for (int n = 0; n <= most_bounces; ++n, left *= share)
    if (left <= tolerance) return n;
  return std::nullopt;
}

}  // namespace

Reflectances reflectances_of(const World& world) {
  const Scene& scene = world.scene();
  Reflectances result;
  std::vector<double> area(scene.materials.size(), 0.0);
  double total = 0.0;
  for (const Object& object : scene.objects)
    for (std::uint32_t t = object.triangle_begin; t < object.triangle_end; ++t) {
      const double sides = (object.two_sided ? 2.0 : 1.0) * double{world.area(t)};
      area[object.material] += sides;
      total += sides;
    }
  for (std::size_t m = 0; m < area.size(); ++m) {
    if (!(area[m] > 0.0)) continue;
    const Material& material = scene.materials[m];
    result.area_weighted += area[m] / total * double{largest(straight_reflectance(material))};
    if (const double most{largest_reflectance(material)}; most > result.largest) {
      result.largest = most;
      result.brightest = material.name;
      result.brightest_grazes = reflects_most_at_grazing(material.bsdf);
    }
  }
  return result;
}

BounceBound bounce_bound(const Reflectances& reflectances, double tolerance) {
  BounceBound bound{least_bounces(reflectances.largest, tolerance), {}};
  if (!(reflectances.largest > 0.0)) {
    bound.why = "no surface reflects";
    return bound;
  }
  bound.why = fmt::format("largest albedo {:.3g} ('{}'{}), area-weighted {:.3g}: ", reflectances.largest, reflectances.brightest,
                          reflectances.brightest_grazes ? ", at grazing angles" : "", reflectances.area_weighted);
  if (!bound.most) {
    bound.why += fmt::format("not bounded, more than {} reflections may be needed to leave out less than {:g} of the light",
                             most_bounces, tolerance);
    return bound;
  }
  bound.why += fmt::format("more than {} reflections hold less than {:g} of the light", *bound.most, tolerance);
  if (const auto typical = least_bounces(reflectances.area_weighted, tolerance); typical && *typical < *bound.most)
    bound.why += fmt::format(" (more than about {} if every surface had the area-weighted albedo)", *typical);
  return bound;
}

}  // namespace gibench
