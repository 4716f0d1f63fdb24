#include "tests/bench/app/small_study.h"

#include <gtest/gtest.h>

namespace gibench::test {

using Json = nlohmann::ordered_json;

Json small_study(const std::vector<int>& samples) {
  return {{"gibench_study", 1},
          {"name", "small"},
          {"scenes", {"room.scene.json"}},
          {"methods", {{{"method", "pathtracer"}, {"sweep", {{"samples", samples}}}}}},
          {"reference", {{"samples", 16}}},
          {"surface_samples", 64},
          {"pixel_samples", 1},
          {"time_limit_seconds", 60}};
}

Outcome study(const Workshop& shop, const Json& json, const std::vector<std::string>& more, const std::string& before) {
  shop.write("small.study.json", json);
  std::vector<std::string> arguments{"study", "small.study.json", "--out", "out"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return shop.gibench(arguments, before);
}

Json run_of(const Json& manifest, const std::string& id) {
  for (const Json& run : manifest["runs"])
    if (run["id"] == id) return run;
  ADD_FAILURE() << "no run " << id << " in " << manifest["runs"];
  return {};
}

Json answers_in(const Workshop& shop, const std::string& out) {
  Json answers = Json::object();
  const Json manifest = shop.read_json(out + "/manifest.json");
  for (const Json& run : manifest["runs"]) {
    Json& answer = answers[run["id"].get<std::string>()];
    answer["status"] = run["status"];
    const std::string record = out + "/" + run["folder"].get<std::string>() + "/result.json";
    if (!shop.has(record)) continue;
    Json result = shop.read_json(record);
    for (const char* key : {"parameters", "effects", "counters", "errors"}) answer[key] = result[key];
    answer["paths"] = result["reference"]["samples"];
  }
  return answers;
}

}  // namespace gibench::test
