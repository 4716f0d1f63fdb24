/// References made of random numbers, for the store's tests.
#pragma once

#include "common/core/random.h"
#include "common/reference/reference.h"

namespace gibench::test {

inline Replicas random_replicas(std::size_t replicas, std::size_t values, std::uint64_t seed) {
  Replicas set;
  for (std::size_t r = 0; r < replicas; ++r) {
    RandomStream random(seed, 7, r);
    std::vector<Rgb>& replica = set.replicas.emplace_back();
    for (std::size_t i = 0; i < values; ++i)
      replica.push_back({random.next_float(), 2.0F * random.next_float(), random.next_float()});
  }
  return set;
}

inline Reference random_reference(const ReferenceQuestion& question, std::uint64_t seed) {
  Reference reference;
  reference.question = question;
  reference.samples_per_replica = 64;
  reference.image_samples_per_replica = question.camera ? 32 : 0;
  reference.points = 0x1234;
  reference.seconds = 1.25;
  const std::size_t pixels = question.camera ? static_cast<std::size_t>(question.camera->width * question.camera->height) : 0;
  reference.surface = {random_replicas(8, question.surface_samples, seed),
                       random_replicas(8, question.surface_samples, seed + 1)};
  reference.image = {random_replicas(8, pixels, seed + 2), random_replicas(8, pixels, seed + 3)};
  return reference;
}

inline ReferenceQuestion surface_question() { return {"C.*[LOB]", 1, 50, {}, 1}; }

inline ReferenceQuestion image_question() {
  ReferenceQuestion question = surface_question();
  question.camera = Camera{"main", {0.5F, 0.5F, 2.0F}, {0.5F, 0.5F, 0.0F}, {0.0F, 1.0F, 0.0F}, 40.0F, 6, 4};
  return question;
}

}  // namespace gibench::test
