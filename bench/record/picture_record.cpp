#include "bench/record/picture_record.h"

#include "bench/record/json_fields.h"

namespace gibench {

namespace {

constexpr const char* exposure_key = "exposure";

}  // namespace

void write_camera(Json& json, const MeasuredCamera& camera, const char* name_key) {
  json[name_key] = camera.name;
  json["resolution"] = {camera.width, camera.height};
}

std::optional<MeasuredCamera> camera_in(const Json& json, const char* name_key) {
  const Json* name = field(json, name_key);
  if (!name) return std::nullopt;
  const Json& resolution = json.at("resolution");
  return MeasuredCamera{name->get<std::string>(), resolution.at(0).get<int>(), resolution.at(1).get<int>()};
}

void write_exposure(Json& json, const std::optional<Exposure>& exposure) {
  if (exposure) json[exposure_key] = {{"value", exposure->value}, {"start", exposure->start}, {"stop", exposure->stop}};
}

std::optional<Exposure> exposure_in(const Json& json) {
  const Json* entry = field(json, exposure_key);
  if (!entry) return std::nullopt;
  Exposure exposure;
  read_field(*entry, "value", exposure.value);
  read_field(*entry, "start", exposure.start);
  read_field(*entry, "stop", exposure.stop);
  return exposure;
}

}  // namespace gibench
