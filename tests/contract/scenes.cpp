#include "tests/contract/scenes.h"

#include <cmath>
#include <utility>

#include "common/geometry/surface_sampling.h"
#include "common/scene/light_kinds.h"
#include "common/scene/made_scenes.h"

namespace gibench::contract {

namespace {

const PointLight point_light{{0.3F, 0.7F, 0.7F}, {1.0F, 0.8F, 0.6F}};

SpotLight spot_light() {
  return {{0.7F, 0.95F, 0.3F}, glm::normalize(Vec3(-0.3F, -1.0F, 0.4F)), Rgb(2.0F), std::cos(0.3F), std::cos(0.6F)};
}

Material named(const char* name, Bsdf bsdf) {
  Material material;
  material.name = name;
  material.bsdf = bsdf;
  return material;
}

Material mirror() {
  Material material = named("mirror", Bsdf::mirror);
  material.reflectance = Rgb(0.9F);
  return material;
}

Material phong(float exponent) {
  Material material = named("satin", Bsdf::phong);
  material.diffuse = Rgb(0.3F);
  material.specular = Rgb(0.4F);
  material.exponent = exponent;
  return material;
}

Material ggx(float roughness) {
  Material material = named("metal", Bsdf::ggx);
  material.roughness = roughness;
  material.f0 = {0.9F, 0.6F, 0.3F};
  return material;
}

/// A white room with a lamp, and whatever a test adds to it.
made::SceneBuilder room() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.7F));
  const std::uint32_t lamp = builder.diffuse("lamp", Rgb(0.0F), Rgb(10.0F));
  builder.room("room", white, Vec3(0.0F), Vec3(1.0F));
  builder.quad("lamp", lamp, {{{0.4F, 0.98F, 0.4F}, {0.6F, 0.98F, 0.4F}, {0.6F, 0.98F, 0.6F}, {0.4F, 0.98F, 0.6F}}});
  return builder;
}

Scene room_with_block_of(const Material& material) {
  made::SceneBuilder builder = room();
  const std::uint32_t index = builder.material(material);
  builder.block("block", index, {0.3F, 0.0F, 0.3F}, {0.7F, 0.4F, 0.7F}, 20.0F);
  return builder.build("room with a block of " + material.name);
}

/// Triangles without area: corners that coincide, corners in a line, and one as thin as floats can make it.
void add_degenerate(made::SceneBuilder& builder) {
  builder.object("degenerate", 0,
                 {{0.5F, 0.5F, 0.5F}, {0.6F, 0.5F, 0.5F}, {0.7F, 0.5F, 0.5F}, {0.5F, 0.5F, 0.5F}, {0.6F, 0.5F + 1e-7F, 0.5F}},
                 {{0, 0, 1, 1}, {0, 1, 2, 2}, {0, 0, 0, 0}, {0, 3, 1, 1}, {0, 2, 4, 4}, {0, 1, 2, 3}});
}

Scene degenerate_faces() {
  made::SceneBuilder builder = room();
  add_degenerate(builder);
  return builder.build("degenerate faces");
}

Scene nothing_has_area() {
  made::SceneBuilder builder;
  builder.diffuse("white", Rgb(0.7F), Rgb(1.0F));
  add_degenerate(builder);
  return builder.build("nothing has area");
}

Scene two_sided_plate() {
  made::SceneBuilder builder = room();
  const std::uint32_t red = builder.diffuse("red", {0.7F, 0.1F, 0.1F});
  builder.quad("plate", red, {{{0.2F, 0.5F, 0.2F}, {0.2F, 0.5F, 0.8F}, {0.8F, 0.5F, 0.8F}, {0.8F, 0.5F, 0.2F}}}, true);
  return builder.build("two-sided plate");
}

