// Bare models of formats that Assimp reads, in a process of their own: what they do to it, and that they read as before.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include "common/reference/scene_key.h"
#include "common/scene_io/load.h"
#include "tests/bench/app/program.h"

namespace gibench::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The program with the reader of tests/bench/app/odd_reader.
Outcome with_odd_reader(const Workshop& shop, const std::string& arguments, const std::string& before = {}) {
  return shop.gibench({}, before + " exec '" GIBENCH_ODD_READER "' " + arguments + " >stdout.txt 2>stderr.txt;");
}

/// A triangle with a material, a camera and a light, one square metre.
std::string dae() {
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>)"
         R"(<unit name="metre" meter="1"/><up_axis>Y_UP</up_axis></asset><library_effects><effect id="e"><profile_COMMON>)"
         R"(<technique sid="t"><phong><diffuse><color>0.25 0.5 0.75 1</color></diffuse></phong></technique></profile_COMMON>)"
         R"(</effect></library_effects><library_materials><material id="m" name="paint"><instance_effect url="#e"/></material>)"
         R"(</library_materials><library_cameras><camera id="c" name="c"><optics><technique_common><perspective><xfov>40</xfov>)"
         R"(<aspect_ratio>1</aspect_ratio><znear>0.1</znear><zfar>10</zfar></perspective></technique_common></optics></camera>)"
         R"(</library_cameras><library_lights><light id="l" name="l"><technique_common><point><color>3 2 1</color>)"
         R"(</point></technique_common></light></library_lights><library_geometries><geometry id="g" name="g"><mesh><source id="p">)"
         R"(<float_array id="a" count="9">0 0 0 2 0 0 0 1 0</float_array><technique_common>)"
         R"(<accessor source="#a" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>)"
         R"(<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v">)"
         R"(<input semantic="POSITION" source="#p"/></vertices><triangles count="1" material="s">)"
         R"(<input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>)"
         R"(<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"><bind_material>)"
         R"(<technique_common><instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry>)"
         R"(</node><node id="k"><translate>0 0 3</translate><instance_camera url="#c"/></node><node id="j">)"
         R"(<translate>0 2 1</translate><instance_light url="#l"/></node></visual_scene></library_visual_scenes>)"
         R"(<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

