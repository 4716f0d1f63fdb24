#include "common/scene_io/text/model_place.h"

#include "common/core/error.h"
#include "common/core/names.h"

namespace gibench {

ModelPlace::ModelPlace(const std::filesystem::path& file, std::string place)
    : shown_("the model file " + in_quotes(file.string())), place_(std::move(place)) {}

void ModelPlace::refuse(const std::string& problem, const std::string& remedy) const {
  throw InputError(place_, shown_ + " " + problem, remedy);
}

void ModelPlace::refuse_line(std::size_t line, const std::string& problem) const {
  throw InputError(place_, shown_ + ", line " + std::to_string(line) + ": " + problem,
                   "correct the line or export the file again");
}

void ModelPlace::refuse_cut_short(const std::string& how) const {
  throw InputError(place_, shown_ + " is cut short: " + how, "copy or export the whole file again");
}

std::string_view without_byte_order_mark(std::string_view text, const ModelPlace& place) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    place.refuse("is written in UTF-16", "save it as plain text or UTF-8");
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

}  // namespace gibench
