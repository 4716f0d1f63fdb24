#include "common/scene_io/native/read_values.h"

#include <nlohmann/json.hpp>

#include "common/core/error.h"

namespace gibench {

using nlohmann::json;

Vec3d read_vector(const json& value) { return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()}; }

Vec3d vector_or(const json& object, const char* key, const Vec3d& fallback) {
  const auto found = object.find(key);
  return found != object.end() ? read_vector(*found) : fallback;
}

Vec3d read_triple(const json& value) { return value.is_number() ? Vec3d(value.get<double>()) : read_vector(value); }

Rgb read_rgb(const json& value, const JsonPlace& place) {
  const Vec3d triple = read_triple(value);
  const Rgb rgb(static_cast<float>(triple.x), static_cast<float>(triple.y), static_cast<float>(triple.z));
  if (!is_finite(rgb))
    throw InputError(place.text(), "the value is too large for single precision", "write a number below 3.4e38");
  return rgb;
}

Vec3d read_direction(const json& value, const JsonPlace& place) {
  const Vec3d vector = read_vector(value);
  const double largest = std::max({std::fabs(vector.x), std::fabs(vector.y), std::fabs(vector.z)});
  if (largest == 0.0) throw InputError(place.text(), "the direction is zero", "give a direction of any length above 0");
  return glm::normalize(vector / largest);
}

Exposure read_exposure(const json& exposure, const JsonPlace& place) {
  Exposure read;
  read.value = exposure.value("value", read.value);
  read.start = exposure.value("start", read.start);
  read.stop = exposure.value("stop", read.stop);
  if (!(read.start < read.stop))
    throw InputError(place.text(), "start is not below stop", "give stops with start below stop (defaults -2 and 4)");
  return read;
}

}  // namespace gibench
