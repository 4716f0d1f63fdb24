#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <set>

#include "common/reference/scene_key.h"
#include "common/scene/made_scenes.h"
#include "tests/common/reference/references.h"

namespace gibench {
namespace {

/// A scene with everything that a key sees.
Scene full_scene() {
  Scene scene = made::box_scene();
  auto image = std::make_shared<EnvironmentImage>();
  image->width = 2, image->height = 1, image->pixels = {Rgb(1.0F), Rgb(2.0F)};
  scene.lights = {PointLight{{0.1F, 0.2F, 0.3F}, Rgb(1.0F)}, SpotLight{{0.1F, 0.2F, 0.3F}, {0, -1, 0}, Rgb(1.0F), 0.9F, 0.8F},
                  DirectionalLight{{0, -1, 0}, Rgb(1.0F)}, EnvironmentLight{Rgb(1.0F), image, 10.0F}};
  scene.cameras.push_back(*test::image_question().camera);
  return scene;
}

using Change = std::function<void(Scene&)>;

template <class LightType>
Change of_light(std::size_t index, std::function<void(LightType&)> change) {
  return [index, change](Scene& scene) { change(std::get<LightType>(scene.lights[index])); };
}

TEST(SceneKey, EverythingThatLightSeesChangesIt) {
  const std::vector<Change> changes{
      [](Scene& s) { s.vertices[3].y += 1e-6F; },
      [](Scene& s) { std::swap(s.faces[0].corners[1], s.faces[0].corners[2]); },
      [](Scene& s) { std::swap(s.triangles[0].corners[1], s.triangles[0].corners[2]); },
      [](Scene& s) { s.objects[0].material = (s.objects[0].material + 1) % static_cast<std::uint32_t>(s.materials.size()); },
      [](Scene& s) { s.objects[0].two_sided = !s.objects[0].two_sided; },
      [](Scene& s) { s.objects.pop_back(); },
      [](Scene& s) { s.materials[0].bsdf = Bsdf::phong; },
      [](Scene& s) { s.materials[0].diffuse.g += 0.01F; },
      [](Scene& s) { s.materials[0].specular.r += 0.01F; },
      [](Scene& s) { s.materials[0].exponent += 1.0F; },
      [](Scene& s) { s.materials[0].roughness += 0.01F; },
      [](Scene& s) { s.materials[0].f0.b += 0.01F; },
      [](Scene& s) { s.materials[0].reflectance.r += 0.01F; },
      [](Scene& s) { s.materials[0].emission.r += 0.01F; },
      [](Scene& s) { s.lights.pop_back(); },
      [](Scene& s) { std::swap(s.lights[0], s.lights[1]); },
      of_light<PointLight>(0, [](PointLight& l) { l.position.x += 0.1F; }),
      of_light<PointLight>(0, [](PointLight& l) { l.intensity.b += 0.1F; }),
      of_light<SpotLight>(1, [](SpotLight& l) { l.position.z += 0.1F; }),
      of_light<SpotLight>(1, [](SpotLight& l) { l.direction.x += 0.1F; }),
      of_light<SpotLight>(1, [](SpotLight& l) { l.intensity.r += 0.1F; }),
      of_light<SpotLight>(1, [](SpotLight& l) { l.cos_inner += 0.01F; }),
      of_light<SpotLight>(1, [](SpotLight& l) { l.cos_outer += 0.01F; }),
      of_light<DirectionalLight>(2, [](DirectionalLight& l) { l.direction.y += 0.1F; }),
      of_light<DirectionalLight>(2, [](DirectionalLight& l) { l.irradiance.r += 0.1F; }),
      of_light<EnvironmentLight>(3, [](EnvironmentLight& l) { l.radiance.r += 0.1F; }),
      of_light<EnvironmentLight>(3, [](EnvironmentLight& l) { l.rotate_y_degrees += 1.0F; }),
      of_light<EnvironmentLight>(3, [](EnvironmentLight& l) { l.image = nullptr; }),
      of_light<EnvironmentLight>(3,
                                 [](EnvironmentLight& l) {
                                   auto image = std::make_shared<EnvironmentImage>(*l.image);
                                   image->pixels[1].g += 0.5F;
                                   l.image = image;
                                 }),
      of_light<EnvironmentLight>(3,
                                 [](EnvironmentLight& l) {
                                   auto image = std::make_shared<EnvironmentImage>(*l.image);
                                   std::swap(image->width, image->height);
                                   l.image = image;
                                 }),
  };
  std::set<std::string> keys{scene_key(full_scene())};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Scene scene = full_scene();
    changes[i](scene);
    EXPECT_TRUE(keys.insert(scene_key(scene)).second) << "change " << i;
  }
}

TEST(SceneKey, NamesPathsAndViewsDoNot) {
  const std::string key = scene_key(full_scene());
  const std::vector<Change> changes{
      [](Scene& s) { s.name = "another"; },
      [](Scene& s) { s.file = "another.scene.json"; },
      [](Scene& s) {
        s.origin = {1.0, 2.0, 3.0};
      },
      [](Scene& s) { s.objects[0].name = "another"; },
      [](Scene& s) { s.objects[0].group = "another"; },
      [](Scene& s) { s.materials[0].name = "another"; },
      [](Scene& s) { s.cameras.clear(); },
      [](Scene& s) {
        s.exposure = Exposure{1.0F, 2.0F, 3.0F};
      },
      [](Scene& s) { s.warnings = {"a line"}; },
      [](Scene& s) {
        s.edits = {MoveEdit{"statue", {}, {}}};
      },
      [](Scene& s) {
        auto& light = std::get<EnvironmentLight>(s.lights[3]);
        light.image = std::make_shared<EnvironmentImage>(*light.image);
      },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Scene scene = full_scene();
    changes[i](scene);
    EXPECT_EQ(scene_key(scene), key) << "change " << i;
  }
}

TEST(ReferenceKey, EveryFieldOfTheQuestionChangesIt) {
  const Scene scene = full_scene();
  using QuestionChange = std::function<void(ReferenceQuestion&)>;
  const std::vector<QuestionChange> changes{
      [](ReferenceQuestion& q) { q.path_class = "C.{0,3}[LOB]"; },
      [](ReferenceQuestion& q) { q.seed = 2; },
      [](ReferenceQuestion& q) { q.surface_samples = 51; },
      [](ReferenceQuestion& q) { q.surface_domain = "seen"; },
      [](ReferenceQuestion& q) { q.pixel_samples = 2; },
      [](ReferenceQuestion& q) { q.camera.reset(); },
      [](ReferenceQuestion& q) { q.camera->position.x += 0.1F; },
      [](ReferenceQuestion& q) { q.camera->look_at.x += 0.1F; },
      [](ReferenceQuestion& q) { q.camera->up.x += 0.1F; },
      [](ReferenceQuestion& q) { q.camera->vertical_fov_degrees += 1.0F; },
      [](ReferenceQuestion& q) { q.camera->width += 1; },
      [](ReferenceQuestion& q) { q.camera->height += 1; },
  };
  std::set<std::string> keys{reference_key(scene, test::image_question())};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    ReferenceQuestion question = test::image_question();
    changes[i](question);
    EXPECT_TRUE(keys.insert(reference_key(scene, question)).second) << "change " << i;
  }
  ReferenceQuestion renamed = test::image_question();
  renamed.camera->name = "another";
  EXPECT_EQ(reference_key(scene, renamed), reference_key(scene, test::image_question()));
  Scene other = scene;
  other.vertices[0].x += 0.5F;
  EXPECT_NE(reference_key(other, test::image_question()), reference_key(scene, test::image_question()));
}

}  // namespace
}  // namespace gibench
