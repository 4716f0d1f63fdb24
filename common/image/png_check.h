/// The test whether a PNG file is complete, before libpng reads it: libpng reads on past a missing end and writes to stderr.
#pragma once

#include <string>
#include <string_view>

namespace gibench {

/// Walks the chunks of a PNG's bytes (PNG specification, 5.3 and 5.4) and checks their lengths and checksums up to
/// IEND. Returns what is wrong, or nothing; also nothing for bytes that do not begin as a PNG.
std::string png_damage(std::string_view bytes);

}  // namespace gibench
