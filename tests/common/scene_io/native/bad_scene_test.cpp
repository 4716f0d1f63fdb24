// Every kind of wrong scene file: one line that says where, what is wrong, and how to fix it.
#include <vector>

#include "tests/common/scene_io/scene_text.h"

namespace gibench::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

struct BadScene {
  std::string name;
  std::string pointer;  ///< what is changed in full_scene(), as a JSON pointer
  json value;           ///< what stands there instead
  std::string place, problem, remedy;
};

class BadSceneTest : public testing::TestWithParam<BadScene> {};

TEST_P(BadSceneTest, IsOneLineWithPlaceProblemAndRemedy) {
  const BadScene& bad = GetParam();
  json scene = full_scene();
  scene[json::json_pointer(bad.pointer)] = bad.value;
  const std::string error = error_of([&] { load(scene); });
  EXPECT_THAT(error, testing::StartsWith("box.scene.json: " + bad.place + ": "));
  EXPECT_THAT(error, HasSubstr(bad.problem));
  EXPECT_THAT(error, HasSubstr("; "));
  EXPECT_THAT(error, HasSubstr(bad.remedy));
  EXPECT_EQ(error.find_first_of("\n\r"), std::string::npos);
}

const std::vector<BadScene>& wrong_forms() {
  static const std::vector<BadScene> cases{
      {"UnknownTopKey", "/colour", 1, "$", "unknown key \"colour\"", "known keys: $schema, cameras"},
      {"UnknownMaterialKey", "/materials/white/albdo", 1, "$.materials.white", "unknown key \"albdo\"",
       "did you mean \"albedo\"?"},
      {"UnknownObjectKey", "/objects/0/twosided", true, "$.objects[0]", "unknown key \"twosided\"",
       "did you mean \"two_sided\"?"},
      {"UnknownLightKey", "/lights/0/power", 1, "$.lights[0]", "unknown key \"power\"", "intensity, position, type"},
      {"UnknownCameraKey", "/cameras/0/fov", 1, "$.cameras[0]", "unknown key \"fov\"", "vertical_fov_degrees"},
      {"UnknownEditKey", "/edits/0/by", 1, "$.edits[0]", "unknown key \"by\"", "move, rotate_degrees, translate"},
      {"UnknownExposureKey", "/exposure/stops", 1, "$.exposure", "unknown key \"stops\"", "start, stop, value"},
      {"Version", "/gibench_scene", 2, "$.gibench_scene", "2 is not 1", "the version of the format"},
      {"TopIsAList", "", json::array(), "$", "a list is of the wrong type", "a scene: NAME.scene.json"},
      {"NameIsANumber", "/name", 3, "$.name", "3 is of the wrong type", "a text"},
      {"EmptyName", "/objects/0/name", "", "$.objects[0].name", "the text is empty", "a text that no other object has"},
      {"NoObjects", "/objects", json::array(), "$.objects", "a list of 0 values", "at least one object"},
      {"MissingKey",
       "/materials/satin",
       {{"bsdf", "phong"}, {"exponent", 2}},
       "$.materials.satin",
       "the key \"specular\" is missing",
       "a reflectance"},
      {"NoGeometry",
       "/objects/0",
       {{"name", "floor"}, {"material", "white"}},
       "$.objects[0]",
       "the key \"vertices\" is missing",
       "a model \"file\" instead"},
      {"UnknownBsdf", "/materials/white/bsdf", "lambert", "$.materials.white.bsdf", "\"lambert\" is not known here",
       "\"diffuse\", \"phong\", \"ggx\" or \"mirror\""},
      {"UnknownLightType", "/lights/0/type", "area", "$.lights[0].type", "\"area\" is not known here", "\"environment\""},
      {"AlbedoAboveOne", "/materials/white/albedo", 1.2, "$.materials.white.albedo", "1.2 is above 1", "in [0, 1]"},
      {"ChannelAboveOne",
       "/materials/white/albedo",
       {0.5, 0.5, 1.5},
       "$.materials.white.albedo[2]",
       "1.5 is above 1",
       "in [0, 1]"},
      {"NegativeAlbedo", "/materials/white/albedo", -0.1, "$.materials.white.albedo", "-0.1 is below 0", "in [0, 1]"},
      {"TwoChannels",
       "/materials/white/albedo",
       {0.5, 0.5},
       "$.materials.white.albedo",
       "a list of 2 values",
       "a number, or three"},
      {"NegativeEmission",
       "/materials/lamp/emission",
       {1, -2, 1},
       "$.materials.lamp.emission[1]",
       "-2 is below 0",
       "a radiance of at least 0"},
      {"RoughnessAboveOne", "/materials/metal/roughness", 1.01, "$.materials.metal.roughness", "1.01 is above 1", "in [0, 1]"},
      {"NegativeExponent", "/materials/satin/exponent", -1, "$.materials.satin.exponent", "-1 is below 0", "at least 0"},
      {"VertexIsNull", "/objects/0/vertices/1/2", nullptr, "$.objects[0].vertices[1][2]", "null is of the wrong type",
       "a coordinate in metres"},
      {"VertexIsText", "/objects/0/vertices/1/2", "NaN", "$.objects[0].vertices[1][2]", "\"NaN\" is of the wrong type",
       "a coordinate in metres"},
      {"VertexOfTwo", "/objects/0/vertices/1", {1, 2}, "$.objects[0].vertices[1]", "a list of 2 values", "[x, y, z]"},
      {"NegativeIndex", "/objects/0/faces/0/1", -1, "$.objects[0].faces[0][1]", "-1 is below 0", "a whole number from 0"},
      {"FractionalIndex", "/objects/0/faces/0/1", 1.5, "$.objects[0].faces[0][1]", "1.5 is of the wrong type",
       "a whole number from 0"},
      {"FaceOfTwo", "/objects/0/faces/0", {0, 1}, "$.objects[0].faces[0]", "a list of 2 values", "3 to 10000 vertex indices"},
      {"NegativeIntensity", "/lights/0/intensity", -1, "$.lights[0].intensity", "-1 is below 0", "W/sr"},
      {"FovTooWide", "/cameras/0/vertical_fov_degrees", 180, "$.cameras[0].vertical_fov_degrees", "180 is not below 180",
       "below 180"},
      {"FovZero", "/cameras/0/vertical_fov_degrees", 0, "$.cameras[0].vertical_fov_degrees", "0 is not above 0", "above 0"},
      {"NoPixels", "/cameras/0/resolution", {0, 10}, "$.cameras[0].resolution[0]", "0 is below 1", "pixels"},
      {"EditOfNothing", "/edits/0", {{"paint", "floor"}}, "$.edits[0]", "unknown key \"paint\"", "deform, file"},
  };
  return cases;
}

