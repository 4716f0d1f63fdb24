#include "bench/measure/reference_files.h"

#include <nlohmann/json.hpp>

#include "bench/measure/run_errors.h"
#include "bench/record/machine.h"
#include "bench/record/reference_facts.h"
#include "bench/record/run_record.h"
#include "common/core/atomic_file.h"
#include "common/image/image_file.h"

namespace gibench {

void write_reference_files(const std::filesystem::path& folder, const Scene& scene, const Reference& reference) {
  const ReferenceFacts facts = facts_of(scene, reference);
  std::optional<Exposure> exposure = scene.exposure;
  if (reference.question.camera && reference.image.direct.size() > 0) {
    const Camera& camera = *reference.question.camera;
    const Replicas all = Replicas::sum(reference.image.direct, reference.image.indirect);
    const std::vector<Rgb> total = all.mean(), half_a = all.half(0), half_b = all.half(1);
    const std::vector<Rgb> direct = reference.image.direct.mean(), indirect = reference.image.indirect.mean();
    const ImageLayer layers[] = {{"", total}, {"direct", direct}, {"indirect", indirect}, {"half_a", half_a}, {"half_b", half_b}};
    const std::pair<std::string, std::string> header[] = {{"gibench_scene", scene.name},
                                                          {"gibench_reference_key", facts.key},
                                                          {"gibench_path_class", facts.path_class},
                                                          {"gibench_version", version()},
                                                          {"gibench_commit", commit()}};
    exposure = exposure_for(scene, total);
    write_exr(folder / "reference.exr", camera.width, camera.height, layers, header);
  }
  ReferenceRecord record{facts, scene.name, exposure, std::nullopt, version(), commit(), checksums_of(folder, {reference_file})};
  if (const auto& camera = reference.question.camera) record.camera = {camera->name, camera->width, camera->height};
  write_file_atomically(folder / reference_file, to_json(record).dump(2) + "\n");
}

}  // namespace gibench
