/// URIs of glTF files: percent-encoded paths, and data inside the URI.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gibench {

/// "my%20picture.png" to "my picture.png" (RFC 3986, 2.1); a percent sign without two hexadecimal digits stays.
std::string percent_decoded(std::string_view uri);

/// The bytes of "data:TYPE;base64,…" or "data:TYPE,…" (RFC 2397); nothing for another URI, or where the base64 is broken.
std::optional<std::string> data_of_uri(std::string_view uri);
inline bool is_data_uri(std::string_view uri) { return uri.starts_with("data:"); }

/// Whether it names another machine or scheme ("https://…").
bool is_remote_uri(std::string_view uri);

}  // namespace gibench
