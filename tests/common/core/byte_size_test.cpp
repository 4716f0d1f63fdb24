#include "common/core/byte_size.h"

#include <gtest/gtest.h>

namespace gibench {
namespace {

TEST(ByteSize, HasThreeDigits) {
  EXPECT_EQ(byte_size(0.0), "0 B");
  EXPECT_EQ(byte_size(512.0), "512 B");
  EXPECT_EQ(byte_size(1234.0), "1.23 kB");
  EXPECT_EQ(byte_size(19'200'000.0), "19.2 MB");
  EXPECT_EQ(byte_size(3e9), "3.00 GB");
  EXPECT_EQ(byte_size(2.5e13), "25000 GB");
}

TEST(ByteSize, RoundingUpDoesNotAddADigit) {
  EXPECT_EQ(byte_size(999.7), "1.00 kB");
  EXPECT_EQ(byte_size(9996.0), "10.0 kB");
  EXPECT_EQ(byte_size(99'960.0), "100 kB");
  EXPECT_EQ(byte_size(999'600'000.0), "1.00 GB");
}

}  // namespace
}  // namespace gibench
