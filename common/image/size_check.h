/// The test whether a picture's file is long enough for the size that its header states, before memory is taken for it.
#pragma once

#include <string>
#include <string_view>

namespace gibench {

/// What is wrong, or nothing. `format`: as picture_format() says; PNG, HDR, PNM and JPEG are checked here, each by the
/// fewest bytes in which the format can write so many pixels.
std::string size_damage(std::string_view bytes, std::string_view format);

}  // namespace gibench
