#include <assimp/postprocess.h>

#include <array>
#include <cstring>
#include <unordered_map>

#include "common/core/error.h"
#include "common/core/hash.h"
#include "common/scene/model_scene.h"
#include "common/scene/names.h"

namespace gibench {

namespace {

struct Bits {
  std::array<float, 3> position;
  bool operator==(const Bits& other) const { return std::memcmp(&position, &other.position, sizeof position) == 0; }
};
struct HashOfBits {
  std::size_t operator()(const Bits& bits) const { return hash_bytes(&bits.position, sizeof bits.position); }
};

std::size_t corner_count(const aiMesh& mesh) {
  std::size_t corners = 0;
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) corners += mesh.mFaces[i].mNumIndices;
  return corners;
}

/// The mesh's vertices, and for each of Assimp's the index of the one it became: OBJ and STL come with one vertex a
/// corner and are joined by equal positions.
std::vector<std::uint32_t> read_vertices(const aiMesh& mesh, std::vector<Vec3d>& vertices) {
  std::vector<std::uint32_t> index_of(mesh.mNumVertices);
  const bool is_indexed = mesh.mNumVertices != corner_count(mesh);
  std::unordered_map<Bits, std::uint32_t, HashOfBits> known;
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D& v = mesh.mVertices[i];
    index_of[i] = static_cast<std::uint32_t>(vertices.size());
    if (!is_indexed) {
      const Bits bits{{v.x + 0.0F, v.y + 0.0F, v.z + 0.0F}};  // -0 becomes 0
      const auto [place, is_new] = known.try_emplace(bits, index_of[i]);
      index_of[i] = place->second;
      if (!is_new) continue;
    }
    vertices.push_back(to_vec(v));
  }
  return index_of;
}

/// Adds the mesh's triangles and quads; counts what has fewer corners, and the triangles that larger polygons make.
struct FaceCounts {
  std::size_t points_and_lines = 0, triangles_of_polygons = 0;
};
FaceCounts add_small_faces(const aiMesh& mesh, const std::vector<std::uint32_t>& index_of, ObjectGeometry& geometry,
                           const std::string& place) {
  FaceCounts counts;
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    const auto name = [&] { return "face " + std::to_string(f) + " of mesh " + in_quotes(mesh.mName.C_Str()); };
    if (face.mNumIndices == 0)
      throw InputError(place, name() + " has no corners", "the file is damaged or cut short; export it again");
    for (unsigned i = 0; i < face.mNumIndices; ++i)
      if (face.mIndices[i] >= mesh.mNumVertices)
        throw InputError(place,
                         name() + " has vertex index " + std::to_string(face.mIndices[i]) + ", and there are " +
                             std::to_string(mesh.mNumVertices) + " vertices",
                         "mend the index or export the file again");
    if (face.mNumIndices < 3) ++counts.points_and_lines;
    if (face.mNumIndices > 4) counts.triangles_of_polygons += face.mNumIndices - 2;
    if (face.mNumIndices != 3 && face.mNumIndices != 4) continue;
    Face added;
    for (unsigned i = 0; i < 4; ++i) added.corners[i] = index_of[face.mIndices[std::min(i, face.mNumIndices - 1)]];
    geometry.faces.push_back(added);
  }
  return counts;
}

/// Leaves only the faces of more than four corners in a mesh.
void keep_polygons(aiMesh& mesh) {
  std::vector<aiFace> polygons;
  for (unsigned f = 0; f < mesh.mNumFaces; ++f)
    if (mesh.mFaces[f].mNumIndices > 4) polygons.push_back(mesh.mFaces[f]);
  delete[] mesh.mFaces;
  mesh.mFaces = new aiFace[polygons.size()];
  std::copy(polygons.begin(), polygons.end(), mesh.mFaces);
  mesh.mNumFaces = static_cast<unsigned>(polygons.size());
  mesh.mPrimitiveTypes = polygons.empty() ? 0 : aiPrimitiveType_POLYGON;
}

}  // namespace

std::vector<ObjectGeometry> read_meshes(Assimp::Importer& importer, const std::string& place,
                                        std::vector<std::string>& warnings) {
  const aiScene& scene = *importer.GetScene();
  std::vector<ObjectGeometry> meshes(scene.mNumMeshes);
  std::vector<std::vector<std::uint32_t>> index_of(scene.mNumMeshes);
  std::vector<std::size_t> expected(scene.mNumMeshes, 0);  // triangles of polygons
  std::size_t points_and_lines = 0, polygon_triangles = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    index_of[m] = read_vertices(*scene.mMeshes[m], meshes[m].vertices);
    const FaceCounts counts = add_small_faces(*scene.mMeshes[m], index_of[m], meshes[m], place);
    points_and_lines += counts.points_and_lines;
    polygon_triangles += expected[m] = counts.triangles_of_polygons;
  }
  if (points_and_lines > 0) warnings.push_back(std::to_string(points_and_lines) + " points and lines are left out");
  if (polygon_triangles == 0) return meshes;

  for (unsigned m = 0; m < scene.mNumMeshes; ++m) keep_polygons(*scene.mMeshes[m]);
  importer.ApplyPostProcessing(aiProcess_Triangulate);
  std::size_t lost = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    if (expected[m] == 0) continue;
    add_small_faces(*scene.mMeshes[m], index_of[m], meshes[m], place);
    lost += expected[m] - std::min<std::size_t>(expected[m], scene.mMeshes[m]->mNumFaces);
  }
  if (lost > 0) warnings.push_back(std::to_string(lost) + " triangles of crossed polygons could not be made and are left out");
  return meshes;
}

}  // namespace gibench
