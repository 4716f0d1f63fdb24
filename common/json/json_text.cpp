#include "common/json/json_text.h"

#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "common/core/error.h"
#include "common/core/names.h"
#include "common/json/json_place.h"

namespace gibench {

namespace {

using nlohmann::json;

/// Follows the parser and finds keys that appear twice in one object.
class DuplicateKeys {
 public:
  explicit DuplicateKeys(const std::string& file) : file_(file) {}

  void operator()(json::parse_event_t event, const json& parsed) {
    switch (event) {
      case json::parse_event_t::object_start:
      case json::parse_event_t::array_start:
        begin_value();
        levels_.push_back({event == json::parse_event_t::object_start, {}, {}, 0});
        break;
      case json::parse_event_t::key: add_key(parsed.get_ref<const std::string&>()); break;
      case json::parse_event_t::object_end:
      case json::parse_event_t::array_end: levels_.pop_back(); break;
      case json::parse_event_t::value: begin_value(); break;
    }
  }

 private:
  struct Level {
    bool is_object;
    std::set<std::string, std::less<>> keys;
    std::string key;
    std::size_t elements;  // begun so far, of a list
  };

  void begin_value() {
    if (!levels_.empty() && !levels_.back().is_object) ++levels_.back().elements;
  }

  void add_key(const std::string& key) {
    Level& level = levels_.back();
    if (!level.keys.insert(key).second)
      throw InputError(place().text(), "the key " + in_quotes(key) + " appears twice", "rename or remove one of them");
    level.key = key;
  }

  JsonPlace place() const {
    JsonPlace place(file_);
    for (std::size_t i = 0; i + 1 < levels_.size(); ++i)
      place = levels_[i].is_object ? place[levels_[i].key] : place[levels_[i].elements - 1];
    return place;
  }

  std::string file_;
  std::vector<Level> levels_;
};

/// What nlohmann::json says without its own code in brackets, and without the word before the line number.
std::string without_prefix(std::string text) {
  if (const auto bracket = text.find("] "); bracket != std::string::npos) text.erase(0, bracket + 2);
  if (const std::string prefix = "parse error at "; text.starts_with(prefix)) text.erase(0, prefix.size());
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return text;
}

}  // namespace

json parse_json(const std::string& text, const std::string& file) {
  DuplicateKeys duplicates(file);
  const auto callback = [&](int, json::parse_event_t event, const json& parsed) {
    duplicates(event, parsed);
    return true;
  };
  try {
    return json::parse(text, callback);
  } catch (const json::parse_error& error) {
    throw InputError(file, without_prefix(error.what()),
                     "correct the JSON there (it has no comments, trailing commas, NaN or Infinity)");
  } catch (const json::out_of_range& error) {
    throw InputError(file, without_prefix(error.what()), "write a number below 1.8e308");
  }
}

}  // namespace gibench
