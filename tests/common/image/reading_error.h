/// The message of a picture that cannot be read.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "common/core/error.h"
#include "common/image/image_file.h"

namespace gibench::test {

/// What read_image throws for `file`, which must be one line.
inline std::string reading_error(const std::filesystem::path& file) {
  try {
    read_image(file);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "no error";
}

}  // namespace gibench::test
