/// Unoccluded form factors of discs, bounded at any distance.
#pragma once

#include "common/core/lanes.h"
#include "common/core/vec.h"

namespace gibench::antiradiance {

struct Disc {
  Vec3 centre{0.0F};
  Vec3 normal{0.0F};  ///< unit
  float area = 0.0F;  ///< m²
};

/// A_i F_ij = A_j F_ji of two coaxial parallel discs whose centres are the square root of `squared_distance` apart, m²; a²
/// is area / π. The closed form (π/2)(S − √(S² − 4 a_i² a_j²)), S = r² + a_i² + a_j² (Howell, C-41), written without
/// cancellation; never more than the smaller area. A number, or eight.
template <class Number>
Number coaxial_exchange(const Number& squared_distance, float area_i, const Number& area_j) {
  const float ai = area_i * (1.0F / pi);
  const Number aj = area_j * (1.0F / pi), s = squared_distance + ai + aj, product = 2.0F * square_root(ai * aj);
  const Number root = square_root(larger(Number{}, (s - product) * (s + product)));
  return s > 0.0F ? 2.0F * pi * ai * aj / (s + root) : Number{};
}

/// What the coaxial form is multiplied by for discs that do not face each other: the cosines, and the second-order terms
/// of the Taylor series of cos cos / r² over both discs that the coaxial form does not hold. `u` and `v`: distance of
/// either centre from the other's plane (not negative) over r; `m`: n_i·n_j on the sides that face each other; `ti`, `tj`: a²/S.
template <class Number>
Number orientation_factor(const Number& u, const Number& v, const Number& m, const Number& ti, const Number& tj) {
  const Number tilt = 1.0F + ti * (2.0F - 3.0F * u * u) + tj * (2.0F - 3.0F * v * v);
  return smaller(larger(u * v * tilt - m * (ti * u * u + tj * v * v), Number{}), Number{} + 1.0F);
}

/// A_i F_ij between the sides of two discs that face each other, m²: symmetric to the last bit, bounded by the smaller
/// area at any distance. Zero where either centre lies in the other's plane. Sides: ±normal, whichever looks at the other.
float disc_exchange(const Disc& i, const Disc& j);

/// F_ij between those sides, in [0, 1].
inline float disc_form_factor(const Disc& i, const Disc& j) { return i.area > 0.0F ? disc_exchange(i, j) / i.area : 0.0F; }

}  // namespace gibench::antiradiance
