#include "common/scene_io/native/read_camera.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "common/core/error.h"
#include "common/core/names.h"
#include "common/scene_io/native/read_values.h"

namespace gibench {

namespace {

using nlohmann::json;

// Below this sine of the angle between view and up the picture has no upright.
constexpr double smallest_sine = 1e-6;

void read_view(const json& value, const JsonPlace& place, const SceneAssembler& assembler, Camera& camera) {
  const Vec3d position = read_vector(value["position"]), look_at = read_vector(value["look_at"]);
  if (position == look_at)
    throw InputError(place["look_at"].text(), "the camera looks at its own position", "move position or look_at");
  const Vec3d up = value.contains("up") ? read_direction(value["up"], place["up"]) : Vec3d(0.0, 1.0, 0.0);
  if (glm::length(glm::cross(glm::normalize(look_at - position), up)) < smallest_sine)
    throw InputError(place["up"].text(), "up is parallel to the view",
                     "give a direction across the view, such as [0, 0, 1] where the camera looks along y");
  assembler.place_camera(camera, position, look_at, place["position"].text());
  camera.up = Vec3(up);
}

std::string default_name(std::size_t index) { return index == 0 ? "main" : "camera-" + std::to_string(index + 1); }

}  // namespace

void read_cameras(const json& cameras, const JsonPlace& place, SceneAssembler& assembler) {
  std::vector<Camera>& read = assembler.scene().cameras;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const json& value = cameras[i];
    Camera camera;
    camera.name = value.value("name", default_name(i));
    if (std::any_of(read.begin(), read.end(), [&](const Camera& other) { return other.name == camera.name; }))
      throw InputError(place[i]["name"].text(), "there are two cameras named " + in_quotes(camera.name), "rename one of them");
    read_view(value, place[i], assembler, camera);
    camera.vertical_fov_degrees = value.value("vertical_fov_degrees", camera.vertical_fov_degrees);
    if (const auto resolution = value.find("resolution"); resolution != value.end())
      camera.width = (*resolution)[0].get<int>(), camera.height = (*resolution)[1].get<int>();
    read.push_back(camera);
  }
}

}  // namespace gibench
