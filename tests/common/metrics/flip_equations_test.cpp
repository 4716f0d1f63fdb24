/// FLIP against a direct transcription of its published equations (Andersson et al. 2020, sections 4.1 to 4.4; 2021, section 4)
/// in double precision: filters as two-dimensional kernels, convolved pixel by pixel, without a line shared with the program's
/// code.
///
/// The authors publish values of their tool for two photographs and two renderings only, which no generator can make again
/// (flip_truth_test.cpp compares with those where they are there). The pictures here are made anew in every run.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "common/core/random.h"
#include "common/metrics/flip.h"
#include "common/metrics/hdr_flip.h"

namespace gibench {
namespace {

constexpr int width = 40, height = 30;
constexpr double pi = std::numbers::pi;

using Triple = std::array<double, 3>;
using Picture = std::vector<Triple>;
using Map = std::vector<double>;

// --- The equations -------------------------------------------------------------------------------------------------------------

/// Linear sRGB to CIE XYZ by the primaries and the white of sRGB; and its inverse, by Cramer's rule.
constexpr double to_xyz[3][3] = {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                                 {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                                 {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};
const Triple white = {to_xyz[0][0] + to_xyz[0][1] + to_xyz[0][2], to_xyz[1][0] + to_xyz[1][1] + to_xyz[1][2],
                      to_xyz[2][0] + to_xyz[2][1] + to_xyz[2][2]};

/// X/Xn, Y/Yn, Z/Zn.
Triple relative_xyz(const Triple& rgb) {
  Triple xyz{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t c = 0; c < 3; ++c) xyz[row] += to_xyz[row][c] * rgb[c];
    xyz[row] /= white[row];
  }
  return xyz;
}

Triple rgb_of_relative_xyz(const Triple& relative) {
  const auto& m = to_xyz;
  const Triple v{relative[0] * white[0], relative[1] * white[1], relative[2] * white[2]};
  const auto determinant = [](const Triple& a, const Triple& b, const Triple& c) {  // of columns
    return a[0] * (b[1] * c[2] - c[1] * b[2]) - b[0] * (a[1] * c[2] - c[1] * a[2]) + c[0] * (a[1] * b[2] - b[1] * a[2]);
  };
  const Triple c0{m[0][0], m[1][0], m[2][0]}, c1{m[0][1], m[1][1], m[2][1]}, c2{m[0][2], m[1][2], m[2][2]};
  const double whole = determinant(c0, c1, c2);
  return {determinant(v, c1, c2) / whole, determinant(c0, v, c2) / whole, determinant(c0, c1, v) / whole};
}

Triple ycxcz_of(const Triple& rgb) {
  const Triple xyz = relative_xyz(rgb);
  return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

Triple rgb_of_ycxcz(const Triple& c) {
  const double y = (c[0] + 16) / 116;
  return rgb_of_relative_xyz({y + c[1] / 500, y, y - c[2] / 200});
}

Triple lab_of(const Triple& rgb) {
  const auto f = [](double t) {
    const double delta = 6.0 / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
  };
  const Triple xyz = relative_xyz(rgb);
  return {116 * f(xyz[1]) - 16, 500 * (f(xyz[0]) - f(xyz[1])), 200 * (f(xyz[1]) - f(xyz[2]))};
}

Triple hunt_of(const Triple& lab) { return {lab[0], 0.01 * lab[0] * lab[1], 0.01 * lab[0] * lab[2]}; }

double hyab_of(const Triple& a, const Triple& b) { return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]); }

/// A square kernel of (2 radius + 1)² weights.
struct Kernel {
  int radius;
  std::function<double(int, int)> weight;
};

/// The mean of a plane under the kernel at every pixel; beyond the border the nearest pixel counts.
Map convolved(const Map& plane, const Kernel& kernel) {
  Map out(plane.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int dy = -kernel.radius; dy <= kernel.radius; ++dy)
        for (int dx = -kernel.radius; dx <= kernel.radius; ++dx) {
          const int from_x = std::clamp(x + dx, 0, width - 1), from_y = std::clamp(y + dy, 0, height - 1);
          out[static_cast<std::size_t>(y * width + x)] +=
              kernel.weight(dx, dy) * plane[static_cast<std::size_t>(from_y * width + from_x)];
        }
  return out;
}

/// s(x, y) = Σ a √(π/b) exp(−π² (x² + y²)/b) with x, y in degrees, scaled to the sum 1; of the parameters of table 1.
Kernel contrast_kernel(std::size_t channel, double pixels_per_degree) {
  struct Gaussian {
    double a, b;
  };
  static const std::vector<std::vector<Gaussian>> table{{{1, 0.0047}}, {{1, 0.0053}}, {{34.1, 0.04}, {13.5, 0.025}}};
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * pixels_per_degree));
  const auto s = [channel, pixels_per_degree](int x, int y) {
    double sum = 0;
    for (const auto& [a, b] : table[channel])
      sum += a * std::sqrt(pi / b) * std::exp(-pi * pi * (x * x + y * y) / (pixels_per_degree * pixels_per_degree) / b);
    return sum;
  };
  double all = 0;
  for (int y = -radius; y <= radius; ++y)
    for (int x = -radius; x <= radius; ++x) all += s(x, y);
  return {radius, [s, all](int x, int y) { return s(x, y) / all; }};
}

