/// Values of a glTF document with the way to each of them.
#pragma once

#include <array>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace gibench {

/// The file that a document stands in, and what asked for it.
struct GltfSource {
  std::filesystem::path file;
  std::string place;  ///< as InputError names it: the file, or the JSON path of a scene that names the file

  /// Throws InputError: the file cannot be read because of `problem` at `path`.
  [[noreturn]] void refuse(const std::string& path, const std::string& problem,
                           const std::string& remedy = "correct the file or export it again") const;
};

/// A value, its file and its path. Whatever is missing or not of the type that glTF gives it is refused by its path
/// (InputError). Refers to the document's JSON and source, which must outlive it.
class GltfValue {
 public:
  GltfValue(const nlohmann::json& value, const GltfSource& source, std::string path)
      : value_(&value), source_(&source), path_(std::move(path)) {}

  const nlohmann::json& json() const { return *value_; }
  const std::string& path() const { return path_; }
  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy = "correct the file or export it again") const {
    source_->refuse(path_, problem, remedy);
  }

  bool has(const char* key) const;
  /// A member that may be missing.
  std::optional<GltfValue> find(const char* key) const;
  /// A member that must be there.
  GltfValue at(const char* key) const;
  /// A member that is an object, empty where it is missing.
  GltfValue object(const char* key) const;
  /// The value of an extension of this object.
  std::optional<GltfValue> extension(const char* name) const;

  std::size_t size() const;  ///< of a list
  GltfValue at(std::size_t index) const;

  double number() const;
  std::size_t whole_number() const;
  std::string text() const;
  bool flag() const;
  template <std::size_t count>
  std::array<double, count> numbers() const {
    std::array<double, count> result{};
    if (size() != count) refuse("is not a list of " + std::to_string(count) + " numbers");
    for (std::size_t i = 0; i < count; ++i) result[i] = at(i).number();
    return result;
  }

  double number_or(const char* key, double fallback) const;
  std::size_t whole_number_or(const char* key, std::size_t fallback) const;
  std::optional<std::size_t> whole_number_if(const char* key) const;
  std::string text_or(const char* key, std::string_view fallback) const;
  bool flag_or(const char* key, bool fallback) const;
  template <std::size_t count>
  std::array<double, count> numbers_or(const char* key, const std::array<double, count>& fallback) const {
    const auto found = find(key);
    return found ? found->numbers<count>() : fallback;
  }

 private:
  const nlohmann::json* value_;
  const GltfSource* source_;
  std::string path_;
};

}  // namespace gibench
