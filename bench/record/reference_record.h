/// The record of a stored reference that was written out, reference.json, written and read here.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "bench/record/checksums.h"
#include "bench/record/picture_record.h"
#include "bench/record/reference_facts.h"

namespace gibench {

inline constexpr const char* reference_file = "reference.json";

struct ReferenceRecord {
  ReferenceFacts facts;
  std::string scene;
  std::optional<Exposure> exposure;  ///< at which its picture is shown
  std::optional<MeasuredCamera> camera;
  std::string version, commit;  ///< of the program that wrote it
  FileChecksums files;          ///< of the pictures beside it
};

/// With a checksum of its own.
nlohmann::ordered_json to_json(const ReferenceRecord& record);
/// Throws InputError that names the file, also where its checksum does not fit.
ReferenceRecord read_reference_record(const std::filesystem::path& file);

}  // namespace gibench
