/// PSNR and SSIM of what a display shows: sRGB-encoded values in [0, 1] (display_values of tone_mapping.h).
#pragma once

#include <optional>
#include <span>

#include "common/core/rgb.h"

namespace gibench {

/// The most that psnr gives: equal pictures have no ratio.
inline constexpr double most_decibels = 100.0;
/// Width and height of SSIM's window, pixels.
inline constexpr int ssim_window = 11;

/// 10 log10(1 / mean squared difference) over pixels and channels, decibels, at most most_decibels.
double psnr(std::span<const Rgb> display, std::span<const Rgb> display_reference);

/// Mean structural similarity of Wang et al. (2004): luma Y' = 0.2126 R' + 0.7152 G' + 0.0722 B', windows of 11 × 11
/// pixels weighted by a Gaussian of σ = 1.5 pixels, C1 = 0.01², C2 = 0.03², the mean over all windows that lie whole in the
/// picture. 1 for equal pictures. Empty for pictures under ssim_window pixels wide or high.
std::optional<double> ssim(int width, int height, std::span<const Rgb> display, std::span<const Rgb> display_reference);

}  // namespace gibench
