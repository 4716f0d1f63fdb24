#include "bench/record/pair_record.h"

#include <bit>
#include <cmath>
#include <cstring>

#include "bench/record/json_fields.h"
#include "common/core/atomic_file.h"
#include "common/core/error.h"

namespace gibench {

namespace {

static_assert(std::endian::native == std::endian::little, "parts are stored as they lie in memory");

Json terms_json(const PairTerms& terms) {
  Json::binary_t bytes(std::vector<std::uint8_t>(terms.parts.size() * sizeof(float)));
  if (!terms.parts.empty()) std::memcpy(bytes.data(), terms.parts.data(), bytes.size());
  return {{"value", terms.value},           {"influences", terms.influences},   {"parts", Json::binary(std::move(bytes))},
          {"seeds", terms.seeds},           {"point_noise", terms.point_noise}, {"mean", terms.mean},
          {"correction", terms.correction}, {"least_share", terms.least_share}};
}

PairTerms terms_of(const Json& json) {
  PairTerms terms;
  terms.value = json.at("value").get<double>();
  terms.influences = json.at("influences").get<std::vector<double>>();
  const auto& bytes = json.at("parts").get_binary();
  if (bytes.size() % sizeof(float) != 0 || bytes.size() > most_pair_parts * sizeof(float))
    throw InputError("parts", "are not 32-bit floats, at most " + std::to_string(most_pair_parts));
  terms.parts.resize(bytes.size() / sizeof(float));
  if (!bytes.empty()) std::memcpy(terms.parts.data(), bytes.data(), bytes.size());
  terms.seeds = json.at("seeds").get<std::vector<double>>();
  terms.point_noise = json.at("point_noise").get<double>();
  terms.mean = json.at("mean").get<double>();
  terms.correction = json.at("correction").get<double>();
  terms.least_share = json.at("least_share").get<double>();
  return terms;
}

PairRecord pair_record_of(const Json& json) {
  if (json.at("gibench_pairs").get<int>() != 2) throw InputError("gibench_pairs", "is not 2");
  PairRecord record;
  const Json& reference = json.at("reference");
  record.reference_key = reference.at("key").get<std::string>();
  record.samples_per_replica = reference.at("samples_per_replica").get<std::uint64_t>();
  record.replicas = reference.at("replicas").get<std::uint64_t>();
  if (record.replicas < 2) throw InputError("replicas", "are fewer than two");
  for (const auto& [component, domains] : json.at("errors").items())
    for (const auto& [domain, metrics] : domains.items()) {
      MetricPairs& of_domain =
          record.errors[known_name(all_components, component, "errors")][known_name(all_domains, domain, "errors")];
      for (const auto& [metric, terms] : metrics.items()) of_domain[metric] = terms_of(terms);
      for (const auto& [metric, read] : of_domain)
        if (read.influences.size() < 2 || read.influences.size() > record.replicas)
          throw InputError("influences", "are not those of the replicates of the reference");
    }
  return record;
}

}  // namespace

const PairTerms* PairRecord::terms(Component component, Domain domain, const std::string& metric) const {
  const auto of_component = errors.find(component);
  if (of_component == errors.end()) return nullptr;
  const auto of_domain = of_component->second.find(domain);
  if (of_domain == of_component->second.end()) return nullptr;
  const auto found = of_domain->second.find(metric);
  return found == of_domain->second.end() ? nullptr : &found->second;
}

bool can_be_compared(const PairRecord& a, const PairRecord& b) {
  return a.reference_key == b.reference_key && a.samples_per_replica == b.samples_per_replica && a.replicas == b.replicas;
}

std::string to_cbor(const PairRecord& record) {
  Json json{{"gibench_pairs", 2}};
  json["reference"] = {
      {"key", record.reference_key}, {"samples_per_replica", record.samples_per_replica}, {"replicas", record.replicas}};
  json["errors"] = Json::object();
  for (const auto& [component, domains] : record.errors)
    for (const auto& [domain, metrics] : domains)
      for (const auto& [metric, terms] : metrics)
        json["errors"][to_string(component)][to_string(domain)][metric] = terms_json(terms);
  std::string bytes;
  Json::to_cbor(json, bytes);
  return bytes;
}

PairRecord read_pair_record(const std::filesystem::path& file) {
  const std::string bytes = read_file(file);
  Json json;
  try {
    json = Json::from_cbor(bytes);
  } catch (const nlohmann::json::exception&) {  // not CBOR: no object, and refused below
  }
  return record_of(json, file, "the terms of a run's errors", pair_record_of);
}

}  // namespace gibench
