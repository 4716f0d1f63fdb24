#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/core/atomic_file.h"
#include "tests/common/scene_io/scene_text.h"
#include "tests/support/exr_bytes.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

using test::ExrPart;
using test::ScratchFolder;
using testing::Contains;
using testing::HasSubstr;

ExrPart colours(int width, int height, const std::string& name) {
  const std::vector<float> ones(static_cast<std::size_t>(width * height), 1.0F);
  return {width, height, {{"B", ones}, {"G", ones}, {"R", ones}}, {}, name};
}

nlohmann::json scene_under(const std::string& picture) {
  nlohmann::json scene = test::quad_scene();
  scene["lights"] = {{{"type", "environment"}, {"file", picture}}};
  return scene;
}

TEST(Surroundings, ACubeMapIsRefusedByName) {
  const ScratchFolder folder;
  ExrPart cube = colours(1, 6, "");
  cube.attributes = {{"envmap", "envmap", std::string(1, '\1')}};
  write_file_atomically(folder / "cube.exr", test::exr_bytes({cube}));
  const std::string error = test::error_of([&] { test::load(scene_under("cube.exr"), folder.path()); });
  EXPECT_THAT(error, HasSubstr("$.lights[0].file"));
  EXPECT_THAT(error, HasSubstr("cube.exr: holds the six faces of a cube"));
}

TEST(Surroundings, PartsThatAreNotReadAreNamed) {
  const ScratchFolder folder;
  const ExrPart depth{2, 1, {{"Z", {1.0F, 2.0F}}}, {}, "depth"};
  write_file_atomically(folder / "sky.exr", test::exr_bytes({depth, colours(2, 1, "sky")}));
  EXPECT_THAT(test::load(scene_under("sky.exr"), folder.path()).warnings,
              Contains(HasSubstr("sky.exr: of its parts only \"sky\" is read")));
}

}  // namespace
}  // namespace gibench
