/// A model file in a scratch folder, loaded as a scene by itself.
#pragma once

#include <string>

#include "tests/common/scene_io/scene_text.h"
#include "tests/support/scratch_folder.h"

namespace gibench::test {

/// A fixture for the tests of one format; `ending` is that of its files' names.
class ModelTextTest : public testing::Test {
 protected:
  explicit ModelTextTest(std::string ending) : name_("m." + std::move(ending)) {}

  Scene load_model(const std::string& bytes) {
    write_text(folder_ / name_, bytes);
    return load_scene(folder_ / name_);
  }
  std::string error(const std::string& bytes) {
    return error_of([&] { load_model(bytes); });
  }

  ScratchFolder folder_;

 private:
  std::string name_;
};

}  // namespace gibench::test
