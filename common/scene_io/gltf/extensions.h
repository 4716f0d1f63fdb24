/// The extensions of glTF 2.0 that are read, and the parts of a document that are not.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <string_view>

namespace gibench {

bool is_supported_gltf_extension(std::string_view name);

/// The names of extensions that the document uses anywhere or lists as used, and that are not supported.
std::set<std::string> unsupported_gltf_extensions(const nlohmann::json& document);

}  // namespace gibench
