#include "bench/measure/memory_needs.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/core/byte_size.h"
#include "common/core/error.h"
#include "common/core/rgb.h"
#include "common/ray/world.h"

namespace gibench {

namespace {

// Direct and indirect light, their variance, and a copy of each while errors are taken.
constexpr double bytes_of_answer = 6.0 * sizeof(Rgb);
// Of each further seed: direct and indirect light, one component of it, and what an error is made of at each value.
constexpr double bytes_of_seed = 3.0 * sizeof(Rgb) + sizeof(Rgb) + sizeof(double);
// Direct and indirect light in eight replicates.
constexpr double bytes_of_reference = 16.0 * sizeof(Rgb);

}  // namespace

MemoryNeeds memory_needs(const ReferenceQuestion& question, int seeds) {
  MemoryNeeds needs;
  const double bytes_of_values = bytes_of_answer + bytes_of_reference + (seeds - 1) * bytes_of_seed;
  needs.surface = static_cast<double>(question.surface_samples) * (sizeof(SurfaceSample) + bytes_of_values);
  if (const auto& camera = question.camera) {
    const double pixels = static_cast<double>(camera->width) * camera->height;
    // Twice: rows of camera points are joined.
    const double bytes_of_ray = 2.0 * (sizeof(SurfaceSample) + sizeof(Vec3) + sizeof(std::uint32_t)) + bytes_of_answer;
    needs.image = pixels * (question.pixel_samples * bytes_of_ray + bytes_of_values);
  }
  return needs;
}

void require_memory(const ReferenceQuestion& question, std::uint64_t available, int seeds) {
  const MemoryNeeds needs = memory_needs(question, seeds);
  if (!(needs.surface + needs.image > static_cast<double>(available))) return;
  const bool by_surface = needs.surface > needs.image;
  const double share = std::max(0.0, static_cast<double>(available) - needs.image) / std::max(1.0, needs.surface);
  throw InputError(by_surface ? "--surface-samples" : "--width",
                   by_surface ? fmt::format("{} samples and their values take {}, of {} that are free", question.surface_samples,
                                            byte_size(needs.surface), byte_size(static_cast<double>(available)))
                              : fmt::format("pictures of {} x {} pixels with {} camera rays each take {}, of {} that are free",
                                            question.camera->width, question.camera->height, question.pixel_samples,
                                            byte_size(needs.image), byte_size(static_cast<double>(available))),
                   by_surface ? fmt::format("ask for fewer than {:.0f}", share * static_cast<double>(question.surface_samples))
                              : "make the picture smaller, or give a smaller --pixel-samples");
}

}  // namespace gibench
