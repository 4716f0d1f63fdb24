#include "common/scene/made_scenes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <utility>

#include "common/core/random.h"
#include "common/scene/light_kinds.h"
#include "common/scene/tessellate.h"

namespace gibench::made {

namespace {

/// Corners of a box by bit: 1 is +x, 2 is +y, 4 is +z; faces counter-clockwise from outside.
constexpr std::array<std::array<std::uint32_t, 4>, 6> outward_faces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

std::vector<Vec3> box_corners(const Vec3& low, const Vec3& high) {
  std::vector<Vec3> corners;
  for (unsigned i = 0; i < 8; ++i)
    corners.push_back({(i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y, (i & 4U) != 0 ? high.z : low.z});
  return corners;
}

std::array<std::uint32_t, 4> reversed(const std::array<std::uint32_t, 4>& face) { return {face[0], face[3], face[2], face[1]}; }

glm::mat3 rotation_matrix(const Vec3& axis, float degrees) {
  return glm::mat3(glm::rotate(glm::mat4(1.0F), glm::radians(degrees), axis));
}

struct Move {
  glm::mat3 rotation;
  float scale;
  Vec3 translation;

  Vec3 point(const Vec3& p) const { return rotation * (scale * p) + translation; }
  void light(Light& light) const {
    const LightParts<Light> parts = parts_of(light);
    if (parts.position != nullptr) *parts.position = point(*parts.position), *parts.strength *= scale * scale;
    if (parts.direction != nullptr) *parts.direction = rotation * *parts.direction;
  }
};

}  // namespace

std::uint32_t SceneBuilder::material(Material material) {
  scene_.materials.push_back(std::move(material));
  return static_cast<std::uint32_t>(scene_.materials.size() - 1);
}

std::uint32_t SceneBuilder::diffuse(const std::string& name, const Rgb& albedo, const Rgb& emission) {
  Material made;
  made.name = name;
  made.diffuse = albedo;
  made.emission = emission;
  return material(made);
}

SceneBuilder& SceneBuilder::object(const std::string& name, std::uint32_t material, const std::vector<Vec3>& vertices,
                                   const std::vector<std::array<std::uint32_t, 4>>& faces, bool two_sided) {
  Object made;
  made.name = name;
  made.material = material;
  made.two_sided = two_sided;
  made.vertex_begin = static_cast<std::uint32_t>(scene_.vertices.size());
  made.face_begin = static_cast<std::uint32_t>(scene_.faces.size());
  scene_.vertices.insert(scene_.vertices.end(), vertices.begin(), vertices.end());
  for (std::array<std::uint32_t, 4> corners : faces) {
    for (std::uint32_t& corner : corners) corner += made.vertex_begin;
    scene_.faces.push_back({corners});
  }
  made.vertex_end = static_cast<std::uint32_t>(scene_.vertices.size());
  made.face_end = static_cast<std::uint32_t>(scene_.faces.size());
  scene_.objects.push_back(made);
  return *this;
}

SceneBuilder& SceneBuilder::quad(const std::string& name, std::uint32_t material, const std::array<Vec3, 4>& corners,
                                 bool two_sided) {
  return object(name, material, {corners.begin(), corners.end()}, {{0, 1, 2, 3}}, two_sided);
}

SceneBuilder& SceneBuilder::room(const std::string& name, std::uint32_t material, const Vec3& low, const Vec3& high) {
  std::vector<std::array<std::uint32_t, 4>> faces;
  for (const auto& face : outward_faces) faces.push_back(reversed(face));
  return object(name, material, box_corners(low, high), faces);
}

SceneBuilder& SceneBuilder::block(const std::string& name, std::uint32_t material, const Vec3& low, const Vec3& high,
                                  float turn_degrees) {
  std::vector<Vec3> corners = box_corners(low, high);
  const Vec3 centre = 0.5F * (low + high);
  const glm::mat3 rotation = rotation_matrix({0.0F, 1.0F, 0.0F}, turn_degrees);
  for (Vec3& corner : corners) corner = centre + rotation * (corner - centre);
  return object(name, material, corners, {outward_faces.begin(), outward_faces.end()});
}

SceneBuilder& SceneBuilder::light(const Light& light) {
  scene_.lights.push_back(light);
  return *this;
}

SceneBuilder& SceneBuilder::camera(const Camera& camera) {
  scene_.cameras.push_back(camera);
  return *this;
}

Scene SceneBuilder::build(const std::string& name) const {
  Scene scene = scene_;
  scene.name = name;
  tessellate(scene);
  return scene;
}

Scene box_scene(const BoxOptions& options) {
  SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", options.floor_albedo);
  const std::uint32_t left = builder.diffuse("left", options.left_albedo);
  const std::uint32_t right = builder.diffuse("right", options.right_albedo);
  builder.quad("floor", white, {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}})
      .quad("ceiling", white, {{{0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}}})
      .quad("back", white, {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}})
      .quad("front", white, {{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}})
      .quad("left", left, {{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}})
      .quad("right", right, {{{1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0}}});
  if (options.blocks)
    builder.block("tall", white, {0.15F, 0.0F, 0.15F}, {0.45F, 0.6F, 0.45F}, 17.0F)
        .block("short", white, {0.55F, 0.0F, 0.5F}, {0.85F, 0.3F, 0.8F}, -17.0F);
  if (!is_black(options.lamp_emission)) {
    const std::uint32_t lamp = builder.diffuse("lamp", Rgb(0.0F), options.lamp_emission);
    builder.quad("lamp", lamp,
                 {{{0.375F, 0.99F, 0.375F}, {0.625F, 0.99F, 0.375F}, {0.625F, 0.99F, 0.625F}, {0.375F, 0.99F, 0.625F}}});
  }
  for (const Light& light : options.lights) builder.light(light);
  builder.camera({"main", {0.5F, 0.5F, 0.95F}, {0.5F, 0.45F, 0.0F}, {0.0F, 1.0F, 0.0F}, 70.0F, 32, 32});
  return builder.build("box");
}

Scene transformed(Scene scene, float scale, const Vec3& rotation_axis, float degrees, const Vec3& translation) {
  const Move move{rotation_matrix(glm::normalize(rotation_axis), degrees), scale, translation};
  for (Vec3& vertex : scene.vertices) vertex = move.point(vertex);
  for (Light& light : scene.lights) move.light(light);
  for (Camera& camera : scene.cameras) {
    camera.position = move.point(camera.position);
    camera.look_at = move.point(camera.look_at);
    camera.up = move.rotation * camera.up;
  }
  tessellate(scene);
  return scene;
}

Scene random_triangles(std::size_t count, float extent, float size, std::uint64_t seed) {
  SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 4>> faces;
  for (std::size_t i = 0; i < count; ++i) {
    RandomStream random(seed, 0, i);
    const auto point = [&] {
      const float x = random.next_float(), y = random.next_float(), z = random.next_float();
      return Vec3(x, y, z) - 0.5F;
    };
    const Vec3 centre = extent * point();
    for (int corner = 0; corner < 3; ++corner) vertices.push_back(centre + size * point());
    const auto first = static_cast<std::uint32_t>(3 * i);
    faces.push_back({first, first + 1, first + 2, first + 2});
  }
  builder.object("triangles", white, vertices, faces);
  return builder.build("random triangles");
}

}  // namespace gibench::made
