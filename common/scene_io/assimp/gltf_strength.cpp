#include "common/scene_io/assimp/gltf_strength.h"

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "common/core/atomic_file.h"

namespace gibench {

namespace {

/// The JSON of a .gltf, or of the first chunk of a .glb: header of 12 bytes, chunk length, chunk type, chunk.
std::string_view json_part(const std::string& bytes) {
  constexpr std::size_t chunk_at = 20;
  if (!bytes.starts_with("glTF") || bytes.size() < chunk_at) return bytes;
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, sizeof length);
  return std::string_view(bytes).substr(chunk_at, length);
}

}  // namespace

std::vector<float> gltf_emissive_strengths(const std::filesystem::path& file) {
  using nlohmann::json;
  const std::string bytes = read_file(file);
  const json document = json::parse(json_part(bytes), nullptr, /*allow_exceptions=*/false);
  std::vector<float> strengths;
  if (!document.is_object() || !document.contains("materials")) return strengths;
  const json::json_pointer strength("/extensions/KHR_materials_emissive_strength/emissiveStrength");
  for (const json& material : document["materials"]) strengths.push_back(material.value(strength, 1.0F));
  return strengths;
}

}  // namespace gibench
