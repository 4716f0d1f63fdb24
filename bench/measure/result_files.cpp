#include "bench/measure/result_files.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "common/core/atomic_file.h"
#include "common/image/image_file.h"

namespace gibench {

namespace {

std::vector<std::pair<std::string, std::string>> header_of(const RunRecord& record) {
  std::vector<std::pair<std::string, std::string>> header{{"gibench_scene", record.scene},
                                                          {"gibench_method", record.method},
                                                          {"gibench_seed", std::to_string(record.seed)},
                                                          {"gibench_version", record.origin.version},
                                                          {"gibench_commit", record.origin.commit}};
  for (const auto& [name, value] : record.parameters) header.emplace_back("gibench_parameter_" + name, to_text(value));
  return header;
}

}  // namespace

void write_preview(const std::filesystem::path& file, int width, int height, std::vector<Rgb> pixels, const Exposure& exposure) {
  const float factor = std::exp2(exposure.value);
  for (Rgb& pixel : pixels) pixel *= factor;
  write_png(file, {width, height, std::move(pixels)});
}

void write_result_files(const std::filesystem::path& folder, const RunOutcome& outcome, const Exposure& exposure) {
  if (outcome.image) {
    const int width = outcome.record.measured_at.camera->width, height = outcome.record.measured_at.camera->height;
    const std::vector<Rgb> total = outcome.image->total();
    std::vector<ImageLayer> layers{{"", total}, {"direct", outcome.image->direct}, {"indirect", outcome.image->indirect}};
    if (!outcome.image->total_variance.empty()) layers.push_back({"variance", outcome.image->total_variance});
    write_exr(folder / "image.exr", width, height, layers, header_of(outcome.record));
    write_preview(folder / "preview.png", width, height, total, exposure);
    write_preview(folder / "preview_direct.png", width, height, outcome.image->direct, exposure);
    write_preview(folder / "preview_indirect.png", width, height, outcome.image->indirect, exposure);
  }
  RunRecord record = outcome.record;
  if (outcome.pairs) {
    const std::string pairs = to_cbor(*outcome.pairs);
    write_file_atomically(folder / pair_file, pairs);
    record.files[pair_file] = checksum_of(pairs);
  }
  write_file_atomically(folder / result_file, to_json(record).dump(2) + "\n");
}

}  // namespace gibench