/// What `check` says of a model, read by a child, against the same read here.
TEST(ModelProcess, HandsOnWhatIsRead) {
  const Workshop shop;
  const std::filesystem::path file = shop.write("room.dae", dae());
  const Outcome outcome = shop.gibench({"check", file.string(), "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  const Scene scene = load_scene(file);
  ASSERT_EQ(scene.lights.size(), 1U);
  ASSERT_EQ(scene.cameras.size(), 1U);
  EXPECT_EQ(outcome.json()["key"], scene_key(scene)) << outcome.out;
  EXPECT_EQ(outcome.json()["cameras"].size(), 1U);
  EXPECT_EQ(outcome.json()["warnings"].size(), scene.warnings.size());
}

TEST(ModelProcess, IsNotAskedForModelsThatGibenchReadsItself) {
  const Workshop shop;
  shop.write("room.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  const Outcome outcome = with_odd_reader(shop, "check room.obj");
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_FALSE(shop.has("reader-began"));
}

TEST(ModelProcess, MayPrint) {
  const Workshop shop;
  shop.write("room.dae", dae());
  const Outcome outcome = with_odd_reader(shop, "check room.dae");
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_TRUE(shop.has("reader-began"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("library's own")));
  EXPECT_EQ(outcome.error, "");
}

TEST(ModelProcess, ThatCrashesIsOneLine) {
  const Workshop shop;
  shop.write("room.fbx", std::string("crash"));
  expect_bad_input(with_odd_reader(shop, "check room.fbx"),
                   {"room.fbx: crashes the reader of its format (Aborted); convert it to glTF"});
  shop.write("room.fbx", std::string("exit"));
  expect_bad_input(with_odd_reader(shop, "run room.fbx --method pathtracer --out out"),
                   {"room.fbx: crashes the reader of its format (exit status 3); convert it to glTF"});
  EXPECT_FALSE(shop.has("out"));
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

// An array without its count is read as an empty one, and its numbers are then taken from where there are none.
TEST(ModelProcess, ThatAssimpDoesNotSurviveIsOneLine) {
  const Workshop shop;
  std::string text = dae();
  text.replace(text.find("count="), 6, "couft=");
  shop.write("letter.dae", text);
  expect_bad_input(shop.gibench({"check", "letter.dae"}),
                   {"letter.dae: crashes the reader of its format (", "); convert it to glTF, which gibench reads itself"});
}

// Assimp follows nodes by recursion: these are deeper than its stack.
TEST(ModelProcess, ThatIsDeeperThanAssimpsStackIsOneLine) {
  const Workshop shop;
  std::string text = dae();
  const std::string begin = R"(<node id="n">)", end = R"(</node><node id="k">)";
  text.insert(text.find(end), repeated("</node>", 60000));
  text.insert(text.find(begin) + begin.size(), repeated("<node>", 60000));
  shop.write("deep.dae", text);
  expect_bad_input(shop.gibench({"check", "deep.dae"}, "ulimit -s 2048;"),
                   {"deep.dae: crashes the reader of its format (", "); convert it to glTF, which gibench reads itself"});
}

TEST(ModelProcess, ThatNeverEndsIsOneLine) {
  const Workshop shop;
  shop.write("room.fbx", std::string("loop"));
  expect_bad_input(with_odd_reader(shop, "check room.fbx --model-seconds 1"),
                   {"room.fbx: took over 1 s to be read; convert it to glTF", "or raise --model-seconds"});
}

TEST(ModelProcess, ThatTakesTooMuchMemoryIsOneLine) {
  const Workshop shop;
  shop.write("room.fbx", std::string("memory"));
  expect_bad_input(with_odd_reader(shop, "check room.fbx --model-memory 300"),
                   {"room.fbx: needed over 300 MiB to be read; convert it to glTF", "or raise --model-memory"});
}

TEST(ModelProcess, OfAStudyHasTheStudysLimits) {
  const Workshop shop;
  shop.write("room.fbx", std::string("loop"));
  shop.write("s.study.json",
             std::string(R"({"gibench_study": 1, "name": "s", "scenes": ["room.fbx"], "methods": [{"method": "pathtracer"}]})"));
  const Outcome outcome = with_odd_reader(shop, "study s.study.json --out out --model-seconds 1");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.error, HasSubstr("took over 1 s to be read"));
}

bool is_running(const std::string& process) {
  const std::filesystem::path folder = "/proc/" + process;
  std::error_code gone;
  return !std::filesystem::read_symlink(folder / "exe", gone).empty();  // a zombie has none
}

TEST(ModelProcess, EndsWithTheProgramThatTheUserStops) {
  const Workshop shop;
  shop.write("room.fbx", std::string("loop"));
  const Outcome outcome = with_odd_reader(shop, "check room.fbx --model-seconds 600",
                                          "(while [ ! -s reader-began ]; do sleep 0.05; done; kill -INT $$) &");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.error, HasSubstr("cancelled"));
  EXPECT_EQ(outcome.error_lines(), 1U) << outcome.error;
  EXPECT_FALSE(is_running(shop.read("reader-began")));
}

TEST(ModelProcess, EndsWithTheProgramThatIsKilled) {
  const Workshop shop;
  shop.write("room.fbx", std::string("loop"));
  const Outcome outcome = with_odd_reader(shop, "check room.fbx --model-seconds 600",
                                          "(while [ ! -s reader-began ]; do sleep 0.05; done; kill -KILL $$) &");
  EXPECT_EQ(outcome.status, 128 + SIGKILL);
  for (int i = 0; i < 600 && is_running(shop.read("reader-began")); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_FALSE(is_running(shop.read("reader-began")));
}

struct Broken {
  const char* name;
  std::string text;
};

TEST(ModelProcess, RefusesBrokenFilesInOneLine) {
  using namespace std::string_literals;
  const std::string whole = dae();
  const Broken files[] = {
      {"cut.dae", whole.substr(0, whole.size() / 2)},
      {"empty.dae", ""},
      {"text.fbx",
       "; FBX 7.5.0 project file\nObjects:  {\n\tGeometry: 1, \"Geometry::\", \"Mesh\" {\n\t\tVertices: *99999999999 {"},
      {"binary.fbx", "Kaydara FBX Binary  \0\x1a\0\x4c\x1d\0\0\xff\xff\xff\x7f\xff\xff\xff\xff"s + std::string(64, '\xff')},
      {"empty.fbx", ""},
      {"noise.3ds", "\x4d\x4d\xff\xff\xff\x7f"s + std::string(64, '\x3d')},
  };
  const Workshop shop;
  for (const Broken& broken : files) {
    SCOPED_TRACE(broken.name);
    shop.write(broken.name, broken.text);
    expect_bad_input(shop.gibench({"check", broken.name}), {std::string(broken.name) + ": "});
  }
}

}  // namespace
}  // namespace gibench::test
