#include "common/scene_io/gltf/gltf_value.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "common/core/error.h"
#include "common/core/names.h"

namespace gibench {

void GltfSource::refuse(const std::string& path, const std::string& problem, const std::string& remedy) const {
  throw InputError(
      place, "the model file " + in_quotes(file.string()) + " cannot be read: " + (path.empty() ? "it" : path) + " " + problem,
      remedy);
}

bool GltfValue::has(const char* key) const { return value_->is_object() && value_->contains(key); }

std::optional<GltfValue> GltfValue::find(const char* key) const {
  if (!value_->is_object()) refuse("is not an object");
  const auto found = value_->find(key);
  if (found == value_->end()) return std::nullopt;
  return GltfValue(*found, *source_, path_.empty() ? std::string(key) : path_ + "." + key);
}

GltfValue GltfValue::at(const char* key) const {
  const auto found = find(key);
  if (!found) refuse("has no " + in_quotes(key));
  return *found;
}

GltfValue GltfValue::object(const char* key) const {
  static const nlohmann::json empty = nlohmann::json::object();
  const auto found = find(key);
  return found ? *found : GltfValue(empty, *source_, path_ + "." + key);
}

std::optional<GltfValue> GltfValue::extension(const char* name) const {
  const auto all = find("extensions");
  return all ? all->find(name) : std::nullopt;
}

std::size_t GltfValue::size() const {
  if (!value_->is_array()) refuse("is not a list");
  return value_->size();
}

GltfValue GltfValue::at(std::size_t index) const {
  if (index >= size()) refuse("has no element " + std::to_string(index) + ", only " + std::to_string(size()));
  return {(*value_)[index], *source_, path_ + "[" + std::to_string(index) + "]"};
}

double GltfValue::number() const {
  if (!value_->is_number()) refuse("is not a number");
  return value_->get<double>();
}

std::size_t GltfValue::whole_number() const {
  const double value = number();  // some programs write 3.0
  if (!(value >= 0.0 && value <= 0x1p53 && value == std::floor(value))) refuse("is not a whole number from 0");
  return static_cast<std::size_t>(value);
}

std::string GltfValue::text() const {
  if (!value_->is_string()) refuse("is not a text");
  return value_->get<std::string>();
}

bool GltfValue::flag() const {
  if (!value_->is_boolean()) refuse("is neither true nor false");
  return value_->get<bool>();
}

double GltfValue::number_or(const char* key, double fallback) const {
  const auto found = find(key);
  return found ? found->number() : fallback;
}

std::size_t GltfValue::whole_number_or(const char* key, std::size_t fallback) const {
  return whole_number_if(key).value_or(fallback);
}

std::optional<std::size_t> GltfValue::whole_number_if(const char* key) const {
  const auto found = find(key);
  return found ? std::optional(found->whole_number()) : std::nullopt;
}

std::string GltfValue::text_or(const char* key, std::string_view fallback) const {
  const auto found = find(key);
  return found ? found->text() : std::string(fallback);
}

bool GltfValue::flag_or(const char* key, bool fallback) const {
  const auto found = find(key);
  return found ? found->flag() : fallback;
}

}  // namespace gibench
