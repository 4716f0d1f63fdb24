/// The pictures of a study for the page: linear values as half floats, one file for each layer, read when they are shown.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/collect/study.h"

namespace gibench::report {

/// Where the page finds one layer: the file, and what its numbers are to be multiplied with.
struct PageLayer {
  std::string file;
  float scale = 1.0F;
};

/// One picture. Layers are direct and indirect, whose sum is total, or total alone; the reference also has `noise`,
/// ½|A − B| of its two halves, an estimate of its own standard error.
struct PagePicture {
  std::optional<std::size_t> run;  ///< position in the study's runs; empty: the reference
  int width = 0, height = 0;
  std::map<std::string, PageLayer> layers;
};

/// Writes the pictures of a scene below `assets_folder`/`slug` and says what was written. A picture that cannot be
/// read is left out, with a line in `warnings`.
std::vector<PagePicture> write_pictures(const Study& study, std::size_t scene, const std::filesystem::path& data_folder,
                                        std::vector<std::string>& warnings);

}  // namespace gibench::report
