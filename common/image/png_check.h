/// The chunks of a PNG, and the test whether they are complete, before libpng reads it: libpng reads on past a missing end and
/// writes to stderr.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace gibench {

/// Walks the chunks of a PNG's bytes (PNG specification, 5.3 and 5.4) and checks their lengths and checksums up to
/// IEND. Returns what is wrong, or nothing; also nothing for bytes that do not begin as a PNG.
std::string png_damage(std::string_view bytes);

/// Calls visit(type, data) for the chunks in their order until it returns false or a chunk is not whole. Checksums are not looked
/// at. No chunk where the bytes do not begin as a PNG.
void for_each_png_chunk(std::string_view bytes, const std::function<bool(std::string_view type, std::string_view data)>& visit);

}  // namespace gibench