/// −x g(x, y) or (x²/σ² − 1) g(x, y), σ = w/2 pixels per degree with w = 0.082 degrees; positive weights scaled to the sum 1,
/// negative ones to −1.
Kernel feature_kernel(bool of_points, double pixels_per_degree) {
  const double sigma = 0.5 * 0.082 * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  const auto d = [of_points, sigma](int x, int y) {
    const double g = std::exp(-(x * x + y * y) / (2 * sigma * sigma));
    return of_points ? (x * x / (sigma * sigma) - 1) * g : -x * g;
  };
  double positive = 0, negative = 0;
  for (int y = -radius; y <= radius; ++y)
    for (int x = -radius; x <= radius; ++x) (d(x, y) > 0 ? positive : negative) += std::abs(d(x, y));
  return {radius, [d, positive, negative](int x, int y) { return d(x, y) / (d(x, y) > 0 ? positive : negative); }};
}

Kernel turned(const Kernel& kernel) {
  return {kernel.radius, [weight = kernel.weight](int x, int y) { return weight(y, x); }};
}

double clamped(double value) { return std::clamp(value, 0.0, 1.0); }

/// Section 4.1: what is left of the picture at the viewing distance, in Hunt-adjusted L*a*b*.
Picture perceived(const Picture& picture, double pixels_per_degree) {
  std::array<Map, 3> planes;
  for (const Triple& pixel : picture)
    for (std::size_t c = 0; c < 3; ++c) planes[c].push_back(ycxcz_of(pixel)[c]);
  for (std::size_t c = 0; c < 3; ++c) planes[c] = convolved(planes[c], contrast_kernel(c, pixels_per_degree));
  Picture out;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const Triple rgb = rgb_of_ycxcz({planes[0][i], planes[1][i], planes[2][i]});
    out.push_back(hunt_of(lab_of({clamped(rgb[0]), clamped(rgb[1]), clamped(rgb[2])})));
  }
  return out;
}

/// Section 4.3: the norm of the luminance's derivatives along x and along y.
Map features(const Picture& picture, bool of_points, double pixels_per_degree) {
  Map luminance;
  for (const Triple& pixel : picture) luminance.push_back((ycxcz_of(pixel)[0] + 16) / 116);
  const Kernel kernel = feature_kernel(of_points, pixels_per_degree);
  const Map along_x = convolved(luminance, kernel), along_y = convolved(luminance, turned(kernel));
  Map norms;
  for (std::size_t i = 0; i < luminance.size(); ++i) norms.push_back(std::hypot(along_x[i], along_y[i]));
  return norms;
}

/// Section 4.2: HyAB^0.7, of which differences under 0.4 of the largest take 0.95 of the range.
double colour_error(const Triple& a, const Triple& b) {
  const double largest = std::pow(hyab_of(hunt_of(lab_of({0, 1, 0})), hunt_of(lab_of({0, 0, 1}))), 0.7);
  const double difference = std::pow(hyab_of(a, b), 0.7), knee = 0.4 * largest;
  return difference < knee ? 0.95 / knee * difference : 0.95 + (difference - knee) / (largest - knee) * 0.05;
}

