#include "scenes/generators/mesh.h"

#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <assimp/Exporter.hpp>
#include <cmath>

#include "common/core/error.h"

namespace gibench::generators {

std::size_t Mesh::triangle_count() const {
  std::size_t count = 0;
  for (const auto& face : faces) count += face[3] == face[2] ? 1U : 2U;
  return count;
}

void Mesh::append(const Mesh& other) {
  const auto first = static_cast<std::uint32_t>(vertices.size());
  vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
  for (std::array<std::uint32_t, 4> face : other.faces) {
    for (std::uint32_t& corner : face) corner += first;
    faces.push_back(face);
  }
}

Mesh closed_grid(int rows, int columns, const std::function<Vec3d(double, double)>& point) {
  GIBENCH_CHECK(rows >= 2 && columns >= 3, "a closed grid has two rows and three columns at least");
  Mesh mesh;
  mesh.vertices.push_back(point(0.0, 0.0));
  for (int row = 1; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      mesh.vertices.push_back(point(static_cast<double>(row) / rows, 2.0 * pi_double * column / columns));
  mesh.vertices.push_back(point(1.0, 0.0));
  const auto top = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  const auto at = [&](int ring, int column) { return static_cast<std::uint32_t>(1 + ring * columns + column % columns); };
  for (int column = 0; column < columns; ++column) mesh.faces.push_back({0, at(0, column + 1), at(0, column), at(0, column)});
  for (int ring = 0; ring + 2 < rows; ++ring)
    for (int column = 0; column < columns; ++column)
      mesh.faces.push_back({at(ring, column), at(ring, column + 1), at(ring + 1, column + 1), at(ring + 1, column)});
  for (int column = 0; column < columns; ++column)
    mesh.faces.push_back({at(rows - 2, column), at(rows - 2, column + 1), top, top});
  return mesh;
}

Mesh block(const Vec3d& low, const Vec3d& high) {
  Mesh mesh;
  for (unsigned i = 0; i < 8; ++i)
    mesh.vertices.push_back({(i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y, (i & 4U) != 0 ? high.z : low.z});
  mesh.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return mesh;
}

Mesh frame(const Vec3d& inner, const Vec3d& outer) {
  constexpr std::array<std::array<double, 2>, 4> turns{{{1, 1}, {1, -1}, {-1, -1}, {-1, 1}}};  // counter-clockwise from above
  Mesh mesh;
  for (const Vec3d& size : {inner, outer})
    for (const auto& [x, z] : turns) mesh.vertices.push_back({x * size.x, size.y, z * size.z});
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t next = (i + 1) % 4;
    mesh.faces.push_back({4 + i, 4 + next, next, i});
  }
  return mesh;
}

Mesh arch(double inner_radius, double outer_radius, double depth, int segments) {
  Mesh mesh;
  for (int i = 0; i <= segments; ++i) {
    const double angle = pi_double * i / segments;
    const double x = std::cos(angle), y = std::sin(angle);
    for (const double radius : {inner_radius, outer_radius})
      for (const double z : {-0.5 * depth, 0.5 * depth}) mesh.vertices.push_back({radius * x, radius * y, z});
  }
  // Each station has four corners: 0 inner back, 1 inner front, 2 outer back, 3 outer front.
  const auto at = [](int station, unsigned corner) { return static_cast<std::uint32_t>(4 * station) + corner; };
  for (int i = 0; i < segments; ++i) {
    mesh.faces.push_back({at(i, 0), at(i, 1), at(i + 1, 1), at(i + 1, 0)});
    mesh.faces.push_back({at(i, 1), at(i, 3), at(i + 1, 3), at(i + 1, 1)});
    mesh.faces.push_back({at(i, 3), at(i, 2), at(i + 1, 2), at(i + 1, 3)});
    mesh.faces.push_back({at(i, 2), at(i, 0), at(i + 1, 0), at(i + 1, 2)});
  }
  mesh.faces.push_back({at(0, 0), at(0, 2), at(0, 3), at(0, 1)});
  mesh.faces.push_back({at(segments, 0), at(segments, 1), at(segments, 3), at(segments, 2)});
  return mesh;
}

void write_ply(const Mesh& mesh, const std::filesystem::path& file) {
  aiScene scene;  // owns everything below
  scene.mRootNode = new aiNode();
  scene.mMaterials = new aiMaterial* [1] { new aiMaterial() };
  scene.mNumMaterials = 1;
  scene.mMeshes = new aiMesh* [1] { new aiMesh() };
  scene.mNumMeshes = 1;
  scene.mRootNode->mMeshes = new unsigned[1]{0};
  scene.mRootNode->mNumMeshes = 1;
  aiMesh& out = *scene.mMeshes[0];
  out.mPrimitiveTypes = aiPrimitiveType_TRIANGLE | aiPrimitiveType_POLYGON;
  out.mNumVertices = static_cast<unsigned>(mesh.vertices.size());
  out.mVertices = new aiVector3D[mesh.vertices.size()];
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3d& v = mesh.vertices[i];
    out.mVertices[i] = aiVector3D(static_cast<ai_real>(v.x), static_cast<ai_real>(v.y), static_cast<ai_real>(v.z));
  }
  out.mNumFaces = static_cast<unsigned>(mesh.faces.size());
  out.mFaces = new aiFace[mesh.faces.size()];
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    aiFace& face = out.mFaces[i];
    face.mNumIndices = mesh.faces[i][3] == mesh.faces[i][2] ? 3 : 4;
    face.mIndices = new unsigned[face.mNumIndices];
    for (unsigned corner = 0; corner < face.mNumIndices; ++corner) face.mIndices[corner] = mesh.faces[i][corner];
  }
  Assimp::Exporter exporter;
  if (exporter.Export(&scene, "plyb", file.string()) != aiReturn_SUCCESS)
    throw InputError(file.string(), std::string("cannot be written: ") + exporter.GetErrorString(),
                     "name a folder that can be written");
}

}  // namespace gibench::generators
