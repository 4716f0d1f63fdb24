#include "common/reference/reference_store.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <system_error>

#include "common/core/atomic_file.h"
#include "common/core/hash.h"
#include "common/core/write_failure.h"
#include "common/reference/damaged_reference.h"
#include "common/reference/folder_replacement.h"
#include "common/reference/replica_file.h"
#include "common/reference/scene_key.h"

namespace gibench {

namespace {

using nlohmann::ordered_json;

/// The four sets of replicates of a reference and their files.
struct Part {
  const char* name;
  ReferenceValues Reference::*values;
  Replicas ReferenceValues::*component;

  template <class AnyReference>
  auto& of(AnyReference& reference) const {
    return reference.*values.*component;
  }
  std::string file() const { return std::string(name) + ".replicas"; }
  ReplicaFormat format(ReferenceStore::Keep keep) const {
    if (keep == ReferenceStore::Keep::all) return ReplicaFormat::exact;
    return values == &Reference::surface ? ReplicaFormat::packed : ReplicaFormat::packed_coarsely;
  }
};
constexpr std::array<Part, 4> parts{{{"surface_direct", &Reference::surface, &ReferenceValues::direct},
                                     {"surface_indirect", &Reference::surface, &ReferenceValues::indirect},
                                     {"image_direct", &Reference::image, &ReferenceValues::direct},
                                     {"image_indirect", &Reference::image, &ReferenceValues::indirect}}};

ordered_json numbers(const Vec3& v) { return {v.x, v.y, v.z}; }

ordered_json question_json(const ReferenceQuestion& question) {
  ordered_json json{{"path_class", question.path_class},
                    {"seed", question.seed},
                    {"surface_samples", question.surface_samples},
                    {"surface_domain", question.surface_domain},
                    {"pixel_samples", question.pixel_samples}};
  if (const auto& camera = question.camera)
    json["camera"] = {{"name", camera->name},
                      {"position", numbers(camera->position)},
                      {"look_at", numbers(camera->look_at)},
                      {"up", numbers(camera->up)},
                      {"vertical_fov_degrees", camera->vertical_fov_degrees},
                      {"resolution", {camera->width, camera->height}}};
  return json;
}

std::string hex_of(std::uint64_t value) { return fmt::format("{:016x}", value); }

/// Names may hold bytes that are not UTF-8.
std::string text_of(const ordered_json& json, int indent) {
  return json.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

/// meta.json guards its own numbers too: a sample count that changed would weigh a merge wrongly.
std::string guard_of(const ordered_json& meta) {
  ordered_json guarded = meta;
  guarded.erase("checksum");
  const std::string text = text_of(guarded, -1);
  return hex_of(hash_bytes(text.data(), text.size()));
}

ordered_json describe(const Scene& scene, const Reference& reference, const std::string& key) {
  ordered_json meta{{"gibench_reference", 1}, {"key", key}, {"scene", scene.name}, {"scene_key", scene_key(scene)}};
  meta.update(question_json(reference.question));
  meta["samples_per_replica"] = reference.samples_per_replica;
  if (reference.question.camera) meta["image_samples_per_replica"] = reference.image_samples_per_replica;
  if (reference.points != 0) meta["points"] = hex_of(reference.points);
  meta["seconds"] = reference.seconds;
  for (const Part& part : parts) {
    const Replicas& replicas = part.of(reference);
    ordered_json described{{"replicas", replicas.count()}, {"values", replicas.size()}};
    if (const auto error = relative_standard_error(replicas)) described["relative_standard_error"] = *error;
    meta["parts"][part.name] = described;
  }
  return meta;
}

/// The checked contents of a folder's meta.json.
ordered_json read_meta(const std::filesystem::path& file, const std::string& key) {
  ordered_json meta = ordered_json::parse(read_file(file), nullptr, false);
  if (!meta.is_object() || meta.value("checksum", ordered_json()) != guard_of(meta))
    throw DamagedReference(file, "it is not as it was written");
  if (meta.value("key", ordered_json()) != key) throw DamagedReference(file, "it belongs to another folder");
  return meta;
}

}  // namespace

ReferenceStore::ReferenceStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

std::filesystem::path ReferenceStore::folder_of(const Scene& scene, const ReferenceQuestion& question) const {
  return folder_ / reference_key(scene, question);
}

std::optional<Reference> ReferenceStore::find(const Scene& scene, const ReferenceQuestion& question) const {
  const std::filesystem::path target = folder_of(scene, question), folder = existing_version(target);
  std::error_code unreadable;
  if (!std::filesystem::exists(folder, unreadable)) return std::nullopt;
  const std::filesystem::path meta_file = folder / "meta.json";
  if (!std::filesystem::exists(meta_file, unreadable)) throw DamagedReference(meta_file, "it is missing");
  const ordered_json meta = read_meta(meta_file, target.filename().string());
  Reference reference;
  reference.question = question;
  reference.samples_per_replica = meta.at("samples_per_replica").get<std::uint64_t>();
  // Stores of before hold as many paths for each pixel as for each value at the surface.
  if (question.camera)
    reference.image_samples_per_replica = meta.value("image_samples_per_replica", reference.samples_per_replica);
  if (meta.contains("points")) reference.points = std::stoull(meta.at("points").get<std::string>(), nullptr, 16);
  reference.seconds = meta.at("seconds").get<double>();
  for (const Part& part : parts) {
    const std::string checksum = meta.at("parts").at(part.name).at("checksum").get<std::string>();
    part.of(reference) = read_replicas(folder / part.file(), std::stoull(checksum, nullptr, 16));
  }
  return reference;
}

void ReferenceStore::save(const Scene& scene, const Reference& reference, Keep keep) const {
  const std::filesystem::path target = folder_of(scene, reference.question), made = temporary_beside(target);
  std::error_code failure;
  std::filesystem::create_directories(made, failure);
  if (failure)
    throw_write_failure(folder_, "the reference store cannot be written", failure.value(),
                        "name a folder that may be written to");
  try {
    ordered_json meta = describe(scene, reference, target.filename().string());
    for (const Part& part : parts)
      meta["parts"][part.name]["checksum"] = hex_of(write_replicas(made / part.file(), part.of(reference), part.format(keep)));
    meta["checksum"] = guard_of(meta);
    write_file_atomically(made / "meta.json", text_of(meta, 2) + "\n");
    replace_folder(made, target);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove_all(made, ignored);
    throw;
  }
}

}  // namespace gibench
