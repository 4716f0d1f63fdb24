#include "methods/spectral/relighting.h"

#include <algorithm>
#include <cmath>

#include "common/method/series_termination.h"

namespace gibench::spectral {

namespace {

constexpr std::size_t slot_chunk = 4096, row_chunk = 32;

/// Root mean squares over slots.
struct Change {
  double change = 0.0, whole = 0.0;
};

class Frame {
 public:
  Frame(const Transfer& transfer, std::span<const Rgb4> direct, std::span<const Rgb4> reflectance, Task& task)
      : transfer_(transfer), direct_(direct), reflectance_(reflectance), task_(task), light_(transfer.basis.columns()) {}

  /// The light that leaves the surfaces, projected: S (ρ/π (E + E_i)).
  const std::vector<Rgb4>& projected(const std::vector<Rgb4>& indirect) {
    transfer_.basis.project_reflected(reflectance_, direct_, indirect, light_, task_);
    return light_;
  }

  /// As projected() left it.
  const std::vector<Rgb4>& light() const { return light_; }

  Change change_between(const std::vector<Rgb4>& before, const std::vector<Rgb4>& after) const {
    std::vector<Change> sums(chunk_count(after.size(), slot_chunk));
    task_.parallel_chunks(after.size(), slot_chunk, [&](const ChunkRange& range) {
      Change& sum = sums[range.chunk];
      for (std::size_t i = range.begin; i < range.end; ++i) {
        const Rgb now = after[i], change = now - Rgb(before[i]);
        sum.change += static_cast<double>(change.r * change.r + change.g * change.g + change.b * change.b);
        sum.whole += static_cast<double>(now.r * now.r + now.g * now.g + now.b * now.b);
      }
    });
    Change total;
    for (const Change& sum : sums) total.change += sum.change, total.whole += sum.whole;
    return {std::sqrt(total.change), std::sqrt(total.whole)};
  }

  /// A matrix per channel, or one for all.
  void multiply(const std::vector<TransferMatrix>& by_channel, const std::vector<Rgb4>& light, std::vector<Rgb4>& out) const {
    by_channel.front().multiply(light, out, task_);
    std::vector<Rgb4> other(by_channel.size() > 1 ? out.size() : 0);
    for (std::size_t channel = 1; channel < by_channel.size(); ++channel) {
      by_channel[channel].multiply(light, other, task_);
      for (std::size_t i = 0; i < out.size(); ++i) (channel == 1 ? out[i].g : out[i].b) = channel == 1 ? other[i].g : other[i].b;
    }
  }

  /// G times the light that leaves the surfaces straight from the lights: that of all bounces, as projected() left it.
  std::vector<Rgb4> folded(const std::vector<std::vector<float>>& by_channel) const {
    std::vector<Rgb4> sum(light_.size());
    task_.parallel_chunks(sum.size(), row_chunk, [&](const ChunkRange& range) {
      for (std::size_t row = range.begin; row < range.end; ++row)
        for (int channel = 0; channel < 3; ++channel) {
          const std::vector<float>& matrix = by_channel[std::min(static_cast<std::size_t>(channel), by_channel.size() - 1)];
          double value = 0.0;
          for (std::size_t c = 0; c < light_.size(); ++c)
            value += static_cast<double>(matrix[row * light_.size() + c]) * static_cast<double>(Rgb(light_[c])[channel]);
          (channel == 0 ? sum[row].r : channel == 1 ? sum[row].g : sum[row].b) = static_cast<float>(value);
        }
    });
    return sum;
  }

  void gather_harmonics(const std::vector<Rgb4>& light, Relit& relit) const {
    const Rgb constant(spherical_harmonics({0.0F, 0.0F, 1.0F})[0]);
    relit.harmonics.resize(transfer_.glossy_slots.size());
    std::vector<Rgb4> slice(transfer_.glossy_slots.size());
    for (std::size_t i = 0; i < relit.harmonics.size(); ++i)
      relit.harmonics[i][0] = Rgb(relit.irradiance[transfer_.glossy_slots[i]]) * constant;
    for (std::size_t k = 1; k < harmonic_count; ++k) {
      transfer_.harmonic_slices[k - 1].multiply(light, slice, task_);
      for (std::size_t i = 0; i < slice.size(); ++i) relit.harmonics[i][k] = slice[i];
    }
  }

 private:
  const Transfer& transfer_;
  std::span<const Rgb4> direct_, reflectance_;
  Task& task_;
  std::vector<Rgb4> light_;
};

/// Bounce after bounce until the plan's bound, or until those left out hold too little to matter.
void bounce(const Transfer& transfer, const BounceBound& bound, Frame& frame, Relit& relit, Task& task) {
  BounceSeries series(bound);
  std::vector<Rgb4> before(relit.irradiance.size());  // at first no indirect light
  double previous = 0.0;
  while (series.goes_on() && !task.cancelled()) {
    std::swap(before, relit.irradiance);
    transfer.one_bounce.multiply(frame.projected(before), relit.irradiance, task);
    const Change change = frame.change_between(before, relit.irradiance);
    const double ratio = previous > 0.0 ? change.change / previous : fading_ratio;
    previous = change.change;
    series.add(ratio, change.whole > 0.0 ? change.change / change.whole * ratio / share_lost(ratio) : 0.0);
  }
  relit.bounces = series.bounces();
  relit.residual = series.residual();
  relit.termination = termination_of(series);
  relit.message = series.message();
}

}  // namespace

Relit relight(const Transfer& transfer, std::span<const Rgb4> direct, std::span<const Rgb4> reflectance, const BounceBound& bound,
              Task& task) {
  Relit relit;
  relit.irradiance.resize(direct.size());
  Frame frame(transfer, direct, reflectance, task);
  const bool harmonics = !transfer.harmonic_slices.empty();
  if (!transfer.all_bounces.empty()) {
    frame.multiply(transfer.all_bounces, frame.projected(relit.irradiance), relit.irradiance);
    relit.bounces = bound.planned.value_or(bound.most);
    if (harmonics) frame.gather_harmonics(frame.folded(transfer.all_light), relit);
    return relit;
  }
  bounce(transfer, bound, frame, relit, task);
  // The light that the last bounce gathered: so many reflections as the plan allows.
  if (harmonics && !task.cancelled()) {
    frame.gather_harmonics(frame.light(), relit);
  }
  return relit;
}

}  // namespace gibench::spectral
