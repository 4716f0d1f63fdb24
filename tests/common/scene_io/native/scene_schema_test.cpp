// The schema and the loader are one: what the schema names the loader reads, what it does not name is refused.
#include "common/scene_io/native/scene_schema_text.h"

#include <functional>
#include <set>

#include "tests/common/scene_io/scene_text.h"
#include "tests/support/scratch_folder.h"

namespace gibench::test {
namespace {

using nlohmann::json;

/// All property names in the schema below `node`, with the definition that they belong to.
void collect_keys(const json& node, std::set<std::string>& keys) {
  if (node.is_object())
    for (const auto& [name, value] : node.items()) {
      if (name == "properties")
        for (const auto& [key, ignored] : value.items()) keys.insert(key);
      if (name != "if") collect_keys(value, keys);
    }
  if (node.is_array())
    for (const json& element : node) collect_keys(element, keys);
}

void collect_used_keys(const json& node, std::set<std::string>& keys) {
  if (node.is_object())
    for (const auto& [name, value] : node.items()) keys.insert(name), collect_used_keys(value, keys);
  if (node.is_array())
    for (const json& element : node) collect_used_keys(element, keys);
}

/// full_scene() with a model, a picture and their keys added.
json full_scene_with_files(const ScratchFolder& folder) {
  write_text(folder / "plate.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write_text(folder / "sky.pfm", "PF\n2 1\n-1.0\n" + std::string(24, '\0'));
  json scene = full_scene();
  scene["objects"].push_back({{"name", "plate"},
                              {"file", "plate.obj"},
                              {"material", "metal"},
                              {"scale", 2},
                              {"rotate_degrees", {0, 1, 0}},
                              {"translate", {0, 0, 1}},
                              {"two_sided", false},
                              {"group", "plates"}});
  scene["lights"].push_back({{"type", "environment"}, {"file", "sky.pfm"}, {"scale", 2}, {"rotate_y_degrees", 20}});
  scene["edits"].push_back({{"deform", "plate"}, {"file", "plate.obj"}});
  scene["edits"].push_back({{"light", 4}, {"file", "sky.pfm"}, {"scale", 3}, {"rotate_y_degrees", 30}});
  return scene;
}

TEST(SceneSchema, IsTheFileInTheSceneFolder) {
  std::ifstream file(GIBENCH_SOURCE_DIR "/scenes/scene.schema.json");
  ASSERT_TRUE(file);
  EXPECT_EQ(json::parse(file), json::parse(scene_schema_text()));
}

TEST(SceneSchema, EveryKeyOfTheSchemaLoads) {
  const ScratchFolder folder;
  const json scene = full_scene_with_files(folder);
  std::set<std::string> known, used;
  collect_keys(json::parse(scene_schema_text()), known);
  collect_used_keys(scene, used);
  for (const std::string& key : known) EXPECT_TRUE(used.contains(key)) << key << " is in the schema but not in the test scene";
  const Scene loaded = load(scene, folder.path());
  EXPECT_EQ(loaded.objects.size(), 2U);
  EXPECT_EQ(loaded.edits.size(), 11U);
  const auto& sky = std::get<EnvironmentLight>(std::get<LightEdit>(loaded.edits[10]).after);
  ASSERT_NE(sky.image, nullptr);
  EXPECT_EQ(sky.image->width, 2);
  EXPECT_EQ(sky.radiance, Rgb(3.0F));
  EXPECT_EQ(sky.rotate_y_degrees, 30.0F);
}

TEST(SceneSchema, EveryRuleHasWords) {
  const json schema = json::parse(scene_schema_text());
  const std::function<void(const json&, const std::string&)> look = [&](const json& node, const std::string& path) {
    if (!node.is_object()) return;
    if (node.contains("minimum") || node.contains("maximum") || node.contains("enum") || node.contains("items")) {
      EXPECT_TRUE(node.contains("description")) << path;
    }
    for (const auto& [key, value] : node.items()) look(value, path + "/" + key);
    for (const auto& [key, value] : node.items())
      if (value.is_array())
        for (std::size_t i = 0; i < value.size(); ++i) look(value[i], path + "/" + key + "/" + std::to_string(i));
  };
  look(schema, "");
}

TEST(SceneSchema, UnreadablePictureIsAnError) {
  const ScratchFolder folder;
  write_text(folder / "sky.exr", "no picture at all");
  json scene = quad_scene();
  scene["lights"] = {{{"type", "environment"}, {"file", "sky.exr"}}};
  const std::string error = error_of([&] { load(scene, folder.path()); });
  EXPECT_THAT(error, testing::StartsWith("box.scene.json: $.lights[0].file: "));
  EXPECT_THAT(error, testing::HasSubstr("sky.exr"));
  EXPECT_EQ(error.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace gibench::test