Scene under_the_sky() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.7F));
  builder.quad("ground", white, {{{-1.0F, 0.0F, -1.0F}, {-1.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 1.0F}, {1.0F, 0.0F, -1.0F}}});
  builder.block("block", white, {-0.2F, 0.0F, -0.2F}, {0.2F, 0.5F, 0.2F}, 30.0F);
  builder.light(EnvironmentLight{Rgb(1.0F), nullptr, 0.0F});
  builder.light(DirectionalLight{glm::normalize(Vec3(0.4F, -1.0F, 0.2F)), Rgb(3.0F)});
  return builder.build("under the sky");
}

Scene one_lit_triangle() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.7F));
  builder.object("triangle", white, {{0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 0.0F}}, {{0, 1, 2, 2}});
  builder.light(PointLight{{0.3F, 1.0F, 0.3F}, Rgb(1.0F)});
  return builder.build("one lit triangle");
}

/// Where 1/d² and the cosine both leave the numbers: lights in the plane of a wall and in a corner.
Scene lights_on_surfaces() {
  made::BoxOptions options;
  options.lights = {PointLight{{0.5F, 0.0F, 0.9F}, Rgb(1.0F)}, PointLight{Vec3(0.0F), Rgb(1.0F)},
                    SpotLight{{0.5F, 1.0F, 0.1F}, {0.0F, -1.0F, 0.0F}, Rgb(1.0F), 1.0F, 1.0F}};
  return made::box_scene(options);
}

}  // namespace

Scene plain_box() {
  made::BoxOptions options;
  options.lights = {point_light, spot_light()};
  return made::box_scene(options);
}

Scene black_box() {
  Scene scene = plain_box();
  for (Material& material : scene.materials) material.diffuse = Rgb();
  return scene;
}

Scene dark_box() {
  made::BoxOptions options;
  options.lamp_emission = Rgb();
  return made::box_scene(options);
}

Lighting scaled(Lighting lighting, float factor) {
  for (Rgb& emission : lighting.emission) emission *= factor;
  for (Light& light : lighting.lights) *parts_of(light).strength *= factor;
  return lighting;
}

Lighting only_emission(Lighting lighting) {
  lighting.lights.clear();
  return lighting;
}

Lighting only_punctual(Lighting lighting) {
  for (Rgb& emission : lighting.emission) emission = Rgb();
  return lighting;
}

std::vector<SurfaceSample> samples_of(const World& world) { return area_uniform_samples(world, sample_count, sample_seed); }

std::vector<SurfaceSample> other_sides(const World& world, const std::vector<SurfaceSample>& samples) {
  std::vector<SurfaceSample> turned;
  for (const SurfaceSample& sample : samples)
    turned.push_back(world.sample_at(sample.triangle, sample.barycentrics, -sample.normal));
  return turned;
}

std::vector<SurfaceSample> carried_over(const World& to, const std::vector<SurfaceSample>& samples) {
  std::vector<SurfaceSample> carried;
  for (const SurfaceSample& sample : samples)
    carried.push_back(to.sample_at(sample.triangle, sample.barycentrics, to.normal(sample.triangle)));
  return carried;
}

std::vector<OddScene> odd_scenes() {
  std::vector<OddScene> scenes;
  scenes.push_back({"plain box", plain_box(), true});
  scenes.push_back({"degenerate faces", degenerate_faces(), true});
  scenes.push_back({"two-sided plate", two_sided_plate(), true});
  scenes.push_back({"one lit triangle", one_lit_triangle(), true});
  scenes.push_back({"lights on surfaces", lights_on_surfaces(), true});
  scenes.push_back({"nothing has area", nothing_has_area()});
  scenes.push_back({"under the sky", under_the_sky()});
  scenes.push_back({"mirror", room_with_block_of(mirror())});
  scenes.push_back({"satin", room_with_block_of(phong(20.0F))});
  scenes.push_back({"near mirror", room_with_block_of(phong(1e5F))});
  scenes.push_back({"metal", room_with_block_of(ggx(0.3F))});
  scenes.push_back({"polished metal", room_with_block_of(ggx(0.0F))});
  return scenes;
}

}  // namespace gibench::contract
