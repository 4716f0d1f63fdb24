/// A scene in memory: geometry in flat arrays, materials, lights, cameras and edits, all checked on loading.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/core/rgb.h"
#include "common/core/vec.h"
#include "common/image/exposure.h"

namespace gibench {

/// The kinds of BRDF.
enum class Bsdf { diffuse, phong, ggx, mirror };

/// What the front of a surface does to light; the fields that `bsdf` does not use stay zero.
struct Material {
  std::string name;
  Bsdf bsdf = Bsdf::diffuse;
  Rgb diffuse;             ///< reflectance of the diffuse part, [0, 1]; the whole albedo of a `diffuse` material
  Rgb specular;            ///< phong: ks of the normalised lobe, [0, 1]
  float exponent = 0.0F;   ///< phong: n ≥ 0
  float roughness = 0.0F;  ///< ggx: alpha = roughness², roughness in [0, 1]
  Rgb f0;                  ///< ggx: Schlick reflectance at normal incidence, [0, 1]
  Rgb reflectance;         ///< mirror: [0, 1]
  Rgb emission;            ///< radiance leaving the front, W/(m² sr)
};

/// Three or four corners, counter-clockwise seen from the front; a triangle repeats its third corner.
struct Face {
  std::array<std::uint32_t, 4> corners{};
  bool is_quad() const { return corners[3] != corners[2]; }
};

/// Three corners, counter-clockwise seen from the front: what rays meet.
struct Triangle {
  std::array<std::uint32_t, 3> corners{};
};

/// A run of faces with one material. Faces and triangles of an object are contiguous.
struct Object {
  std::string name;
  std::uint32_t material = 0;
  bool two_sided = false;  ///< reflects and emits on its back as on its front
  std::string group;       ///< reconstruction group (Lehtinen 2007, 6.1); empty = the scene's common one
  std::uint32_t vertex_begin = 0, vertex_end = 0;
  std::uint32_t face_begin = 0, face_end = 0;
  std::uint32_t triangle_begin = 0, triangle_end = 0;
};

/// Light from one point, the same in all directions.
struct PointLight {
  Vec3 position;  ///< relative to Scene::origin
  Rgb intensity;  ///< W/sr
};
/// Light from one point into a cone.
struct SpotLight {
  Vec3 position;
  Vec3 direction;                            ///< unit; the way the light travels
  Rgb intensity;                             ///< W/sr inside the inner cone
  float cos_inner = 1.0F, cos_outer = 1.0F;  ///< smoothstep in the cosine between them
};
/// Light from infinitely far, in one direction.
struct DirectionalLight {
  Vec3 direction;  ///< unit; the way the light travels
  Rgb irradiance;  ///< W/m² on a surface that faces the light
};
/// Light-probe pixels in latitude-longitude layout: row 0 is up (+y), the middle column looks along -z.
struct EnvironmentImage {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;  ///< row-major from the top, W/(m² sr)
};
/// Light from infinitely far, from every direction.
struct EnvironmentLight {
  Rgb radiance{1.0F};                             ///< constant radiance, or the factor on the image
  std::shared_ptr<const EnvironmentImage> image;  ///< empty: constant
  float rotate_y_degrees = 0.0F;
};
using Light = std::variant<PointLight, SpotLight, DirectionalLight, EnvironmentLight>;

/// A pinhole camera.
struct Camera {
  std::string name;
  Vec3 position, look_at, up;  ///< positions relative to Scene::origin
  float vertical_fov_degrees = 40.0F;
  int width = 512, height = 512;  ///< pixels
};

// Edits are made one after the other, each on top of those before it. An object's name also stands for the
// objects "name/…" that a model file was split into by its materials.

/// Turned about the centre of the object's bounding box (about x, then y, then z), then moved.
struct MoveEdit {
  std::string object;
  Vec3d translate{0};  ///< metres
  Vec3d rotate_degrees{0};
};
/// Another material under the same name.
struct MaterialEdit {
  std::string material;
  Material after;  ///< whole, with what earlier edits changed
};
/// A light with other values.
struct LightEdit {
  std::size_t light;
  Light after;  ///< whole, with what earlier edits changed
};
/// Other geometry for an object, from a model file.
struct DeformEdit {
  std::string object;
  std::filesystem::path file;
};
using SceneEdit = std::variant<MoveEdit, MaterialEdit, LightEdit, DeformEdit>;

/// Everything that a scene file says, checked, and its triangles.
struct Scene {
  std::string name;
  std::filesystem::path file;  ///< where it was read from; empty for a scene made in memory
  Vec3d origin{0};             ///< what was taken off every position on reading; add it to get file coordinates
  std::vector<Vec3> vertices;
  std::vector<Face> faces;
  std::vector<Object> objects;
  std::vector<Material> materials;
  std::vector<Light> lights;
  std::vector<Camera> cameras;
  std::vector<SceneEdit> edits;
  std::optional<Exposure> exposure;
  std::vector<std::string> warnings;  ///< what was read but is not used, a line each

  // The tessellation, filled by tessellate(): a quad gives two triangles (0,1,2) and (0,2,3), or the other
  // diagonal where the quad is concave; a triangle gives itself.
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> triangle_face;    ///< face of every triangle
  std::vector<std::uint32_t> triangle_object;  ///< object of every triangle

  const Material& material_of_object(std::uint32_t object) const { return materials[objects[object].material]; }
  const Material& material_of_triangle(std::uint32_t triangle) const { return material_of_object(triangle_object[triangle]); }
};

/// Whether `name` is an object of the scene, or one that was split by its materials into "name/…".
bool has_object(const Scene& scene, const std::string& name);

/// The lights of a scene, apart from its geometry: what a method is lit with, again and again.
struct Lighting {
  std::vector<Light> lights;
  std::vector<Rgb> emission;  ///< one for each material, W/(m² sr)

  static Lighting of(const Scene& scene);
};

}  // namespace gibench
