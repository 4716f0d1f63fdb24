/// The files of one run.
#pragma once

#include <filesystem>

#include "bench/measure/run_method.h"

namespace gibench {

inline constexpr const char* log_file = "log.txt";

/// result.json, image.exr (R,G,B total; direct.*, indirect.*, variance.* of the total where known) and
/// preview.png, preview_direct.png, preview_indirect.png at the exposure; without a camera no pictures. With errors also
/// pairs.cbor, whose checksum stands in the record.
void write_result_files(const std::filesystem::path& folder, const RunOutcome& outcome, const Exposure& exposure);

/// Pictures as they are shown: values times 2^exposure, sRGB, clamped.
void write_preview(const std::filesystem::path& file, int width, int height, std::vector<Rgb> pixels, const Exposure& exposure);

}  // namespace gibench
