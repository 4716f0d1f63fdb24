#include "methods/pathtracer/path_scene.h"

namespace gibench::pathtracer {

PathScene::PathScene(const World& w) : world(w) {
  const Scene& scene = world.scene();
  triangles.reserve(scene.triangles.size());
  for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
    const auto& [a, b, c] = scene.triangles[i].corners;
    const Vec3 corner = scene.vertices[a];
    const Object& object = scene.objects[scene.triangle_object[i]];
    triangles.push_back({corner, scene.vertices[b] - corner, scene.vertices[c] - corner, world.normal(i),
                         world.geometry().extent(i), object.material, object.two_sided ? 1U : 0U});
  }
  bsdfs.reserve(scene.materials.size());
  for (const Material& material : scene.materials) bsdfs.emplace_back(material);
}

}  // namespace gibench::pathtracer
