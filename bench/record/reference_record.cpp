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
  return json;
}

ReferenceRecord read_reference_record(const std::filesystem::path& file) {
  return read_record(file, "a record of a reference", [](const Json& json) {
    ReferenceRecord record;
    record.facts = reference_facts_of(json);
    read_field(json, "scene", record.scene);
    record.exposure = exposure_in(json);
    record.camera = camera_in(json);
    read_field(json, "version", record.version);
    read_field(json, "commit", record.commit);
    return record;
  });
}

}  // namespace gibench
