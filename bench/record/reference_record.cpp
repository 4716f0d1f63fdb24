#include "bench/record/reference_record.h"

#include "bench/record/json_fields.h"

namespace gibench {

Json to_json(const ReferenceRecord& record) {
  Json json = to_json(record.facts);
  json["scene"] = record.scene;
  if (record.exposure) json["exposure"] = to_json(*record.exposure);
  if (record.camera) {
    json["camera"] = record.camera->name;
    json["resolution"] = {record.camera->width, record.camera->height};
  }
  json["version"] = record.version;
  json["commit"] = record.commit;
  return json;
}

ReferenceRecord read_reference_record(const std::filesystem::path& file) {
  return read_record(file, "a record of a reference", [](const Json& json) {
    ReferenceRecord record;
    record.facts = reference_facts_of(json);
    read_field(json, "scene", record.scene);
    if (const Json* exposure = field(json, "exposure")) record.exposure = exposure_of(*exposure);
    if (const Json* name = field(json, "camera"))
      record.camera = {name->get<std::string>(), json.at("resolution").at(0).get<int>(), json.at("resolution").at(1).get<int>()};
    read_field(json, "version", record.version);
    read_field(json, "commit", record.commit);
    return record;
  });
}

}  // namespace gibench
