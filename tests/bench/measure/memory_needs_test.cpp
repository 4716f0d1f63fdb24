#include "bench/measure/memory_needs.h"

#include <gmock/gmock.h>

#include "common/core/available_memory.h"
#include "common/core/error.h"

namespace gibench {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t gigabyte = 1'000'000'000;

std::string refusal(const ReferenceQuestion& question, std::uint64_t available) {
  try {
    require_memory(question, available);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(MemoryNeeds, UsualQuestionsFit) {
  ReferenceQuestion question;
  question.surface_samples = 2048;
  question.camera = Camera{};
  question.pixel_samples = 4;
  EXPECT_EQ(refusal(question, gigabyte), "");
}

TEST(MemoryNeeds, TooManySurfaceSamplesAreRefusedByName) {
  ReferenceQuestion question;
  question.surface_samples = 100'000'000;
  EXPECT_THAT(refusal(question, 8 * gigabyte), HasSubstr("--surface-samples"));
  EXPECT_EQ(refusal(question, 80 * gigabyte), "");
}

TEST(MemoryNeeds, TooLargePicturesAreRefusedByName) {
  ReferenceQuestion question;
  question.surface_samples = 2048;
  question.camera = Camera{};
  question.camera->width = question.camera->height = 16384;
  question.pixel_samples = 4;
  EXPECT_THAT(refusal(question, 24 * gigabyte), HasSubstr("--width"));
}

TEST(MemoryNeeds, TheHintFits) {
  ReferenceQuestion question;
  question.surface_samples = 100'000'000;
  question.camera = Camera{};
  question.pixel_samples = 4;
  const std::string text = refusal(question, 8 * gigabyte);
  question.surface_samples = std::stoull(text.substr(text.rfind(' ') + 1));
  EXPECT_EQ(refusal(question, 8 * gigabyte), "");
}

TEST(MemoryNeeds, GrowWithTheSeeds) {
  ReferenceQuestion question;
  question.surface_samples = 1'000'000;
  EXPECT_EQ(refusal(question, gigabyte), "");
  EXPECT_THROW(require_memory(question, gigabyte, 64), InputError);
}

TEST(AvailableMemory, IsThere) { EXPECT_GT(available_memory(), 10'000'000U); }

}  // namespace
}  // namespace gibench
