/// Reading and writing the fields of records; what is absent keeps its default.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "common/core/enum_names.h"
#include "common/core/error.h"

namespace gibench {

using Json = nlohmann::ordered_json;

/// The entry; null where it is absent or null.
inline const Json* field(const Json& object, const char* name) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found == object.end() || found->is_null() ? nullptr : &*found;
}

/// Throws nlohmann::json::exception for an entry of another type.
template <class T>
void read_field(const Json& object, const char* name, T& value) {
  if (const Json* entry = field(object, name)) value = entry->get<T>();
}
template <class T>
void read_field(const Json& object, const char* name, std::optional<T>& value) {
  if (const Json* entry = field(object, name)) value = entry->get<T>();
}

/// The entry; an empty object where it is absent.
inline const Json& object_field(const Json& object, const char* name) {
  static const Json nothing = Json::object();
  const Json* entry = field(object, name);
  return entry ? *entry : nothing;
}

template <class T>
void write_field(Json& object, const char* name, const std::optional<T>& value) {
  if (value) object[name] = *value;
}

/// The one of `all` with the name that stands at `place`. Throws InputError, the known ones listed, where there is none.
template <class All>
auto known_name(const All& all, const std::string& name, const std::string& place) {
  const auto found = find_named(all, name);
  if (!found) throw InputError(place, "unknown name '" + name + "'", "known: " + list_names(all));
  return *found;
}

/// The JSON in a file. Throws InputError that names the file where it cannot be read or is not JSON.
Json read_json_file(const std::filesystem::path& file);

/// read(json) of what a file holds; what it throws about a shape that does not fit becomes an InputError about `file`: it is not
/// `what` ("a run record").
template <class Read>
auto record_of(const Json& json, const std::filesystem::path& file, const std::string& what, const Read& read) {
  try {
    if (json.is_object()) return read(json);
  } catch (const nlohmann::json::exception&) {  // as below
  } catch (const InputError& unknown) {
    throw InputError(file.string(), "is not " + what + " (" + unknown.what() + ")", "run the study again");
  }
  throw InputError(file.string(), "is not " + what, "run the study again");
}

/// The same of a JSON file.
template <class Read>
auto read_record(const std::filesystem::path& file, const std::string& what, const Read& read) {
  return record_of(read_json_file(file), file, what, read);
}

}  // namespace gibench
