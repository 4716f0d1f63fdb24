#include "scenes/generators/figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/core/random.h"

namespace gibench::generators {

namespace {

constexpr double robe_height = 1.58;  // metres, to the neck

/// What one figure has of its own.
struct Pose {
  double sway;                           ///< metres, sideways shift of the hip
  double lean;                           ///< metres, forward shift of the shoulders
  double twist;                          ///< radians, the folds' turn from hem to neck
  double folds;                          ///< number of folds at the hem
  double fold_depth;                     ///< of the radius, at the hem
  double fold_phase;                     ///< radians
  double left_arm_lift, right_arm_lift;  ///< [0, 1]: hanging to raised
  double head_turn;                      ///< radians

  explicit Pose(std::uint64_t seed) {
    RandomStream random(seed, 0x666967757265ULL, 0);
    const auto between = [&](double low, double high) { return low + (high - low) * random.next_double(); };
    sway = between(-0.06, 0.06);
    lean = between(-0.03, 0.05);
    twist = between(-1.2, 1.2);
    folds = std::floor(between(11.0, 18.0));
    fold_depth = between(0.07, 0.13);
    fold_phase = between(0.0, 2.0 * pi_double);
    left_arm_lift = between(0.0, 0.9);
    right_arm_lift = between(0.0, 0.45);
    head_turn = between(-0.6, 0.6);
  }
};

/// Piecewise cubic (Hermite, monotone enough here) through heights and half-widths of a draped body.
struct Station {
  double y, side, front;  ///< metres: height, half-width sideways and forwards
};
constexpr std::array<Station, 9> stations{{{0.00, 0.36, 0.34},
                                           {0.25, 0.30, 0.27},
                                           {0.60, 0.25, 0.21},
                                           {0.85, 0.235, 0.185},
                                           {1.02, 0.185, 0.145},
                                           {1.22, 0.225, 0.165},
                                           {1.40, 0.255, 0.140},
                                           {1.50, 0.150, 0.105},
                                           {1.58, 0.075, 0.075}}};

double catmull_rom(double a, double b, double c, double d, double t) {
  return b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
}

Station station_at(double y) {
  std::size_t i = 0;
  while (i + 2 < stations.size() && y > stations[i + 1].y) ++i;
  const Station &a = stations[i > 0 ? i - 1 : 0], &b = stations[i], &c = stations[i + 1];
  const Station& d = stations[std::min(i + 2, stations.size() - 1)];
  const double t = std::clamp((y - b.y) / (c.y - b.y), 0.0, 1.0);
  return {y, catmull_rom(a.side, b.side, c.side, d.side, t), catmull_rom(a.front, b.front, c.front, d.front, t)};
}

double signed_power(double x, double exponent) { return std::copysign(std::pow(std::abs(x), exponent), x); }

Vec3d centre_line(const Pose& pose, double y) {
  const double t = y / robe_height;
  return {pose.sway * std::sin(pi_double * t), y, pose.lean * t * t};
}

/// Superelliptic cross-sections along the centre line; folds deepest at the hem, gone at the shoulders.
Mesh robe(const Pose& pose, int rows, int columns) {
  constexpr double cap = 0.02;  // share of the rows' range that closes the hem and the neck
  return closed_grid(rows, columns, [&](double row, double angle) {
    const double y = robe_height * std::clamp((row - cap) / (1.0 - 2.0 * cap), 0.0, 1.0);
    const double closing = std::min({1.0, row / cap, (1.0 - row) / cap});
    const Station s = station_at(y);
    const double t = y / robe_height, loose = (1.0 - t) * (1.0 - t);
    const double wave = std::cos(pose.folds * angle + pose.fold_phase + pose.twist * pose.folds * 0.2 * t) +
                        0.4 * std::cos((pose.folds * 2.0 + 3.0) * angle - pose.twist * 3.0 * t);
    const double girdle = 1.0 - 0.06 * std::exp(-std::pow((y - 1.04) / 0.02, 2.0));
    const double radius = closing * girdle * (1.0 + pose.fold_depth * (0.12 + loose) * wave * (t < 0.9 ? 1.0 : (1.0 - t) * 10.0));
    const double roundness = 0.85 + 0.15 * t;  // exponent 1: an ellipse; below: squarer
    return centre_line(pose, y) + Vec3d(s.side * radius * signed_power(std::cos(angle), roundness), 0.0,
                                        -s.front * radius * signed_power(std::sin(angle), roundness));
  });
}

/// A superquadric with a chin, brows and hair: low harmonics of the direction.
Mesh head(const Pose& pose) {
  const Vec3d centre = centre_line(pose, robe_height) + Vec3d(0.0, 0.155, 0.02);
  return closed_grid(48, 64, [&](double row, double angle) {
    const double latitude = pi_double * (row - 0.5);
    const double ring = signed_power(std::cos(latitude), 0.9), height = signed_power(std::sin(latitude), 0.9);
    const double turned = angle + pose.head_turn, facing = -std::sin(turned);  // 1 towards the face
    double radius = 1.0 - 0.10 * std::max(0.0, facing) * std::max(0.0, -height);
    radius += 0.05 * std::max(0.0, facing) * std::exp(-std::pow((height + 0.05) / 0.12, 2.0)) *
              std::exp(-8.0 * std::pow(std::cos(turned), 2.0));
    radius += 0.03 * (facing < 0.0 ? -facing : 0.0) * std::cos(14.0 * turned + 6.0 * height);
    return centre + Vec3d(0.095 * radius * ring * std::cos(angle), 0.15 * height, -0.11 * radius * ring * std::sin(angle));
  });
}

/// A tube bent at the elbow, from the shoulder at `side` (-1 or 1); `lift` raises the forearm.
Mesh arm(const Pose& pose, double side, double lift) {
  const Vec3d shoulder = centre_line(pose, 1.42) + Vec3d(side * 0.20, 0.0, 0.0);
  const Vec3d elbow = shoulder + Vec3d(side * (0.10 + 0.08 * lift), -0.30 + 0.05 * lift, 0.02 + 0.08 * lift);
  const Vec3d hand = elbow + Vec3d(-side * 0.10, -0.24 + 0.45 * lift, 0.06 + 0.16 * lift);
  const auto along = [&](double t) {
    return (1.0 - t) * (1.0 - t) * shoulder + 2.0 * t * (1.0 - t) * (1.6 * elbow - 0.3 * shoulder - 0.3 * hand) + t * t * hand;
  };
  return closed_grid(40, 32, [&](double row, double angle) {
    const Vec3d centre = along(1.0 - row);
    const Vec3d ahead = glm::normalize(along(std::max(0.0, 1.0 - row - 1e-3)) - along(std::min(1.0, 1.0 - row + 1e-3)));
    const Vec3d across = glm::normalize(glm::cross(ahead, Vec3d(0.0, 0.0, 1.0)));
    const Vec3d third = glm::cross(across, ahead);
    const double radius = (0.045 + 0.03 * row) * std::sqrt(std::max(0.0, 1.0 - std::pow(2.0 * row - 1.0, 8.0))) *
                          (1.0 + 0.05 * std::cos(5.0 * angle + 20.0 * row));
    return centre + radius * (std::cos(angle) * across - std::sin(angle) * third);
  });
}

}  // namespace

Mesh figure(std::uint64_t seed, int robe_rows, int robe_columns) {
  const Pose pose(seed);
  Mesh mesh = robe(pose, robe_rows, robe_columns);
  mesh.append(head(pose));
  mesh.append(arm(pose, -1.0, pose.left_arm_lift));
  mesh.append(arm(pose, 1.0, pose.right_arm_lift));
  return mesh;
}

}  // namespace gibench::generators
