#include "bench/record/space_record.h"

#include "bench/record/json_fields.h"

namespace gibench {

namespace {

Json side_json(const SideFacts& side) {
  return {{"lit_area", side.lit_area}, {"seen_area", side.seen_area}, {"power", side.power}};
}

SideFacts side_of(const Json& json) {
  SideFacts side;
  read_field(json, "lit_area", side.lit_area);
  read_field(json, "seen_area", side.seen_area);
  read_field(json, "power", side.power);
  return side;
}

ObjectSides object_of(const Json& json) {
  ObjectSides object;
  read_field(json, "name", object.name);
  read_field(json, "two_sided", object.two_sided);
  read_field(json, "area", object.area);
  object.front = side_of(object_field(json, "front"));
  object.back = side_of(object_field(json, "back"));
  return object;
}

}  // namespace

Json to_json(const SpaceReport& report) {
  Json objects = Json::array();
  for (const ObjectSides& object : report.objects)
    objects.push_back({{"name", object.name},
                       {"two_sided", object.two_sided},
                       {"area", object.area},
                       {"front", side_json(object.front)},
                       {"back", side_json(object.back)}});
  return {{"area", report.area},
          {"lit_fronts", report.lit_fronts},
          {"lit_backs", report.lit_backs},
          {"seen_fronts", report.seen_fronts},
          {"seen_backs", report.seen_backs},
          {"sealed", report.sealed},
          {"nothing_reached", report.nothing_reached},
          {"objects", std::move(objects)}};
}

SpaceReport space_report_of(const Json& json) {
  SpaceReport report;
  read_field(json, "area", report.area);
  read_field(json, "lit_fronts", report.lit_fronts);
  read_field(json, "lit_backs", report.lit_backs);
  read_field(json, "seen_fronts", report.seen_fronts);
  read_field(json, "seen_backs", report.seen_backs);
  read_field(json, "sealed", report.sealed);
  read_field(json, "nothing_reached", report.nothing_reached);
  for (const Json& object : object_field(json, "objects")) report.objects.push_back(object_of(object));
  return report;
}

}  // namespace gibench
