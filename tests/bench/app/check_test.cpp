#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bench/app/program.h"

namespace gibench::test {
namespace {

TEST(Check, TellsGeometryEffectsAndEveryMethodsPlan) {
  const Outcome outcome = Workshop().gibench({"check", "room.scene.json", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  const auto check = outcome.json();
  EXPECT_EQ(check["scene"], "room");
  EXPECT_EQ(check["geometry"]["faces"], 7);
  ASSERT_EQ(check["effects"].size(), 8U);
  EXPECT_EQ(check["effects"][0]["effect"], "direct");
  EXPECT_TRUE(check["effects"][0]["called_for"].get<bool>());
  EXPECT_THAT(check["effects"][0]["evidence"].get<std::string>(), testing::HasSubstr("lamp"));
  ASSERT_GE(check["methods"].size(), 2U);
  for (const auto& method : check["methods"]) EXPECT_TRUE(method["plan"]["simulated"].is_array());
}

TEST(Check, TellsWhatIsLitAndSeen) {
  const Workshop shop;
  const auto spaces = shop.gibench({"check", "room.scene.json", "--json"}).json()["spaces"];
  EXPECT_GT(spaces["lit_fronts"].get<double>(), 0.9 * spaces["area"].get<double>());
  EXPECT_EQ(spaces["lit_backs"], 0.0);
  EXPECT_FALSE(spaces["nothing_reached"].get<bool>());
  ASSERT_FALSE(spaces["objects"].empty());
  EXPECT_GT(spaces["objects"][0]["front"]["power"].get<double>(), 0.0);
  const std::string out = shop.gibench({"check", "room.scene.json"}).out;
  for (const char* word : {"can reflect light", "lit ", "seen by cameras", "sealed from both"})
    EXPECT_THAT(out, testing::HasSubstr(word));
}

TEST(Check, SaysTheSameForPeople) {
  const Outcome outcome = Workshop().gibench({"check", "room.scene.json"});
  EXPECT_EQ(outcome.status, 0);
  for (const char* word : {"room: valid", "closed", "diffuse_indirect", "pathtracer", "meshless"})
    EXPECT_THAT(outcome.out, testing::HasSubstr(word));
}

TEST(Check, NoBouncesSkipIndirectLight) {
  const auto check = Workshop().gibench({"check", "room.scene.json", "--bounces", "0", "--json"}).json();
  EXPECT_FALSE(check["effects"][1]["called_for"].get<bool>());
}

TEST(Check, TellsThePlanThatAUserAsksFor) {
  const Workshop shop;
  const auto check =
      shop.gibench({"check", "room.scene.json", "--effects", "direct,environment", "--tolerance", "0.1", "--json"}).json();
  EXPECT_TRUE(check["bounce_bound"]["binds"].get<bool>());
  EXPECT_THAT(check["bounce_bound"]["evidence"].get<std::string>(), testing::HasSubstr("albedo"));
  EXPECT_EQ(check["changes"], "none");
  EXPECT_LT(check["analysis_seconds"].get<double>(), 10.0);
  for (const auto& method : check["methods"]) {
    EXPECT_EQ(method["light_paths"], "C.{0,1}[LOB]");
    EXPECT_FALSE(method["complete"].get<bool>());
  }
  const auto one = shop.gibench({"check", "room.scene.json", "--method", "meshless", "--set", "direct=basis", "--json"}).json();
  ASSERT_EQ(one["methods"].size(), 1U);
  EXPECT_TRUE(one["methods"][0]["complete"].get<bool>()) << "nothing in the room is glossy";
}

TEST(Check, UnknownEffectsAndStraySettingsAreBadInput) {
  const Workshop shop;
  expect_bad_input(shop.gibench({"check", "room.scene.json", "--effects", "direct,magic"}),
                   {"--effects", "'magic'", "known:", "glossy_chain"});
  expect_bad_input(shop.gibench({"check", "room.scene.json", "--set", "rays=4"}), {"--set", "--method"});
  expect_bad_input(shop.gibench({"check", "room.scene.json", "--preset", "paper"}), {"--preset", "--method"});
}

TEST(Check, EveryWrongSceneGetsOneLineWithPlaceAndMend) {
  const Workshop shop;
  const std::string triangle = R"("vertices":[[0,0,0],[1,0,0],[0,0,1]],"faces":[[0,1,2]])";
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"{", {"wrong.scene.json"}},
      {R"({"gibench_scene":1,"objects":[{"name":"o","file":"o.ply"}],"colour":1})", {"wrong.scene.json", "colour"}},
      {R"({"gibench_scene":1,"objects":[]})", {"wrong.scene.json", "objects"}},
      {R"({"gibench_scene":1,"materials":{"m":{"bsdf":"diffuse","albedo":1.5}},"objects":[{"name":"o","material":"m",)" +
           triangle + "}]}",
       {"wrong.scene.json", "albedo"}},
      {R"({"gibench_scene":1,"materials":{"m":{"bsdf":"diffuse","albedo":0.5,"emission":-1}},"objects":[{"name":"o","material":"m",)" +
           triangle + "}]}",
       {"wrong.scene.json", "emission"}},
      {R"({"gibench_scene":1,"materials":{"m":{"bsdf":"diffuse","albedo":0.5}},"objects":[{"name":"o","material":"m","vertices":[[0,0,0],[1,0,0],[0,0,1]],"faces":[[0,1,3]]}]})",
       {"wrong.scene.json", "faces"}},
      {R"({"gibench_scene":1,"materials":{"m":{"bsdf":"diffuse","albedo":0.5}},"objects":[{"name":"o","material":"m","vertices":[[0,0,NaN],[1,0,0],[0,0,1]],"faces":[[0,1,2]]}]})",
       {"wrong.scene.json"}},
      {R"({"gibench_scene":1,"materials":{"m":{"bsdf":"diffuse","albedo":0.5}},"objects":[{"name":"o","material":"m","file":"nowhere.obj"}]})",
       {"nowhere.obj", "GIBENCH_PATH"}},
      {R"({"gibench_scene":1,"materials":{"m":{"bsdf":"diffuse","albedo":0.5}},"objects":[{"name":"o","material":"m",)" +
           triangle +
           R"(}],"cameras":[{"name":"c","position":[0,0,0],"look_at":[0,0,0],"up":[0,1,0],"vertical_fov_degrees":40,"resolution":[8,8]}]})",
       {"wrong.scene.json", "cameras"}},
  };
  for (const auto& [text, words] : cases) {
    SCOPED_TRACE(text);
    shop.write("wrong.scene.json", text);
    expect_bad_input(shop.gibench({"check", "wrong.scene.json"}), words);
  }
  expect_bad_input(shop.gibench({"check", "nowhere.scene.json"}), {"nowhere.scene.json"});
  expect_bad_input(shop.gibench({"check", "cornel-box"}), {"cornel-box", "did you mean \"cornell-box\"?"});
}

TEST(Check, ATruncatedModelIsTold) {
  const Workshop shop;
  shop.write("cut.ply", std::string("ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\0\0",
                                    170));
  expect_bad_input(shop.gibench({"check", "cut.ply"}), {"cut.ply"});
}

TEST(Check, ControlCharactersOfFilesAreWrittenOut) {
  const Workshop shop;
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
  const std::string escape = "\033]0;title\a";
  shop.write("wrong.obj", square + "v 0 " + escape + " 0\n");
  const Outcome refused = shop.gibench({"check", "wrong.obj"});
  expect_bad_input(refused, {"line 5", "\\x1b]0;title\\x07"});
  EXPECT_EQ(refused.error.find('\033'), std::string::npos);
  shop.write("named.obj", "usemtl " + escape + "\xFC\n" + square);
  const Outcome taken = shop.gibench({"check", "named.obj"});
  EXPECT_EQ(taken.status, 0) << taken.error;
  EXPECT_THAT(taken.out, testing::HasSubstr("\\x1b]0;title\\x07\\xfc"));
  EXPECT_EQ(taken.out.find('\033'), std::string::npos);
  EXPECT_EQ(shop.gibench({"check", "named.obj", "--json"}).status, 0);
}

}  // namespace
}  // namespace gibench::test