const std::vector<BadScene>& wrong_meanings() {
  static const std::vector<BadScene> cases{
      {"IndexPastEnd", "/objects/0/faces/0/1", 4, "$.objects[0].faces[0][1]", "index 4 is past the end of 4 vertices",
       "from 0 to 3"},
      {"UnknownMaterial", "/objects/0/material", "wite", "$.objects[0].material", "there is no material \"wite\"",
       "did you mean \"white\"?"},
      {"EmptyScene", "/objects/0/faces", json::array(), "$.objects", "the scene is empty", "a face"},
      {"ZeroScale", "/objects/0/scale", {1, 0, 1}, "$.objects[0].scale", "a scale of 0", "other than 0"},
      {"TransformedToInfinity",
       "/objects/0",
       {{"name", "floor"},
        {"material", "white"},
        {"vertices", {{1e300, 0, 0}, {1, 0, 0}, {1, 1, 0}}},
        {"faces", {{0, 1, 2}}},
        {"scale", 1e300}},
       "$.objects[0]",
       "vertex 0 of object \"floor\" is not finite",
       "coordinates"},
      {"TooLarge", "/objects/0/vertices/0/0", 1e30, "$.objects", "larger than 1e18 m", "scale it down"},
      {"PhongCreatesEnergy",
       "/materials/satin/specular",
       {0.4, 0.8, 0.4},
       "$.materials.satin",
       "diffuse + specular = 1.1 is above 1",
       "lower one"},
      {"GgxCreatesEnergy", "/materials/metal/diffuse", 0.2, "$.materials.metal", "diffuse + f0 = 1.1 is above 1", "lower one"},
      {"EmissionTooLarge", "/materials/lamp/emission", 1e39, "$.materials.lamp.emission", "too large for single precision",
       "3.4e38"},
      {"ZeroSpotDirection", "/lights/1/direction", {0, 0, 0}, "$.lights[1].direction", "the direction is zero", "above 0"},
      {"ZeroSunDirection", "/lights/2/direction", {0, 0, 0}, "$.lights[2].direction", "the direction is zero", "above 0"},
      {"ConesCrossed", "/lights/1/outer_degrees", 10, "$.lights[1].outer_degrees", "narrower than the inner",
       "at least inner_degrees"},
      {"LooksAtItself",
       "/cameras/0/look_at",
       {0.5, 0.5, 2},
       "$.cameras[0].look_at",
       "looks at its own position",
       "move position or look_at"},
      {"UpAlongView", "/cameras/0/up", {0, 0, -3}, "$.cameras[0].up", "up is parallel to the view", "across the view"},
      {"ZeroUp", "/cameras/0/up", {0, 0, 0}, "$.cameras[0].up", "the direction is zero", "above 0"},
      {"TwoCameras", "/cameras/1/name", "front", "$.cameras[1].name", "two cameras named \"front\"", "rename"},
      {"ExposureBackwards", "/exposure/start", 3, "$.exposure", "start is not below stop", "start below stop"},
      {"MovesNothing", "/edits/0/move", "flor", "$.edits[0].move", "there is no object \"flor\"", "did you mean \"floor\"?"},
      {"PaintsNothing", "/edits/1/material", "black", "$.edits[1].material", "there is no material \"black\"",
       "materials: glass, lamp"},
      {"EditsNoSuchLight", "/edits/5/light", 4, "$.edits[5].light", "there is no light 4", "from 0 to 3"},
      {"EditWithOtherBsdfsKey", "/edits/1/roughness", 0.5, "$.edits[1].roughness", "a diffuse material has no \"roughness\"",
       "albedo, emission"},
      {"EditCreatesEnergy", "/edits/3/f0", 1.0, "$.edits[3]", "diffuse + f0 = 1.05", "lower one"},
      {"EditWithOtherLightsKey", "/edits/5/radiance", 2, "$.edits[5]", "unknown key \"radiance\"", "intensity, position, type"},
      {"EditCrossesCones", "/edits/6/inner_degrees", 60, "$.edits[6].outer_degrees", "narrower than the inner",
       "at least inner_degrees"},
      {"DeformsNothing",
       "/edits/0",
       {{"deform", "wall"}, {"file", "wall.ply"}},
       "$.edits[0].deform",
       "there is no object \"wall\"",
       "objects: floor"},
      {"DeformFileMissing",
       "/edits/0",
       {{"deform", "floor"}, {"file", "floor2.ply"}},
       "$.edits[0].file",
       "there is no file \"floor2.ply\"",
       "GIBENCH_PATH"},
      {"EnvironmentFileMissing",
       "/lights/3",
       {{"type", "environment"}, {"file", "probe.exr"}},
       "$.lights[3].file",
       "there is no file \"probe.exr\"",
       "GIBENCH_PATH"},
      {"EnvironmentWithBoth", "/lights/3/file", "probe.exr", "$.lights[3]", "unknown key \"radiance\"",
       "file, rotate_y_degrees, scale"},
  };
  return cases;
}

