/// Every scene file of scenes/ loads, and nobody in it ever sees the back of a one-sided surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "common/core/error.h"
#include "common/core/random.h"
#include "common/geometry/surface_sampling.h"
#include "common/ray/world.h"
#include "common/scene_io/load.h"

namespace gibench {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> scene_files() {
  std::vector<fs::path> files;
  for (const char* folder : {GIBENCH_SOURCE_DIR "/scenes", GIBENCH_BUILT_SCENES})
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      if (entry.path().filename().string().ends_with(".scene.json")) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string short_name(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.substr(0, name.find('.'));
}

bool needs_models(const fs::path& file) {
  const std::string name = short_name(file);
  return name == "sibenik" || name == "statues" || name == "sponza" || name == "veach-door";
}

/// Scenes whose parts reach into one another: where they meet, one sees the inside of the other.
bool has_joints(const fs::path& file) {
  const std::string name = short_name(file);
  return name == "colonnade" || name == "living-room" || name == "library";
}

Vec3 cosine_direction(const SurfaceSample& sample, std::uint64_t index) {
  RandomStream random(2, 3, index);
  const float radius = std::sqrt(random.next_float()), angle = 2.0F * pi * random.next_float();
  const float height = std::sqrt(std::max(1e-6F, 1.0F - radius * radius));
  return Frame(sample.normal).to_world({radius * std::cos(angle), radius * std::sin(angle), height});
}

enum class Sight { nothing, front, back };

/// What a cosine-distributed ray from the sample meets.
Sight look_from(const World& world, const SurfaceSample& sample, std::uint64_t index) {
  const Vec3 direction = cosine_direction(sample, index);
  const Hit hit = world.rays().closest_hit({world.ray_origin(sample), 0.0F, direction});
  if (!hit) return Sight::nothing;
  const SurfaceSample seen = world.sample_of_hit(hit, direction);
  const bool lamp = !is_black(world.scene().material_of_object(seen.object).emission);  // shows its back to the ceiling
  return seen.lit_side || lamp ? Sight::front : Sight::back;
}

/// The floor under a block without a bottom, or the part of a statue that reaches into its pedestal: a place from
/// which nearly everything seen is the inside of something.
bool boxed_in(const World& world, const SurfaceSample& sample) {
  int backs = 0, others = 0;
  for (std::uint64_t i = 0; i < 64; ++i) ++(look_from(world, sample, 1'000'000 + i) == Sight::back ? backs : others);
  return backs > 3 * others;
}

class SceneFile : public testing::TestWithParam<fs::path> {
 protected:
  /// Skips where the models that the scene needs are not on this machine.
  void SetUp() override {
    try {
      scene = load_scene(GetParam());
    } catch (const InputError& error) {
      if (!needs_models(GetParam())) throw;
      EXPECT_NE(std::string(error.what()).find("GIBENCH_PATH"), std::string::npos) << error.what();
      GTEST_SKIP() << error.what();
    }
  }
  Scene scene;
};

TEST_P(SceneFile, LoadsUnderItsNameWithACameraAndALight) {
  EXPECT_EQ(scene.name, short_name(GetParam()));
  EXPECT_GE(scene.cameras.size(), 1U);
  const bool glows = std::any_of(scene.objects.begin(), scene.objects.end(),
                                 [&](const Object& o) { return !is_black(scene.materials[o.material].emission); });
  EXPECT_TRUE(glows || !scene.lights.empty());
  EXPECT_TRUE(scene.exposure.has_value());
}

TEST_P(SceneFile, SurfacesSeeOnlyFronts) {
  if (needs_models(GetParam())) GTEST_SKIP() << "models from elsewhere face where they like";
  const World world(scene);
  std::size_t backs = 0, hits = 0;
  const std::vector<SurfaceSample> samples = area_uniform_samples(world, 20'000, 1);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sight sight = look_from(world, samples[i], i);
    if (sight == Sight::nothing) continue;
    ++hits;
    if (sight == Sight::back && !boxed_in(world, samples[i])) ++backs;
  }
  EXPECT_GT(hits, 100U);
  // Inside a plinth one sees the column's foot as well.
  const std::size_t allowed = has_joints(GetParam()) ? samples.size() / 50 : 0;
  EXPECT_LE(backs, allowed);
}

TEST_P(SceneFile, CamerasSeeOnlyFronts) {
  if (needs_models(GetParam())) GTEST_SKIP() << "models from elsewhere face where they like";
  const World world(scene);
  constexpr int pixels = 64;
  for (const Camera& camera : scene.cameras) {
    const Vec3 ahead = glm::normalize(camera.look_at - camera.position);
    const Vec3 right = glm::normalize(glm::cross(ahead, camera.up)), up = glm::cross(right, ahead);
    const float half = std::tan(camera.vertical_fov_degrees * pi / 360.0F);
    const float aspect = static_cast<float>(camera.width) / static_cast<float>(camera.height);
    int hits = 0, backs = 0;
    for (int y = 0; y < pixels; ++y)
      for (int x = 0; x < pixels; ++x) {
        const float across = (2.0F * (static_cast<float>(x) + 0.5F) / pixels - 1.0F) * half * aspect;
        const float upwards = (1.0F - 2.0F * (static_cast<float>(y) + 0.5F) / pixels) * half;
        const Vec3 direction = glm::normalize(ahead + across * right + upwards * up);
        const Hit hit = world.rays().closest_hit({camera.position, 0.0F, direction});
        if (!hit) continue;
        ++hits;
        if (!world.sample_of_hit(hit, direction).lit_side) ++backs;
      }
    EXPECT_EQ(backs, 0) << "camera " << camera.name;
    EXPECT_GT(hits, pixels * pixels / 3) << "camera " << camera.name << " looks past the scene";
  }
}

std::string test_name(const testing::TestParamInfo<fs::path>& file) {
  std::string name = short_name(file.param);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, SceneFile, testing::ValuesIn(scene_files()), test_name);

/// Rays from the surfaces of a closed room must all hit something.
TEST(ClosedScenes, FurnacesHaveNoHoles) {
  for (const char* name : {"furnace-cube", "furnace-irregular"}) {
    const World world(load_scene(std::string(GIBENCH_SOURCE_DIR "/scenes/") + name + ".scene.json"));
    for (std::uint64_t i = 0; i < 50'000; ++i) {
      RandomStream random(1, 2, i);
      const float z = 2.0F * random.next_float() - 1.0F, angle = 2.0F * pi * random.next_float(), r = std::sqrt(1.0F - z * z);
      const Vec3 direction(r * std::cos(angle), r * std::sin(angle), z);
      ASSERT_TRUE(world.rays().closest_hit({world.scene().cameras[0].position, 0.0F, direction})) << name;
    }
    for (const Object& object : world.scene().objects) EXPECT_EQ(object.material, world.scene().objects[0].material);
  }
}

/// No straight or broken path leads from the lit room of thin-wall into the dark one.
TEST(ClosedScenes, TheThinWallLetsNoRayThrough) {
  const World world(load_scene(GIBENCH_SOURCE_DIR "/scenes/thin-wall.scene.json"));
  const auto side = [&](const SurfaceSample& sample) {
    return sample.position.x + static_cast<float>(world.scene().origin.x) > 0.0F;
  };
  const std::vector<SurfaceSample> samples = area_uniform_samples(world, 100'000, 1);
  std::size_t crossings = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (world.scene().objects[samples[i].object].name == "edge of the wall") continue;
    const Vec3 direction = cosine_direction(samples[i], i);
    const Hit hit = world.rays().closest_hit({world.ray_origin(samples[i]), 0.0F, direction});
    if (hit && side(world.sample_of_hit(hit, direction)) != side(samples[i])) ++crossings;
  }
  EXPECT_EQ(crossings, 0U);
}

}  // namespace
}  // namespace gibench
