/// A place in a JSON file, as messages name it: "box.scene.json: $.objects[2].faces[4][1]".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gibench {

/// A file and the path to a value in it; `[]` goes one step down.
class JsonPlace {
 public:
  /// The top of the file (or of whatever `file` names).
  explicit JsonPlace(std::string_view file) : text_(std::string(file) + ": $") {}

  /// The value of a key; a key that is not a plain word is quoted: $.materials["old wood"].
  JsonPlace operator[](std::string_view key) const;
  /// An element of a list, counted from 0.
  JsonPlace operator[](std::size_t index) const;

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace gibench
