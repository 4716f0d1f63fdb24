#include "common/image/picture_format.h"

#include <algorithm>
#include <cctype>

namespace gibench {

namespace {

struct Mark {
  std::string_view bytes, format;
};

using namespace std::string_view_literals;

constexpr Mark marks[] = {
    {"\x76\x2f\x31\x01"sv, "openexr"},
    {"\x89PNG\r\n\x1a\n"sv, "png"},
    {"\xff\xd8\xff"sv, "jpeg"},
    {"#?"sv, "hdr"},
    {"PF"sv, "pnm"},
    {"Pf"sv, "pnm"},
    {"P1"sv, "pnm"},
    {"P2"sv, "pnm"},
    {"P3"sv, "pnm"},
    {"P4"sv, "pnm"},
    {"P5"sv, "pnm"},
    {"P6"sv, "pnm"},
    {"BM"sv, "bmp"},
    {"GIF8"sv, "gif"},
    {"DDS "sv, "dds"},
    {"8BPS"sv, "psd"},
    {"II*\0"sv, "tiff"},
    {"MM\0*"sv, "tiff"},
};

std::string lower_case_ending(const std::filesystem::path& name) {
  std::string ending = name.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

}  // namespace

std::string picture_format(std::string_view bytes, const std::filesystem::path& name) {
  for (const Mark& mark : marks)
    if (bytes.starts_with(mark.bytes)) return std::string(mark.format);
  if (bytes.starts_with("RIFF") && bytes.substr(std::min<std::size_t>(8, bytes.size())).starts_with("WEBP")) return "webp";
  return lower_case_ending(name) == ".tga" ? "targa" : "";
}

}  // namespace gibench
