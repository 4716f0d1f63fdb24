#include "bench/record/reference_record.h"

#include "bench/record/json_fields.h"

namespace gibench {

Json to_json(const ReferenceRecord& record) {
  Json json = to_json(record.facts);
  json["scene"] = record.scene;
  write_exposure(json, record.exposure);
  if (record.camera) write_camera(json, *record.camera);
  json["version"] = record.version;
  json["commit"] = record.commit;
  if (!record.files.empty()) json["files"] = to_json(record.files);
  seal(json);
  return json;
}

ReferenceRecord read_reference_record(const std::filesystem::path& file) {
  return read_record(file, "a record of a reference", [](const Json& json) {
    if (seal_of(json) == Seal::broken) throw InputError("checksum", "does not fit what the file says");
    ReferenceRecord record;
    record.facts = reference_facts_of(json);
    read_field(json, "scene", record.scene);
    record.exposure = exposure_in(json);
    record.camera = camera_in(json);
    read_field(json, "version", record.version);
    read_field(json, "commit", record.commit);
    record.files = file_checksums_of(object_field(json, "files"));
    return record;
  });
}

}  // namespace gibench
