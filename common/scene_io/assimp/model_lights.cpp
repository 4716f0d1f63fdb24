#include "common/scene_io/assimp/model_lights.h"

#include <algorithm>
#include <cmath>

#include "common/core/names.h"
#include "common/scene_io/assimp/assimp_nodes.h"

namespace gibench {

namespace {

constexpr int picture_height = 512;  // pixels of a model's camera, which has an aspect ratio only

Rgb to_rgb(const aiColor3D& c) { return {std::max(0.0F, c.r), std::max(0.0F, c.g), std::max(0.0F, c.b)}; }

/// Intensity from Assimp's colour / (quadratic distance²); other fall-offs do not exist in nature.
Rgb intensity_of(const aiLight& light, std::vector<std::string>& warnings) {
  const Rgb colour = to_rgb(light.mColorDiffuse);
  const float quadratic = light.mAttenuationQuadratic;
  if (quadratic > 0.0F && light.mAttenuationLinear == 0.0F && light.mAttenuationConstant == 0.0F)
    return colour * (1.0F / quadratic);
  warnings.push_back("light " + in_quotes(light.mName.C_Str()) + ": its fall-off is taken as 1/distance²");
  return colour;
}

SpotLight spot_of(const aiLight& light, const Vec3& direction, std::vector<std::string>& warnings) {
  SpotLight spot;
  spot.direction = direction;
  spot.intensity = intensity_of(light, warnings);
  const float outer = std::clamp(0.5F * light.mAngleOuterCone, 0.0F, pi);  // Assimp has the whole cone
  spot.cos_outer = std::cos(outer);
  spot.cos_inner = std::cos(std::clamp(0.5F * light.mAngleInnerCone, 0.0F, outer));
  return spot;
}

/// Unit direction; zero for the zero vector.
Vec3d unit(const Vec3d& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : Vec3d(0.0);
}

}  // namespace

void read_model_lights(const aiScene& scene, Model& model) {
  for (unsigned i = 0; i < scene.mNumLights; ++i) {
    const aiLight& source = *scene.mLights[i];
    const Transform transform = transform_of(scene, source.mName);
    const Vec3d position = transform.apply(to_vec(source.mPosition));
    const Vec3d direction = unit(transform.linear * to_vec(source.mDirection));
    const bool has_direction = direction != Vec3d(0.0);
    if (source.mType == aiLightSource_POINT) {
      model.lights.push_back({PointLight{Vec3(0.0F), intensity_of(source, model.warnings)}, position});
    } else if (source.mType == aiLightSource_SPOT && has_direction) {
      model.lights.push_back({spot_of(source, Vec3(direction), model.warnings), position});
    } else if (source.mType == aiLightSource_DIRECTIONAL && has_direction) {
      model.lights.push_back({DirectionalLight{Vec3(direction), to_rgb(source.mColorDiffuse)}, position});
    } else {
      model.warnings.push_back("light " + in_quotes(source.mName.C_Str()) + ": ambient and area lights of models are left out");
    }
  }
}

void read_model_cameras(const aiScene& scene, Model& model) {
  for (unsigned i = 0; i < scene.mNumCameras; ++i) {
    const aiCamera& source = *scene.mCameras[i];
    const Transform transform = transform_of(scene, source.mName);
    const Vec3d view = unit(transform.linear * to_vec(source.mLookAt));
    const Vec3d up = unit(transform.linear * to_vec(source.mUp));
    const double aspect = source.mAspect > 0.0F ? static_cast<double>(source.mAspect) : 1.0;
    const double horizontal = source.mHorizontalFOV;
    const double vertical = 2.0 * std::atan(std::tan(0.5 * horizontal) / aspect);
    const double degrees = vertical * 180.0 / pi_double;
    if (!(degrees > 0.0 && degrees < 180.0) || glm::length(glm::cross(view, up)) < 1e-6) {
      model.warnings.push_back("camera " + in_quotes(source.mName.C_Str()) + ": orthographic and flat cameras are left out");
      continue;
    }
    ModelCamera made;
    made.camera.name = source.mName.C_Str();
    made.camera.up = Vec3(up);
    made.camera.vertical_fov_degrees = static_cast<float>(degrees);
    made.camera.height = picture_height;
    made.camera.width = static_cast<int>(std::clamp(std::round(picture_height * aspect), 1.0, 16384.0));
    made.position = transform.apply(to_vec(source.mPosition));
    made.look_at = made.position + view;
    model.cameras.push_back(made);
  }
}

}  // namespace gibench