std::string case_name(const testing::TestParamInfo<BadScene>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Form, BadSceneTest, testing::ValuesIn(wrong_forms()), case_name);
INSTANTIATE_TEST_SUITE_P(Meaning, BadSceneTest, testing::ValuesIn(wrong_meanings()), case_name);

TEST(BadScene, TwoObjectsOfOneName) {
  json scene = quad_scene();
  scene["objects"].push_back(scene["objects"][0]);
  const std::string error = error_of([&] { load(scene); });
  EXPECT_EQ(error, "box.scene.json: $.objects[1].name: there are two objects named \"floor\"; rename one of them");
}

TEST(BadScene, KeyTwiceInOneObject) {
  const auto parse = [](const std::string& text) { return error_of([&] { parse_scene(text, "box.scene.json"); }); };
  EXPECT_EQ(parse(R"({"materials": {"white": {}, "white": {}}})"),
            "box.scene.json: $.materials: the key \"white\" appears twice; rename or remove one of them");
  EXPECT_EQ(parse(R"({"objects": [1, [2], {"a b": {"x": 1, "x": 2}}]})"),
            "box.scene.json: $.objects[2][\"a b\"]: the key \"x\" appears twice; rename or remove one of them");
}

TEST(BadScene, SyntaxErrorsNameLineAndColumn) {
  const auto parse = [](const std::string& text) { return error_of([&] { parse_scene(text, "box.scene.json"); }); };
  EXPECT_THAT(parse("{\n  \"name\": \"a\",\n}"), HasSubstr("box.scene.json: line 3, column 1: syntax error"));
  EXPECT_THAT(parse("{\"x\": NaN}"), HasSubstr("line 1, column 7"));
  EXPECT_THAT(parse("{\"x\": NaN}"), HasSubstr("no comments, trailing commas, NaN or Infinity"));
  EXPECT_THAT(parse(""), HasSubstr("line 1, column 1"));
  EXPECT_THAT(parse("{\"x\": \"a\nb\"}"), testing::Not(HasSubstr("\n")));
  EXPECT_THAT(parse("{\"x\": 1e999}"), HasSubstr("1e999"));
}

TEST(BadScene, MissingFilesListTheFoldersSearched) {
  ASSERT_EQ(setenv("GIBENCH_PATH", "/no/such/models:/nor/these", 1), 0);
  json scene = quad_scene();
  scene["objects"].push_back({{"name", "statue"}, {"file", "statue.ply"}});
  const std::string in_scene = error_of([&] { load(scene, "rooms"); });
  const std::string bare = error_of([] { load_scene("absent.scene.json"); });
  unsetenv("GIBENCH_PATH");
  EXPECT_EQ(in_scene,
            "box.scene.json: $.objects[1].file: there is no file \"statue.ply\" in rooms, /no/such/models, /nor/these; "
            "correct the name, or add the folder that has it to GIBENCH_PATH");
  EXPECT_THAT(bare, HasSubstr("absent.scene.json: there is no file \"absent.scene.json\" in ., /no/such/models"));
}

}  // namespace
}  // namespace gibench::test
