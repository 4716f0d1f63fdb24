/// The Cornell boxes are what was published: measured corners, colours derived from the measured spectra.
#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>

#include "common/scene_io/load.h"
#include "tests/scenes/cornell_spectra.h"

namespace gibench {
namespace {

Scene cornell(const std::string& name) { return load_scene(GIBENCH_SOURCE_DIR "/scenes/" + name + ".scene.json"); }

/// Linear Rec. 709 of a spectrum; 2 nm steps, without a factor that all callers divide out.
RgbDouble to_rgb(const std::function<double(double)>& spectrum) {
  double x = 0.0, y = 0.0, z = 0.0;
  for (double nm = 400.0; nm <= 700.0; nm += 2.0) {
    const double s = spectrum(nm);
    x += s * cornell::at(cornell::x_bar, 10.0, nm);
    y += s * cornell::at(cornell::y_bar, 10.0, nm);
    z += s * cornell::at(cornell::z_bar, 10.0, nm);
  }
  return {3.2404542 * x - 1.5371385 * y - 0.4985314 * z, -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
          0.0556434 * x - 0.2040259 * y + 1.0572252 * z};
}

double luminous(const std::function<double(double)>& spectrum) {
  double y = 0.0;
  for (double nm = 400.0; nm <= 700.0; nm += 2.0) y += spectrum(nm) * cornell::at(cornell::y_bar, 10.0, nm);
  return y;
}

double daylight(double nm) { return cornell::at(cornell::d65, 10.0, nm); }

void expect_colour(const Rgb& actual, const RgbDouble& expected, double tolerance) {
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(static_cast<double>(actual[channel]), expected[channel], tolerance) << "channel " << channel;
}

const Material& material(const Scene& scene, const std::string& name) {
  for (const Material& m : scene.materials)
    if (m.name == name) return m;
  throw std::runtime_error("no material " + name);
}

class CornellBox : public testing::TestWithParam<const char*> {};

TEST_P(CornellBox, ReflectancesAreTheMeasuredSpectraUnderDaylight) {
  const Scene scene = cornell(GetParam());
  const RgbDouble reference = to_rgb(daylight);
  const auto albedo = [&](const std::array<int, 76>& table) {
    const RgbDouble lit = to_rgb([&](double nm) { return daylight(nm) * cornell::at(table, 4.0, nm) / 1000.0; });
    return RgbDouble(lit.r / reference.r, lit.g / reference.g, lit.b / reference.b);
  };
  expect_colour(material(scene, "white").diffuse, albedo(cornell::white), 6e-4);
  expect_colour(material(scene, "green").diffuse, albedo(cornell::green), 6e-4);
  expect_colour(material(scene, "red").diffuse, albedo(cornell::red), 6e-4);
}

TEST_P(CornellBox, EmissionIsTheMeasuredSpectrum) {
  const auto light = [](double nm) { return cornell::at(cornell::light, 100.0, nm); };
  const double unit = luminous([](double) { return 1.0; });
  expect_colour(material(cornell(GetParam()), "lamp").emission, to_rgb(light) / unit, 6e-4);
}

TEST_P(CornellBox, CornersAreTheMeasuredOnes) {
  const Scene scene = cornell(GetParam());
  std::set<std::string> corners;
  for (const Vec3& v : scene.vertices) {
    const Vec3d measured = 1000.0 * (Vec3d(v) + scene.origin);
    char text[64];
    std::snprintf(text, sizeof text, "%.1f %.1f %.1f", measured.x + 0.0, measured.y + 0.0, measured.z + 0.0);
    corners.insert(text);
  }
  for (const char* published :
       {"552.8 0.0 0.0", "549.6 0.0 559.2", "0.0 0.0 559.2", "556.0 548.8 0.0", "556.0 548.8 559.2", "0.0 548.8 559.2",
        "343.0 548.8 227.0", "213.0 548.8 332.0", "130.0 165.0 65.0", "82.0 165.0 225.0", "240.0 165.0 272.0",
        "290.0 165.0 114.0", "423.0 330.0 247.0", "265.0 330.0 296.0", "314.0 330.0 456.0", "472.0 330.0 406.0"})
    EXPECT_TRUE(corners.contains(published)) << published << " is missing";
}

TEST_P(CornellBox, TheCameraIsThePublishedOne) {
  const Scene scene = cornell(GetParam());
  const Camera& camera = scene.cameras.at(0);
  EXPECT_LT(glm::distance(Vec3d(camera.position) + scene.origin, Vec3d(0.278, 0.273, -0.8)), 1e-6);
  // Focal length 35 mm, film 25 mm high.
  EXPECT_NEAR(camera.vertical_fov_degrees, 2.0 * std::atan(12.5 / 35.0) * 180.0 / pi_double, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Both, CornellBox, testing::Values("cornell-box", "cornell-glossy"));

}  // namespace
}  // namespace gibench
