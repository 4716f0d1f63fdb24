#include "common/scene/tessellate.h"

namespace gibench {

namespace {

/// Twice the signed area of (a, b, c) about `axis`: negative where the corner turns the other way.
float turn(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& axis) { return glm::dot(glm::cross(b - a, c - a), axis); }

/// Whether the diagonal (0, 2) lies inside the quad: both halves turn the same way about the quad's vector area.
bool splits_at_first_corner(const Scene& scene, const Face& face) {
  const auto& [a, b, c, d] = face.corners;
  const Vec3 &pa = scene.vertices[a], &pb = scene.vertices[b], &pc = scene.vertices[c], &pd = scene.vertices[d];
  const Vec3 axis = glm::cross(pc - pa, pd - pb);
  return turn(pa, pb, pc, axis) >= 0.0F && turn(pa, pc, pd, axis) >= 0.0F;
}

void add_triangle(Scene& scene, std::uint32_t object, std::uint32_t face, std::array<std::uint32_t, 3> corners) {
  scene.triangles.push_back({corners});
  scene.triangle_face.push_back(face);
  scene.triangle_object.push_back(object);
}

}  // namespace

void tessellate(Scene& scene) {
  scene.triangles.clear();
  scene.triangle_face.clear();
  scene.triangle_object.clear();
  for (std::uint32_t object = 0; object < scene.objects.size(); ++object) {
    Object& o = scene.objects[object];
    o.triangle_begin = static_cast<std::uint32_t>(scene.triangles.size());
    for (std::uint32_t face = o.face_begin; face < o.face_end; ++face) {
      const auto& [a, b, c, d] = scene.faces[face].corners;
      if (!scene.faces[face].is_quad()) {
        add_triangle(scene, object, face, {a, b, c});
      } else if (splits_at_first_corner(scene, scene.faces[face])) {
        add_triangle(scene, object, face, {a, b, c});
        add_triangle(scene, object, face, {a, c, d});
      } else {
        add_triangle(scene, object, face, {a, b, d});
        add_triangle(scene, object, face, {b, c, d});
      }
    }
    o.triangle_end = static_cast<std::uint32_t>(scene.triangles.size());
  }
}

}  // namespace gibench
