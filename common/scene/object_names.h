/// Names of objects, which also stand for the parts that a model file was split into.
#pragma once

#include <string>

namespace gibench {

/// Whether `name` is that of the object `object`, or of one that was split by its materials into "name/…".
inline bool stands_for(const std::string& name, const std::string& object) {
  return object.starts_with(name) && (object.size() == name.size() || object[name.size()] == '/');
}

}  // namespace gibench
