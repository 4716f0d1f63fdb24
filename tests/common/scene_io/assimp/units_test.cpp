// Lengths of FBX and COLLADA files in metres, and the warning of what single precision costs them.
#include <cmath>

#include "tests/common/scene_io/scene_text.h"
#include "tests/support/scratch_folder.h"

namespace gibench::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// A square of two units, in units of so many centimetres; without a number the file states none.
std::string fbx(const std::string& centimetres) {
  const std::string unit =
      centimetres.empty() ? "" : "\t\tP: \"UnitScaleFactor\", \"double\", \"Number\", \"\", " + centimetres + "\n";
  return "; FBX 7.5.0 project file\nFBXHeaderExtension:  {\n\tFBXHeaderVersion: 1003\n\tFBXVersion: 7500\n}\n"
         "GlobalSettings:  {\n\tVersion: 1000\n\tProperties70:  {\n" +
         unit +
         "\t}\n}\nDefinitions:  {\n\tVersion: 100\n\tCount: 2\n\tObjectType: \"Geometry\" {\n\t\tCount: 1\n\t}\n"
         "\tObjectType: \"Model\" {\n\t\tCount: 1\n\t}\n}\nObjects:  {\n"
         "\tGeometry: 1001, \"Geometry::\", \"Mesh\" {\n\t\tVertices: *12 {\n\t\t\ta: -1,-1,0,1,-1,0,1,1,0,-1,1,0\n\t\t}\n"
         "\t\tPolygonVertexIndex: *4 {\n\t\t\ta: 0,1,2,-4\n\t\t}\n\t\tGeometryVersion: 124\n\t}\n"
         "\tModel: 1002, \"Model::square\", \"Mesh\" {\n\t\tVersion: 232\n\t}\n}\n"
         "Connections:  {\n\tC: \"OO\", 1002, 0\n\tC: \"OO\", 1001, 1002\n}\n";
}

/// A triangle with sides of 2 along x and y from the corner `x`, in units of so many metres.
std::string dae(const std::string& metres, int x) {
  const auto at = [&](int i) { return std::to_string(x + i); };
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>)"
         R"(<unit name="u" meter=")" +
         metres +
         R"("/><up_axis>Y_UP</up_axis></asset><library_geometries><geometry id="g" name="g"><mesh><source id="p">)"
         R"(<float_array id="a" count="9">)" +
         at(0) + " 0 0 " + at(2) + " 0 0 " + at(2) + " 2 0" +
         R"(</float_array><technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/>)"
         R"(<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>)"
         R"(<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="1">)"
         R"(<input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>)"
         R"(<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene>)"
         R"(</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

double width_of(const Scene& scene) {
  float low = 0.0F, high = 0.0F;
  for (const Vec3& v : scene.vertices) low = std::min(low, v.x), high = std::max(high, v.x);
  return static_cast<double>(high - low);
}

class UnitsTest : public testing::Test {
 protected:
  Scene load_text(const std::string& name, const std::string& text) {
    write_text(folder_ / name, text);
    return load_scene(folder_ / name);
  }
  ScratchFolder folder_;
};

TEST_F(UnitsTest, FbxStatesCentimetres) {
  EXPECT_NEAR(width_of(load_text("m.fbx", fbx("1"))), 0.02, 1e-8);
  EXPECT_NEAR(width_of(load_text("m.fbx", fbx("100"))), 2.0, 1e-6);
  EXPECT_NEAR(width_of(load_text("m.fbx", fbx("2.54"))), 0.0508, 1e-8);
  EXPECT_NEAR(width_of(load_text("m.fbx", fbx(""))), 0.02, 1e-8);  // FBX: centimetres where none is stated
}

TEST_F(UnitsTest, ColladaStatesMetres) {
  EXPECT_NEAR(width_of(load_text("m.dae", dae("1", 0))), 2.0, 1e-6);
  EXPECT_NEAR(width_of(load_text("m.dae", dae("0.01", 0))), 0.02, 1e-8);
}

TEST_F(UnitsTest, SinglePrecisionIsNamedWhereEdgesSuffer) {
  // Steps of single precision at 2^20 are 1/8, against edges of 2 a sixteenth; at 2^12 they are 1/4000.
  EXPECT_THAT(load_text("m.dae", dae("1", 1 << 20)).warnings, Contains(HasSubstr("single precision")));
  EXPECT_THAT(load_text("m.dae", dae("0.001", 1 << 20)).warnings, Contains(HasSubstr("single precision")));
  EXPECT_THAT(load_text("m.dae", dae("1", 1 << 12)).warnings, Not(Contains(HasSubstr("single precision"))));
}

}  // namespace
}  // namespace gibench::test
