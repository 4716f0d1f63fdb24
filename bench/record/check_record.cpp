#include "bench/record/check_record.h"

#include "bench/record/json_fields.h"
#include "bench/record/space_record.h"
#include "common/scene/light_kinds.h"

namespace gibench {

namespace {

constexpr const char* emitting_materials = "emitting_materials";

Json cameras_json(const std::vector<MeasuredCamera>& cameras) {
  Json list = Json::array();
  for (const MeasuredCamera& camera : cameras) write_camera(list.emplace_back(), camera, "name");
  return list;
}

Json light_kinds_json(const LightCounts& lights) {
  Json json{{emitting_materials, lights.emitting_materials}};
  for (std::size_t kind = 0; kind < lights.of_kind.size(); ++kind) json[light_kinds()[kind].name] = lights.of_kind[kind];
  return json;
}

LightCounts light_kinds_of(const Json& json) {
  LightCounts lights;
  read_field(json, emitting_materials, lights.emitting_materials);
  for (std::size_t kind = 0; kind < lights.of_kind.size(); ++kind)
    read_field(json, light_kinds()[kind].name, lights.of_kind[kind]);
  return lights;
}

Json plans_json(const std::vector<PlanRecord>& methods) {
  Json list = Json::array();
  for (const PlanRecord& planned : methods) {
    Json json{{"method", planned.method},
              {"plan", to_json(planned.plan)},
              {"light_paths", planned.light_paths},
              {"complete", planned.complete}};
    write_field(json, "refusal", planned.refusal);
    list.push_back(std::move(json));
  }
  return list;
}

Json coincidences_json(const CoincidenceCounts& counts) {
  return {{"twins", counts.twins}, {"opposite_twins", counts.opposite_twins}, {"overlaps", counts.overlaps}};
}

CoincidenceCounts coincidences_of(const Json& json) {
  CoincidenceCounts counts;
  read_field(json, "twins", counts.twins);
  read_field(json, "opposite_twins", counts.opposite_twins);
  read_field(json, "overlaps", counts.overlaps);
  return counts;
}

PlanRecord plan_record_of(const Json& json) {
  PlanRecord planned;
  read_field(json, "method", planned.method);
  planned.plan = effect_plan_of(object_field(json, "plan"));
  read_field(json, "light_paths", planned.light_paths);
  read_field(json, "complete", planned.complete);
  read_field(json, "refusal", planned.refusal);
  return planned;
}

}  // namespace

Json to_json(const CheckRecord& record) {
  Json json{{"scene", record.scene},
            {"file", record.file},
            {"key", record.analysis.key},
            {"geometry", to_json(record.analysis.geometry)},
            {"coincident_triangles", coincidences_json(record.coincident)},
            {"spaces", to_json(record.spaces)},
            {"cameras", cameras_json(record.cameras)},
            {"lights", record.lights},
            {"warnings", record.warnings},
            {"light_kinds", light_kinds_json(record.light_kinds)},
            {"effects", to_json(record.analysis.effects)},
            {"bounce_bound", to_json(record.analysis.bounce_bound)},
            {"changes", record.changes},
            {"analysis_seconds", record.analysis.seconds},
            {"methods", plans_json(record.methods)}};
  write_exposure(json, record.exposure);
  return json;
}

CheckRecord check_record_of(const Json& json) {
  CheckRecord record;
  read_field(json, "scene", record.scene);
  read_field(json, "file", record.file);
  record.analysis.key = json.at("key").get<std::string>();
  record.analysis.geometry = geometry_report_of(object_field(json, "geometry"));
  record.coincident = coincidences_of(object_field(json, "coincident_triangles"));
  record.spaces = space_report_of(object_field(json, "spaces"));
  for (const Json& camera : object_field(json, "cameras"))
    if (const auto measured = camera_in(camera, "name")) record.cameras.push_back(*measured);
  read_field(json, "lights", record.lights);
  read_field(json, "warnings", record.warnings);
  record.light_kinds = light_kinds_of(object_field(json, "light_kinds"));
  record.analysis.effects = evidence_of(object_field(json, "effects"));
  record.analysis.bounce_bound = bound_record_of(object_field(json, "bounce_bound"));
  read_field(json, "changes", record.changes);
  read_field(json, "analysis_seconds", record.analysis.seconds);
  for (const Json& planned : object_field(json, "methods")) record.methods.push_back(plan_record_of(planned));
  record.exposure = exposure_in(json);
  return record;
}

}  // namespace gibench
