#include "common/scene_io/obj/mtl_text.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "common/core/names.h"
#include "common/scene_io/text/text_lines.h"

namespace gibench {

namespace {

using Keywords = std::set<std::string, std::less<>>;

/// Statements of transparency, refraction and ambient light, which is none of nature: they change nothing of an opaque surface.
const Keywords without_effect{"ka", "map_ka", "ni", "tf", "sharpness", "map_aat"};
/// Numbers of lobes that are not simulated; 0 is none.
const Keywords unused_numbers{"ps", "pc", "pcr", "aniso", "anisor"};
/// Pictures and files that are not used.
const Keywords unused_pictures{"map_ns", "map_d", "map_tr", "map_bump", "bump",   "norm",  "disp",
                               "decal",  "refl",  "map_pr", "map_pm",   "map_ps", "map_pc"};

/// The numbers at the beginning of a line.
std::vector<float> take_numbers(std::string_view& rest, std::size_t most) {
  std::vector<float> numbers;
  while (numbers.size() < most) {
    std::string_view after = rest;
    const auto number = to_number(take_word(after));
    if (!number) break;
    numbers.push_back(static_cast<float>(*number));
    rest = after;
  }
  return numbers;
}

class MtlParser {
 public:
  explicit MtlParser(std::string_view text) : lines_(text) {}

  MtlText run() {
    while (lines_.next()) {
      std::string_view rest = lines_.line();
      const std::string_view word = take_word(rest);
      keyword_ = std::string(word);
      const std::string keyword = lower_case(word);
      if (keyword == "newmtl") begin_material(rest);
      else if (mtl_.materials.empty()) note_before_materials();
      else if (!read_colour(keyword, rest) && !read_quantity(keyword, rest) && !read_picture(keyword, rest))
        read_unused(keyword, rest);
    }
    return std::move(mtl_);
  }

 private:
  MtlMaterial& material() { return mtl_.materials.back(); }
  void remark(const std::string& text) { material().remarks.push_back(text); }

  void begin_material(std::string_view name) {
    const auto same = [&](const MtlMaterial& other) { return other.name == name; };
    const auto before = std::find_if(mtl_.materials.begin(), mtl_.materials.end(), same);
    if (before != mtl_.materials.end()) {
      mtl_.warnings.push_back("material " + in_quotes(name) + " is defined twice, the last definition is used");
      mtl_.materials.erase(before);
    }
    mtl_.materials.emplace_back();
    material().name = name;
    has_opacity_ = false;
  }

  void note_before_materials() {
    if (mtl_.warnings.empty()) mtl_.warnings.emplace_back("statements before the first newmtl are left out");
  }

  bool read_colour(const std::string& keyword, std::string_view rest) {
    if (keyword == "kd") set_colour(rest, material().diffuse);
    else if (keyword == "ks") set_colour(rest, material().specular);
    else if (keyword == "ke") set_colour(rest, material().emission);
    else return false;
    return true;
  }

  /// Three numbers, or one for a grey.
  void set_colour(std::string_view rest, std::optional<Rgb>& colour) {
    const std::vector<float> n = take_numbers(rest, 4);
    if (n.size() == 1) colour = Rgb(n[0]);
    else if (n.size() >= 3) colour = Rgb(n[0], n[1], n[2]);
    else remark(excerpt(lines_.line()) + " is not read: a colour is one number or three");
  }

  std::optional<float> number(std::string_view rest) {
    const std::vector<float> n = take_numbers(rest, 1);
    if (!n.empty()) return n[0];
    remark(excerpt(lines_.line()) + " is not read: it has no number");
    return std::nullopt;
  }

  bool read_quantity(const std::string& keyword, std::string_view rest) {
    if (keyword == "ns") material().exponent = number(rest);
    else if (keyword == "pr") material().roughness = number(rest);
    else if (keyword == "pm") material().metal = number(rest).value_or(0.0F);
    else if (keyword == "illum") set_illumination(rest);
    else if (keyword == "d") set_opacity(rest);
    else if (keyword == "tr") set_transparency(rest);
    else return false;
    return true;
  }

  void set_illumination(std::string_view rest) {
    const auto model = number(rest);
    if (model && *model >= 0.0F && *model <= 10.0F) material().illumination = static_cast<int>(*model);
    else if (model) remark(excerpt(lines_.line()) + " is not read: illumination models are 0 to 10");
  }

  void set_opacity(std::string_view rest) {
    std::string_view after = rest;
    if (take_word(after) == "-halo") rest = after;
    material().opacity = number(rest).value_or(1.0F);
    has_opacity_ = true;
  }

  /// 1 − d; where both are stated d counts, because some programs write the opacity here as well.
  void set_transparency(std::string_view rest) {
    const auto transparency = number(rest);
    if (transparency && !has_opacity_) material().opacity = 1.0F - *transparency;
  }

  bool read_picture(const std::string& keyword, std::string_view rest) {
    if (keyword == "map_kd") material().diffuse_picture = picture(rest);
    else if (keyword == "map_ks") material().specular_picture = picture(rest);
    else if (keyword == "map_ke") material().emission_picture = picture(rest);
    else return false;
    return true;
  }

  /// Options, then the rest of the line is the file's name.
  MtlPicture picture(std::string_view rest) {
    MtlPicture picture;
    std::string left_out;
    while (rest.starts_with('-')) {
      std::string_view after = rest;
      const std::string option = lower_case(take_word(after));
      if (!read_option(option, after, picture)) {
        if (!skip_option(option, after)) break;  // a name that begins with a dash
        left_out += " " + option;
      }
      rest = after;
    }
    if (!left_out.empty()) remark(keyword_ + ": left out:" + left_out);
    picture.file = rest;
    return picture;
  }

  static bool read_option(const std::string& option, std::string_view& rest, MtlPicture& picture) {
    if (option == "-s" || option == "-o") {
      const std::vector<float> n = take_numbers(rest, 3);
      Vec2& target = option == "-s" ? picture.scale : picture.offset;
      if (!n.empty()) target.x = n[0];
      if (n.size() > 1) target.y = n[1];
    } else if (option == "-clamp") {
      picture.is_clamped = take_word(rest) == "on";
    } else if (option == "-blendu" || option == "-blendv" || option == "-cc" || option == "-type") {
      take_word(rest);  // filtering and the like: no matter for a mean
    } else if (option == "-texres") {
      take_numbers(rest, 1);
    } else {
      return false;
    }
    return true;
  }

  static bool skip_option(const std::string& option, std::string_view& rest) {
    if (option == "-imfchan") take_word(rest);
    else if (option == "-mm" || option == "-t" || option == "-bm" || option == "-boost") take_numbers(rest, 3);
    else return false;
    return true;
  }

  void read_unused(const std::string& keyword, std::string_view rest) {
    if (without_effect.contains(keyword)) return;
    if (unused_pictures.contains(keyword)) {
      remark(keyword_ + " is not used");
    } else if (unused_numbers.contains(keyword)) {
      const std::vector<float> n = take_numbers(rest, 3);
      if (std::any_of(n.begin(), n.end(), [](float x) { return x != 0.0F; })) remark(keyword_ + " is not simulated");
    } else {
      mtl_.unknown_statements.insert(excerpt(keyword_));
    }
  }

  TextLines lines_;
  MtlText mtl_;
  std::string keyword_;       // as it is written
  bool has_opacity_ = false;  // `d` was stated
};

}  // namespace

MtlText parse_mtl(std::string_view text) { return MtlParser(text).run(); }

}  // namespace gibench
