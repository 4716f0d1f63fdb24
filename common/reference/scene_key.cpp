#include "common/reference/scene_key.h"

#include "common/core/hash.h"

namespace gibench {

namespace {

/// Counts up when the files or what a reference means change: older ones are then made again, when asked for.
constexpr std::uint32_t store_version = 1;

void add(KeyBuilder& key, const Rgb& c) { key.add(c.r).add(c.g).add(c.b); }
void add(KeyBuilder& key, const Vec3& v) { key.add(v.x).add(v.y).add(v.z); }

void add(KeyBuilder& key, const Material& material) {
  key.add(static_cast<int>(material.bsdf));
  for (const Rgb* colour : {&material.diffuse, &material.specular, &material.f0, &material.reflectance, &material.emission})
    add(key, *colour);
  key.add(material.exponent).add(material.roughness);
}

void add(KeyBuilder& key, const Object& object) {
  key.add(object.material).add(static_cast<int>(object.two_sided));
  key.add(object.vertex_begin).add(object.vertex_end).add(object.face_begin).add(object.face_end);
  key.add(object.triangle_begin).add(object.triangle_end);
}

struct LightAdder {
  KeyBuilder& key;

  void operator()(const PointLight& light) const {
    add(key, light.position);
    add(key, light.intensity);
  }
  void operator()(const SpotLight& light) const {
    add(key, light.position);
    add(key, light.direction);
    add(key, light.intensity);
    key.add(light.cos_inner).add(light.cos_outer);
  }
  void operator()(const DirectionalLight& light) const {
    add(key, light.direction);
    add(key, light.irradiance);
  }
  void operator()(const EnvironmentLight& light) const {
    add(key, light.radiance);
    key.add(light.rotate_y_degrees).add(static_cast<int>(light.image != nullptr));
    if (light.image == nullptr) return;
    key.add(light.image->width).add(light.image->height);
    key.add(std::span<const Rgb>(light.image->pixels));
  }
};

}  // namespace

std::string scene_key(const Scene& scene) {
  static_assert(sizeof(Vec3) == 3 * sizeof(float) && sizeof(Rgb) == 3 * sizeof(float), "no padding is hashed");
  KeyBuilder key;
  key.add(std::span<const Vec3>(scene.vertices));
  key.add(std::span<const Face>(scene.faces));
  key.add(std::span<const Triangle>(scene.triangles));
  key.add(scene.objects.size());
  for (const Object& object : scene.objects) add(key, object);
  key.add(scene.materials.size());
  for (const Material& material : scene.materials) add(key, material);
  key.add(scene.lights.size());
  for (const Light& light : scene.lights) {
    key.add(light.index());
    std::visit(LightAdder{key}, light);
  }
  return key.hex();
}

std::string reference_key(const Scene& scene, const ReferenceQuestion& question) {
  KeyBuilder key;
  key.add(store_version).add(scene_key(scene));
  key.add(question.path_class).add(question.seed).add(question.surface_samples).add(question.pixel_samples);
  key.add(question.surface_domain);
  if (question.surface_domain == "all") key.add(std::string("without sealed sides"));  // it once meant what `whole` does
  key.add(static_cast<int>(question.camera.has_value()));
  if (question.camera) {
    add(key, question.camera->position);
    add(key, question.camera->look_at);
    add(key, question.camera->up);
    key.add(question.camera->vertical_fov_degrees).add(question.camera->width).add(question.camera->height);
  }
  return key.hex();
}

}  // namespace gibench