/// Section 4.4: ΔE = ΔE_c^(1 − ΔE_f).
Map flip_by_equations(const Picture& reference, const Picture& test, double pixels_per_degree) {
  const Picture colour_r = perceived(reference, pixels_per_degree), colour_t = perceived(test, pixels_per_degree);
  const Map edges_r = features(reference, false, pixels_per_degree), edges_t = features(test, false, pixels_per_degree);
  const Map points_r = features(reference, true, pixels_per_degree), points_t = features(test, true, pixels_per_degree);
  Map errors;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const double feature = std::max(std::abs(edges_r[i] - edges_t[i]), std::abs(points_r[i] - points_t[i]));
    errors.push_back(std::pow(colour_error(colour_r[i], colour_t[i]), 1 - std::sqrt(feature / std::sqrt(2.0))));
  }
  return errors;
}

/// Narkowicz' fit of ACES (2021, section 4), with the exposure of 0.6 that is built into it taken out.
Picture tone_mapped_by_equations(const Picture& picture, double stops) {
  Picture out = picture;
  for (Triple& pixel : out)
    for (double& value : pixel) {
      const double x = 0.6 * std::exp2(stops) * std::max(0.0, value);
      value = clamped(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14));
    }
  return out;
}

Map hdr_flip_by_equations(const Picture& reference, const Picture& test, const ExposureRange& range) {
  Map largest(reference.size());
  for (int i = 0; i < range.count; ++i) {
    const double stops = range.start + (double{range.stop} - double{range.start}) * i / (range.count - 1);
    const Map errors =
        flip_by_equations(tone_mapped_by_equations(reference, stops), tone_mapped_by_equations(test, stops), 67.0206);
    for (std::size_t p = 0; p < largest.size(); ++p) largest[p] = std::max(largest[p], errors[p]);
  }
  return largest;
}

// --- The pictures --------------------------------------------------------------------------------------------------------------

struct Pair {
  std::string name;
  std::function<Triple(int x, int y, std::size_t pixel)> reference, test;
};

double number(std::size_t pixel, std::uint64_t which) { return RandomStream(21, which, pixel).next_double(); }

Triple shade(int x, int y) { return {0.2 + 0.015 * x, 0.5 - 0.01 * y, 0.3 + 0.004 * (x + y)}; }

Triple scaled(const Triple& colour, double factor) { return {factor * colour[0], factor * colour[1], factor * colour[2]}; }

std::vector<Pair> made_pairs() {
  const auto plain = [](int x, int y, std::size_t) { return shade(x, y); };
  return {
      {"ColourNoise", plain,
       [](int x, int y, std::size_t i) {
         const Triple c = shade(x, y);
         return Triple{c[0] + 0.3 * number(i, 1) - 0.15, c[1] + 0.3 * number(i, 2) - 0.15, c[2] + 0.3 * number(i, 3) - 0.15};
       }},
      {"WhiteNoise",
       [](int, int, std::size_t i) {
         return Triple{number(i, 4), number(i, 5), number(i, 6)};
       },
       [](int, int, std::size_t i) {
         return Triple{number(i, 7), number(i, 8), number(i, 9)};
       }},
      {"AMovedEdge",
       [](int x, int, std::size_t) {
         return x < 20 ? Triple{0.9, 0.1, 0.1} : Triple{0.05, 0.1, 0.6};
       },
       [](int x, int, std::size_t) {
         return x < 22 ? Triple{0.9, 0.1, 0.1} : Triple{0.05, 0.1, 0.6};
       }},
      {"ASlantedEdgeMadeSoft",
       [](int x, int y, std::size_t) {
         return scaled({0.8, 0.7, 0.6}, 2 * x > 3 * y ? 1.0 : 0.1);
       },
       [](int x, int y, std::size_t) {
         return scaled({0.8, 0.7, 0.6}, std::clamp(0.5 + 0.1 * (2 * x - 3 * y), 0.1, 1.0));
       }},
      {"ThinLinesLost",
       [](int x, int y, std::size_t) {
         return x % 8 == 3 || y % 11 == 5 ? Triple{1, 1, 1} : shade(x, y);
       },
       plain},
      {"LinesOfAnotherColour",
       [](int x, int y, std::size_t) {
         return (x + y) % 6 == 0 ? Triple{0, 1, 0} : Triple{0.1, 0.1, 0.1};
       },
       [](int x, int y, std::size_t) {
         return (x + y) % 6 == 0 ? Triple{0, 0, 1} : Triple{0.1, 0.1, 0.1};
       }},
      {"Fireflies", plain,
       [](int x, int y, std::size_t i) {
         return number(i, 10) < 0.02 ? Triple{1, 0.9, 0.8} : shade(x, y);
       }},
  };
}

