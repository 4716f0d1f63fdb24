#include "bench/record/pair_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

PairRecord made_record() {
  PairRecord record{"0123", 64, 3, {}};
  record.errors[Component::indirect][Domain::surface]["rmse"] = {
      0.25, {0.1, -0.2, 1.0 / 3.0}, {1.5F, 0.1F, -2.0F}, {0.2, 0.3}, 1e-9, 0.5, 0.0, 1.0};
  record.errors[Component::indirect][Domain::surface]["rel_mse(0.01)"] = {1.25, {0.3, 0.2, 0.1}, {1.0F}, {0.7}, 0.0,
                                                                          0.5,  -1e-3,           0.9};
  record.errors[Component::total][Domain::image]["rmse"] = {-1e-12, {0.0, 1e300, -1e-300}, {}, {-1e-12}, 0.0, 0.0, 0.0, 1.0};
  return record;
}

TEST(PairRecord, IsReadAsItWasWritten) {
  const test::ScratchFolder folder;
  const PairRecord record = made_record();
  write_file_atomically(folder / pair_file, to_cbor(record));
  const PairRecord read = read_pair_record(folder / pair_file);
  EXPECT_TRUE(can_be_compared(record, read));
  for (const auto& [component, domain, metric] :
       {std::tuple(Component::indirect, Domain::surface, "rmse"),
        std::tuple(Component::indirect, Domain::surface, "rel_mse(0.01)"), std::tuple(Component::total, Domain::image, "rmse")}) {
    const PairTerms &written = *record.terms(component, domain, metric), &found = *read.terms(component, domain, metric);
    EXPECT_EQ(found.value, written.value);
    EXPECT_EQ(found.influences, written.influences);
    EXPECT_EQ(found.parts, written.parts);
    EXPECT_EQ(found.seeds, written.seeds);
    EXPECT_EQ(found.point_noise, written.point_noise);
    EXPECT_EQ(found.mean, written.mean);
    EXPECT_EQ(found.correction, written.correction);
    EXPECT_EQ(found.least_share, written.least_share);
  }
  EXPECT_EQ(read.terms(Component::direct, Domain::surface, "rmse"), nullptr);
  EXPECT_EQ(read.terms(Component::total, Domain::image, "rel_mse(0.01)"), nullptr);
}

TEST(PairRecord, IsComparedWithThoseOfItsReferenceAlone) {
  const PairRecord record = made_record();
  PairRecord other = record;
  EXPECT_TRUE(can_be_compared(record, other));
  other.samples_per_replica = 128;
  EXPECT_FALSE(can_be_compared(record, other)) << "more paths of the same replicates";
  other = record, other.reference_key = "4567";
  EXPECT_FALSE(can_be_compared(record, other));
}

/// Every beginning of a file, and every file with one byte changed, is read or refused by name.
TEST(PairRecord, DamageIsRefused) {
  const test::ScratchFolder folder;
  const std::string whole = to_cbor(made_record());
  const auto reading = [&](const std::string& bytes) {
    write_file_atomically(folder / pair_file, bytes);
    read_pair_record(folder / pair_file);
  };
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_THAT([&] { reading(whole.substr(0, length)); },
                ThrowsMessage<InputError>(HasSubstr("is not the terms of a run's errors")));
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ 0x21);
    try {
      reading(changed);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(pair_file));
    }
  }
}

}  // namespace
}  // namespace gibench
