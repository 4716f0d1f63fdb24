/// Files of formats that the program reads but does not write, made with OpenImageIO itself.
#pragma once

#include <filesystem>

namespace gibench::test {

/// Pictures of kinds that the program reads but does not write: grey8.png, grey_alpha8.png, rgb16.png, rgba8.png (half
/// transparent) and rgb8.jpg with encoded levels 0.2, 0.4, 0.6; tiled_half.exr (70 × 50, x, y, 2), grey.exr (channel Y: x),
/// cropped.exr (display window 8 × 6, data window from (2, 3): x, y, 1) and probe.hdr (12.5, 1, 0.25).
void write_sample_files(const std::filesystem::path& folder);

}  // namespace gibench::test
