#include "common/image/png_colours.h"

#include <fmt/format.h>

#include "common/image/byte_reader.h"
#include "common/image/png_check.h"

namespace gibench {

namespace {

constexpr float unit = 1e-5F;  // of gAMA and cHRM

void take_gamma(std::string_view data, PngColours& colours) {
  const std::uint32_t gamma = big_endian(data, 0);
  if (data.size() == 4 && gamma > 0) colours.exponent = 1.0F / (unit * static_cast<float>(gamma));
  else colours.remarks.emplace_back("its chunk gAMA states no gamma and is not used");
}

void take_chromaticities(std::string_view data, PngColours& colours) {
  if (data.size() != 32) return colours.remarks.emplace_back("its chunk cHRM states no chromaticities and is not used"), void();
  Chromaticities& c = colours.chromaticities.emplace();
  for (std::size_t i = 0; i < c.size(); ++i)  // the file has white first
    c[(i + 6) % 8] = unit * static_cast<float>(big_endian(data, 4 * i));
}

}  // namespace

PngColours colours_of_png(std::string_view bytes) {
  PngColours colours;
  bool is_srgb = false;
  for_each_png_chunk(bytes, [&](std::string_view type, std::string_view data) {
    if (type == "gAMA") take_gamma(data, colours);
    else if (type == "cHRM") take_chromaticities(data, colours);
    else if (type == "sRGB") is_srgb = true;
    else if (type == "iCCP") colours.profile_name = data.substr(0, data.find('\0'));
    else if (type == "cICP" && !data.starts_with("\x01\x0d"))  // the primaries and the curve of sRGB
      colours.remarks.emplace_back("the colour space of its chunk cICP is not applied");
    return type != "IDAT";
  });
  if (is_srgb) colours.exponent.reset(), colours.chromaticities.reset();
  return colours;
}

}  // namespace gibench
