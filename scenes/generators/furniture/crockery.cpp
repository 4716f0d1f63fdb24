#include "scenes/generators/furniture/crockery.h"

#include <cmath>

namespace gibench::generators {

namespace {

constexpr int columns = 16;

/// A vessel with walls of `wall` metres: the outside from the foot to the rim and back down to `floor` inside.
Mesh vessel(const std::vector<ProfilePoint>& outside, double wall, double floor) {
  std::vector<ProfilePoint> profile{{0.0, outside.front().y}};
  profile.insert(profile.end(), outside.begin(), outside.end());
  for (std::size_t i = outside.size(); i-- > 0;)
    if (outside[i].y > floor) profile.push_back({outside[i].radius - wall, outside[i].y});
  profile.push_back({0.6 * profile.back().radius, floor});
  profile.push_back({0.0, floor});
  return lathe(profile, columns);
}

/// Half a ring in the x-y plane from `low` to `high`, bulging towards `bulge`.
Mesh handle(const Vec3d& low, const Vec3d& high, const Vec3d& bulge, double radius) {
  std::vector<Vec3d> points;
  for (int i = 0; i <= 10; ++i) {
    const double angle = pi_double * i / 10.0;
    points.push_back(0.5 * (low + high) - 0.5 * std::cos(angle) * (high - low) + std::sin(angle) * bulge);
  }
  return pipe(points, 6, radius);
}

}  // namespace

Mesh plate(double radius) {
  return vessel({{0.55 * radius, 0.0}, {0.6 * radius, 0.006}, {0.85 * radius, 0.012}, {radius, 0.022}}, 0.004, 0.009);
}

Mesh bowl(double radius, double height) {
  std::vector<ProfilePoint> outside{{0.4 * radius, 0.0}, {0.42 * radius, 0.008}};
  for (int i = 1; i <= 7; ++i) {
    const double angle = 0.5 * pi_double * i / 7.0;
    outside.push_back({radius * (0.42 + 0.58 * std::sin(angle)), 0.008 + (height - 0.008) * (1.0 - std::cos(angle))});
  }
  return vessel(outside, 0.006, 0.012);
}

Mesh cup() {
  Mesh mesh = vessel({{0.025, 0.0}, {0.030, 0.006}, {0.037, 0.03}, {0.040, 0.055}, {0.041, 0.08}}, 0.003, 0.008);
  mesh.append(handle({0.036, 0.02, 0.0}, {0.039, 0.065, 0.0}, {0.028, 0.0, 0.0}, 0.004));
  return mesh;
}

Mesh teapot() {
  std::vector<ProfilePoint> body{{0.0, 0.0}, {0.05, 0.0}};
  for (int i = 1; i <= 9; ++i) {
    const double angle = pi_double * (0.12 + 0.76 * i / 9.0);
    body.push_back({0.085 * std::sin(angle) + 0.004, 0.06 * (1.0 - std::cos(angle))});
  }
  for (const ProfilePoint& point :
       {ProfilePoint{0.042, 0.122}, {0.03, 0.132}, {0.01, 0.137}, {0.008, 0.143}, {0.014, 0.15}, {0.008, 0.158}})
    body.push_back(point);
  body.push_back({0.0, 0.159});
  Mesh mesh = lathe(body, columns);
  mesh.append(pipe({{0.07, 0.045, 0.0}, {0.11, 0.055, 0.0}, {0.13, 0.09, 0.0}, {0.155, 0.125, 0.0}}, 10,
                   [](double t) { return 0.02 - 0.011 * t; }));
  mesh.append(handle({-0.08, 0.04, 0.0}, {-0.066, 0.105, 0.0}, {-0.05, 0.0, 0.0}, 0.006));
  return mesh;
}

Mesh vase(double height, double foot_radius, double belly) {
  std::vector<ProfilePoint> outside;
  for (int i = 0; i <= 16; ++i) {
    const double t = i / 16.0, swell = std::pow(std::sin(pi_double * std::pow(t, 0.8)), 1.5);
    outside.push_back({foot_radius * (1.0 - 0.25 * t + (belly - 1.0) * swell + 0.5 * std::pow(t, 12.0)), t * height});
  }
  return vessel(outside, 0.004, 0.02);
}

Mesh candlestick(double height) {
  Mesh mesh = lathe({{0.0, 0.0},
                     {0.05, 0.0},
                     {0.052, 0.008},
                     {0.03, 0.018},
                     {0.012, 0.03},
                     {0.018, 0.3 * height},
                     {0.010, 0.6 * height},
                     {0.026, 0.95 * height},
                     {0.026, height},
                     {0.0, height}},
                    18);
  mesh.append(lathe(
      {{0.0, height + 0.001}, {0.011, height + 0.001}, {0.011, height + 0.19}, {0.004, height + 0.2}, {0.0, height + 0.2}}, 14));
  return mesh;
}

}  // namespace gibench::generators
