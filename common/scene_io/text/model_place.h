/// The place of a model file in messages, and the mark that its text may begin with.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace gibench {

/// Refuses a model file: InputError at the place that names it, a scene file's JSON path or the file itself.
class ModelPlace {
 public:
  ModelPlace(const std::filesystem::path& file, std::string place);

  /// The same place, of a file that the model names.
  ModelPlace of_file(const std::filesystem::path& file) const { return {file, place_}; }

  /// problem: goes on "the model file NAME …".
  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const;
  /// problem: goes on "the model file NAME, line LINE: …".
  [[noreturn]] void refuse_line(std::size_t line, const std::string& problem) const;
  /// how: goes on "the model file NAME is cut short: …".
  [[noreturn]] void refuse_cut_short(const std::string& how) const;

 private:
  std::string shown_, place_;
};

/// A text after a byte order mark of UTF-8. Refuses UTF-16.
std::string_view without_byte_order_mark(std::string_view text, const ModelPlace& place);

}  // namespace gibench
