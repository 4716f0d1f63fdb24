#include "common/scene_io/gltf/cameras.h"

#include <algorithm>
#include <cmath>

namespace gibench {

namespace {

constexpr int picture_height = 512;  // pixels of a model's camera, which has an aspect ratio only

}  // namespace

void add_gltf_camera(const GltfDocument& document, const GltfNode& node, UniqueNames& names, Model& model) {
  const auto index = node.value.whole_number_if("camera");
  if (!index) return;
  const GltfValue source = document.item("cameras", *index);
  const std::string given = node.value.text_or("name", source.text_or("name", ""));
  const std::string name = given.empty() ? "camera" : given;
  const auto leave_out = [&](const std::string& why) {
    model.warnings.push_back(document.file().filename().string() + ": camera " + in_quotes(name) + ": " + why +
                             ", it is left out");
  };
  if (source.at("type").text() != "perspective") return leave_out("only perspective cameras are read");
  const GltfValue lens = source.at("perspective");
  const double vertical = lens.at("yfov").number(), aspect = lens.number_or("aspectRatio", 1.0);
  const Vec3d view = node.to_file.linear * Vec3d(0.0, 0.0, -1.0), up = node.to_file.linear * Vec3d(0.0, 1.0, 0.0);
  if (!(vertical > 0.0 && vertical < pi_double && aspect > 0.0)) return leave_out("its angle or aspect ratio is out of range");
  // The sine of the angle between them, so that a flat camera is seen at any scale.
  if (!(glm::length(glm::cross(view, up)) > 1e-6 * glm::length(view) * glm::length(up)))
    return leave_out("its node's transform is flat");
  ModelCamera made;
  made.camera.name = names.take(name);
  made.camera.up = Vec3(glm::normalize(up));
  made.camera.vertical_fov_degrees = static_cast<float>(vertical * 180.0 / pi_double);
  made.camera.height = picture_height;
  made.camera.width = static_cast<int>(std::clamp(std::round(picture_height * aspect), 1.0, 16384.0));
  made.position = node.to_file.translation;
  made.look_at = made.position + glm::normalize(view);
  model.cameras.push_back(made);
}

}  // namespace gibench
