#include "bench/record/json_fields.h"

#include <fstream>

namespace gibench {

Json read_json_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string(), "cannot be read", "check that it exists and may be read");
  try {
    return Json::parse(in);
  } catch (const nlohmann::json::exception&) {
    throw InputError(file.string(), "is not valid JSON", "it is damaged or was cut short: run the study again");
  }
}

}  // namespace gibench
