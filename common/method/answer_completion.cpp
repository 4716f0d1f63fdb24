#include "common/method/answer_completion.h"

#include <algorithm>
#include <array>

#include "common/core/random.h"

namespace gibench {

namespace {

constexpr std::size_t shade_chunk = 64;  // samples
// Light samples, and as many hemisphere samples, that the shared evaluator spends: on one surface sample at least and
// at most, and between them so that a call with few samples is answered to a few tenths of a per cent.
constexpr std::size_t least_direct_samples = 32, most_direct_samples = 65536, direct_samples_a_call = std::size_t{1} << 19;
constexpr std::uint64_t direct_stage = 0x646972656374ULL;

}  // namespace

bool follows_from_irradiance(Quantity quantity) { return quantity == Quantity::radiosity || quantity == Quantity::radiance; }

void derive_from_irradiance(const World& world, const DirectLight& direct_light, const ShadeRequest& request,
                            const ShadeAnswer& answer) {
  if (!follows_from_irradiance(request.quantity)) return;
  const bool in_all_directions = request.quantity == Quantity::radiosity;
  for (std::size_t i = 0; i < request.samples.size(); ++i) {
    const SurfaceSample& sample = request.samples[i];
    const Rgb albedo = sample.lit_side ? world.scene().material_of_object(sample.object).diffuse : Rgb();
    const Rgb factor = in_all_directions ? albedo : albedo / pi;
    const Rgb emission = in_all_directions ? direct_light.emission(sample) * pi : direct_light.emission(sample);
    if (!answer.direct.empty()) answer.direct[i] = emission + factor * answer.direct[i];
    if (!answer.indirect.empty()) answer.indirect[i] *= factor;
  }
}

void shade_direct(const World& world, const DirectLight& direct_light, const ShadeRequest& request, std::span<Rgb> direct,
                  Task& task) {
  const std::size_t wanted = direct_samples_a_call / std::max<std::size_t>(1, direct.size());
  const int samples = static_cast<int>(std::clamp(wanted, least_direct_samples, most_direct_samples));
  task.parallel_chunks(direct.size(), shade_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    const std::size_t count = range.end - range.begin;
    std::array<std::uint64_t, shade_chunk> keys;
    for (std::size_t i = 0; i < count; ++i) keys[i] = mix_keys(task.seed(), direct_stage, range.begin + i);
    const auto points = request.samples.subspan(range.begin, count);
    const auto out = direct.subspan(range.begin, count);
    if (request.quantity == Quantity::radiance)
      direct_light.radiance(points, request.toward_viewer.subspan(range.begin, count), {keys.data(), count}, samples, rays, out);
    else direct_light.irradiance(points, {keys.data(), count}, samples, rays, out);
  });
  if (request.quantity == Quantity::radiosity) derive_from_irradiance(world, direct_light, request, {direct, {}, {}, {}, {}});
}

}  // namespace gibench
