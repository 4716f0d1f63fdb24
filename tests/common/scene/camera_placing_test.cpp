#include <gtest/gtest.h>

#include "common/core/error.h"
#include "common/scene/scene_assembler.h"

namespace gibench {
namespace {

/// A square of this many metres about the origin, and a camera on it.
Camera placed(double size, const Vec3d& position, const Vec3d& look_at) {
  Scene scene;
  SceneAssembler assembler(scene);
  Object object;
  object.name = "ground";
  const double h = 0.5 * size;
  assembler.add_object(object, {{{-h, 0, -h}, {-h, 0, h}, {h, 0, h}, {h, 0, -h}}, {Face{{0, 1, 2, 3}}}}, "here");
  assembler.finish_geometry("here");
  Camera camera;
  assembler.place_camera(camera, position, look_at, "cameras[0].position");
  return camera;
}

Vec3 view(const Camera& camera) { return glm::normalize(camera.look_at - camera.position); }

TEST(CameraPlacing, NearTheSceneNothingMoves) {
  const Camera camera = placed(2.0, {0.5, 1.0, 0.25}, {0.5, 0.75, 0.0});
  EXPECT_EQ(camera.position, Vec3(0.5F, 1.0F, 0.25F));
  EXPECT_EQ(camera.look_at, Vec3(0.5F, 0.75F, 0.0F));
}

TEST(CameraPlacing, AViewOfLessThanARoundingStepIsKept) {
  const Vec3d position(1e7, 1e7, 1e7), ahead(0.24, -0.32, 0.0);
  const Camera camera = placed(4e7, position, position + ahead);
  const Vec3 error = view(camera) - Vec3(0.6F, -0.8F, 0.0F);
  EXPECT_LT(glm::length(error), 1e-6F);
}

TEST(CameraPlacing, AViewOfTheSmallestLengthIsKept) { EXPECT_EQ(view(placed(2.0, {0, 0, 0}, {0, 1e-200, 0})), Vec3(0, 1, 0)); }

TEST(CameraPlacing, TooFarFromTheSceneIsRefusedWithItsPlace) {
  try {
    placed(2.0, {1e19, 1e19, 1e19}, {0, 0, 0});
    FAIL() << "was placed";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("cameras[0].position"), std::string::npos);
  }
}

}  // namespace
}  // namespace gibench
