#include "common/scene_io/assimp/model_meshes.h"

#include "common/core/error.h"
#include "common/core/names.h"
#include "common/scene/object_faces.h"
#include "common/scene_io/assimp/assimp_nodes.h"
#include "common/scene_io/model_parts/equal_positions.h"

namespace gibench {

namespace {

std::size_t corner_count(const aiMesh& mesh) {
  std::size_t corners = 0;
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) corners += mesh.mFaces[i].mNumIndices;
  return corners;
}

/// The mesh's vertices, and for each of Assimp's the index of the one it became: some
/// formats come with one vertex a corner and are joined by equal positions.
std::vector<std::uint32_t> read_vertices(const aiMesh& mesh, std::vector<Vec3d>& vertices) {
  std::vector<Vec3d> positions;
  positions.reserve(mesh.mNumVertices);
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) positions.push_back(to_vec(mesh.mVertices[i]));
  const auto before = static_cast<std::uint32_t>(vertices.size());
  std::vector<std::uint32_t> index_of(positions.size());
  if (mesh.mNumVertices != corner_count(mesh)) {
    for (std::uint32_t i = 0; i < index_of.size(); ++i) index_of[i] = before + i;
    vertices.insert(vertices.end(), positions.begin(), positions.end());
    return index_of;
  }
  const std::vector<std::uint32_t> first = first_of_equal(positions);
  for (std::uint32_t i = 0; i < index_of.size(); ++i) {
    const bool is_new = first[i] == i;
    index_of[i] = is_new ? static_cast<std::uint32_t>(vertices.size()) : index_of[first[i]];
    if (is_new) vertices.push_back(positions[i]);
  }
  return index_of;
}

void check_face(const aiMesh& mesh, unsigned f, const std::string& place) {
  const aiFace& face = mesh.mFaces[f];
  const auto name = [&] { return "face " + std::to_string(f) + " of mesh " + in_quotes(mesh.mName.C_Str()); };
  if (face.mNumIndices == 0)
    throw InputError(place, name() + " has no corners", "the file is damaged or cut short; export it again");
  if (face.mNumIndices > most_corners)
    throw InputError(place, name() + " has more than 10 000 corners", "divide it into smaller faces");
  for (unsigned i = 0; i < face.mNumIndices; ++i)
    if (face.mIndices[i] >= mesh.mNumVertices)
      throw InputError(place,
                       name() + " has vertex index " + std::to_string(face.mIndices[i]) + ", and there are " +
                           std::to_string(mesh.mNumVertices) + " vertices",
                       "correct the index or export the file again");
}

/// Adds the mesh's faces; returns the number of points and lines, which are left out.
std::size_t add_faces(const aiMesh& mesh, const std::vector<std::uint32_t>& index_of, ObjectGeometry& geometry,
                      const std::string& place) {
  std::size_t left_out = 0;
  std::vector<std::uint32_t> corners;
  geometry.faces.reserve(mesh.mNumFaces);
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    check_face(mesh, f, place);
    if (face.mNumIndices < 3) {
      ++left_out;
      continue;
    }
    corners.clear();
    for (unsigned i = 0; i < face.mNumIndices; ++i) corners.push_back(index_of[face.mIndices[i]]);
    add_face(corners, geometry);
  }
  return left_out;
}

}  // namespace

std::vector<ObjectGeometry> read_meshes(const aiScene& scene, const std::string& place, std::vector<std::string>& warnings) {
  std::vector<ObjectGeometry> meshes(scene.mNumMeshes);
  std::size_t left_out = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const std::vector<std::uint32_t> index_of = read_vertices(*scene.mMeshes[m], meshes[m].vertices);
    left_out += add_faces(*scene.mMeshes[m], index_of, meshes[m], place);
  }
  if (left_out > 0) warnings.push_back(std::to_string(left_out) + " points and lines are left out");
  return meshes;
}

}  // namespace gibench
