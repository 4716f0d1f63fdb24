#include "common/scene_io/gltf/extensions.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <vector>

namespace gibench {

namespace {

using nlohmann::json;

// Supported: what they say becomes part of the scene, or is named in the warning of a material.
constexpr std::array supported{
    "EXT_texture_webp",
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_specular",
    "KHR_materials_unlit",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
};

void add_unsupported(const std::string& name, std::set<std::string>& names) {
  if (!is_supported_gltf_extension(name)) names.insert(name);
}

}  // namespace

bool is_supported_gltf_extension(std::string_view name) {
  return std::find(supported.begin(), supported.end(), name) != supported.end();
}

std::set<std::string> unsupported_gltf_extensions(const json& document) {
  std::set<std::string> names;
  if (const auto used = document.find("extensionsUsed"); used != document.end() && used->is_array())
    for (const json& name : *used)
      if (name.is_string()) add_unsupported(name.get<std::string>(), names);
  // Without recursion, for documents of any depth; "extras" are of the program that wrote them.
  std::vector<const json*> open{&document};
  while (!open.empty()) {
    const json& value = *open.back();
    open.pop_back();
    if (value.is_array())
      for (const json& element : value)
        if (element.is_structured()) open.push_back(&element);
    if (!value.is_object()) continue;
    for (const auto& [key, member] : value.items()) {
      if (key == "extensions" && member.is_object())
        for (const auto& [name, extension] : member.items()) add_unsupported(name, names);
      if (key != "extras" && member.is_structured()) open.push_back(&member);
    }
  }
  return names;
}

}  // namespace gibench
