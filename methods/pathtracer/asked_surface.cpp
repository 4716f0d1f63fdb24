#include "methods/pathtracer/asked_surface.h"

namespace gibench::pathtracer {

AskedSurface::AskedSurface(const PathScene& scene, const SceneLights& lights, Quantity quantity, const SurfaceSample& sample,
                           const Vec3& toward_viewer)
    : position(sample.position), normal(sample.normal), origin(scene.world.ray_origin(sample)), out(sample.normal) {
  lit = sample.lit_side;
  if (!lit) return;
  const std::uint32_t material = scene.world.scene().objects[sample.object].material;
  const SurfaceBsdf& surface = scene.bsdfs[material];
  const Rgb& radiance = lights.emission_of_material(material);
  switch (quantity) {
    case Quantity::radiance:
      bsdf = &surface;
      out = toward_viewer;
      emitted = radiance;
      lit = glm::dot(normal, out) > 0.0F;
      break;
    case Quantity::radiosity:
      emitted = radiance * pi;
      draws_out = !surface.is_diffuse();
      factor = pi;
      bsdf = &surface;
      break;
    case Quantity::irradiance:
    case Quantity::accessibility: bsdf = &scene.sensor; break;
  }
}

}  // namespace gibench::pathtracer