/// Radiance from 0.004 to 100, a lamp that is cut off, a shadow that lacks half its light, and noise.
Pair made_hdr_pair() {
  const auto lit = [](int x, int y) {
    const bool in_lamp = x >= 24 && x < 32 && y < 5;
    return in_lamp ? Triple{100, 85, 40} : scaled({1.0, 0.8, 0.5}, 0.004 * std::exp2(0.25 * x));
  };
  return {"Hdr", [lit](int x, int y, std::size_t) { return lit(x, y); },
          [lit](int x, int y, std::size_t i) {
            const double shadow = x >= 4 && x < 14 && y >= 10 && y < 22 ? 0.5 : 1.0;
            return scaled(lit(x, y), std::min(1.0, 60 / lit(x, y)[0]) * shadow * (0.8 + 0.4 * number(i, 11)));
          }};
}

/// As floats, and those as doubles: both sides have the same picture.
std::vector<Rgb> floats_of(const std::function<Triple(int, int, std::size_t)>& colour_at, double most) {
  std::vector<Rgb> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Triple c = colour_at(x, y, pixels.size());
      const auto limited = [&](double value) { return static_cast<float>(std::clamp(value, 0.0, most)); };
      pixels.emplace_back(limited(c[0]), limited(c[1]), limited(c[2]));
    }
  return pixels;
}

Picture doubles_of(const std::vector<Rgb>& pixels) {
  Picture picture;
  for (const Rgb& pixel : pixels) picture.push_back({pixel.r, pixel.g, pixel.b});
  return picture;
}

void expect_same(const std::vector<float>& found, const Map& expected, const std::string& name) {
  double sum_found = 0, sum_expected = 0, apart = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    sum_found += found[i], sum_expected += expected[i];
    apart = std::max(apart, std::abs(found[i] - expected[i]));
  }
  const auto count = static_cast<double>(expected.size());
  EXPECT_NEAR(sum_found / count, sum_expected / count, 2e-6) << name;
  EXPECT_LT(apart, 1e-4) << name;
  EXPECT_GT(sum_expected / count, 0.01) << name << ": there is an error to find";
}

TEST(FlipEquations, HoldForMadePairs) {
  for (const Pair& pair : made_pairs())
    for (const float pixels_per_degree : {20.0F, 67.0206F, 110.0F}) {
      const std::vector<Rgb> reference = floats_of(pair.reference, 1.0), test = floats_of(pair.test, 1.0);
      expect_same(flip_map(width, height, reference, test, pixels_per_degree),
                  flip_by_equations(doubles_of(reference), doubles_of(test), double{pixels_per_degree}),
                  pair.name + " at " + std::to_string(pixels_per_degree));
    }
}

TEST(FlipEquations, HoldForAMadeHdrPair) {
  const Pair pair = made_hdr_pair();
  const std::vector<Rgb> reference = floats_of(pair.reference, 1e3), test = floats_of(pair.test, 1e3);
  for (const ExposureRange& range : {ExposureRange{-6.0F, 6.0F, 5}, automatic_exposures(reference)})
    expect_same(hdr_flip_map(width, height, reference, test, range),
                hdr_flip_by_equations(doubles_of(reference), doubles_of(test), range), pair.name);
}

/// The exposures of the 2021 paper's section 4: the tone mapper's 0.85 of the largest and of the median luminance.
TEST(FlipEquations, AutomaticExposuresAreThePapers) {
  const std::vector<Rgb> reference = floats_of(made_hdr_pair().reference, 1e3);
  std::vector<double> luminances;
  for (const Rgb& pixel : reference) luminances.push_back(relative_xyz({pixel.r, pixel.g, pixel.b})[1]);
  std::sort(luminances.begin(), luminances.end());
  const double median = 0.5 * (luminances[luminances.size() / 2 - 1] + luminances[luminances.size() / 2]);
  // x with 2.51 x² + 0.03 x = 0.85 (2.43 x² + 0.59 x + 0.14), over the built-in 0.6.
  const double a = 2.51 - 0.85 * 2.43, b = 0.03 - 0.85 * 0.59, c = -0.85 * 0.14;
  const double bright = (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a) / 0.6;
  const ExposureRange range = automatic_exposures(reference);
  EXPECT_NEAR(range.start, std::log2(bright / luminances.back()), 1e-3);
  EXPECT_NEAR(range.stop, std::log2(bright / median), 1e-3);
  EXPECT_EQ(range.count, static_cast<int>(std::ceil(std::log2(luminances.back() / median))));
}

}  // namespace
}  // namespace gibench
