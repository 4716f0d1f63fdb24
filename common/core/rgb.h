/// Linear RGB (Rec. 709 primaries): a radiance, an irradiance, a reflectance, a throughput.
#pragma once

#include <algorithm>
#include <cmath>

namespace gibench {

/// Three channels, added and multiplied channel by channel.
template <class T>
struct BasicRgb {
  T r{}, g{}, b{};

  constexpr BasicRgb() = default;
  constexpr explicit BasicRgb(T grey) : r(grey), g(grey), b(grey) {}
  constexpr BasicRgb(T red, T green, T blue) : r(red), g(green), b(blue) {}
  template <class U>
  constexpr explicit BasicRgb(const BasicRgb<U>& o) : r(static_cast<T>(o.r)), g(static_cast<T>(o.g)), b(static_cast<T>(o.b)) {}

  constexpr T& operator[](int channel) { return channel == 0 ? r : channel == 1 ? g : b; }
  constexpr const T& operator[](int channel) const { return channel == 0 ? r : channel == 1 ? g : b; }

  constexpr BasicRgb& operator+=(const BasicRgb& o) {
    r += o.r, g += o.g, b += o.b;
    return *this;
  }
  constexpr BasicRgb& operator-=(const BasicRgb& o) {
    r -= o.r, g -= o.g, b -= o.b;
    return *this;
  }
  constexpr BasicRgb& operator*=(const BasicRgb& o) {
    r *= o.r, g *= o.g, b *= o.b;
    return *this;
  }
  constexpr BasicRgb& operator*=(T s) {
    r *= s, g *= s, b *= s;
    return *this;
  }
  constexpr BasicRgb& operator/=(T s) {
    r /= s, g /= s, b /= s;
    return *this;
  }

  friend constexpr BasicRgb operator+(BasicRgb a, const BasicRgb& c) { return a += c; }
  friend constexpr BasicRgb operator-(BasicRgb a, const BasicRgb& c) { return a -= c; }
  friend constexpr BasicRgb operator*(BasicRgb a, const BasicRgb& c) { return a *= c; }
  friend constexpr BasicRgb operator*(BasicRgb a, T s) { return a *= s; }
  friend constexpr BasicRgb operator*(T s, BasicRgb a) { return a *= s; }
  friend constexpr BasicRgb operator/(BasicRgb a, T s) { return a /= s; }
  friend constexpr bool operator==(const BasicRgb&, const BasicRgb&) = default;
};

using Rgb = BasicRgb<float>;
using RgbDouble = BasicRgb<double>;

template <class T>
constexpr T largest(const BasicRgb<T>& c) {
  return std::max(c.r, std::max(c.g, c.b));
}
template <class T>
constexpr T smallest(const BasicRgb<T>& c) {
  return std::min(c.r, std::min(c.g, c.b));
}
template <class T>
constexpr bool is_black(const BasicRgb<T>& c) {
  return c.r == T(0) && c.g == T(0) && c.b == T(0);
}
template <class T>
bool is_finite(const BasicRgb<T>& c) {
  return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}
/// Relative luminance of linear Rec. 709 (CIE 1931 Y).
template <class T>
constexpr T luminance(const BasicRgb<T>& c) {
  return T(0.2126) * c.r + T(0.7152) * c.g + T(0.0722) * c.b;
}

}  // namespace gibench
