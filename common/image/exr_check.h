/// The test whether an EXR file can hold what its headers ask for: OpenEXR allocates it before it looks.
#pragma once

#include <string>
#include <string_view>

namespace gibench {

/// What is wrong with an EXR's headers (OpenEXR File Layout, 2.0), or nothing: an attribute that does not fit into the file,
/// more pixels or chunks than its bytes can stand for. Nothing for what is not checked here, which OpenEXR then refuses.
std::string exr_damage(std::string_view bytes);

/// Whether the colours stand as luminance and chroma (channels Y, RY, BY) in every part that has any.
bool is_luminance_chroma(std::string_view bytes);

}  // namespace gibench
