/// Small glTF documents made by tests, with their buffers, pictures and binary form.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

#include "tests/common/scene_io/scene_text.h"
#include "tests/support/scratch_folder.h"

namespace gibench::test {

template <class T>
constexpr int component_type() {
  if constexpr (std::is_same_v<T, std::int8_t>) return 5120;
  if constexpr (std::is_same_v<T, std::uint8_t>) return 5121;
  if constexpr (std::is_same_v<T, std::int16_t>) return 5122;
  if constexpr (std::is_same_v<T, std::uint16_t>) return 5123;
  if constexpr (std::is_same_v<T, std::uint32_t>) return 5125;
  if constexpr (std::is_same_v<T, float>) return 5126;
}

/// A document and the bytes of its only buffer.
struct GltfBuilder {
  nlohmann::json document;
  std::string buffer;

  /// The index of a new bufferView of these bytes.
  std::size_t view(const std::string& bytes) {
    buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
    document["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}});
    buffer += bytes;
    document["buffers"] = {{{"byteLength", buffer.size()}}};
    return document["bufferViews"].size() - 1;
  }
  template <class T>
  std::size_t view(const std::vector<T>& values) {
    return view(std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)));
  }
  /// The index of a new accessor of rows of `size` numbers, 1 to 4.
  template <class T>
  std::size_t accessor(const std::vector<T>& values, std::size_t size) {
    const char* const types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
    document["accessors"].push_back({{"bufferView", view(values)},
                                     {"componentType", component_type<T>()},
                                     {"count", values.size() / size},
                                     {"type", types[size - 1]}});
    return document["accessors"].size() - 1;
  }
  nlohmann::json& primitive() { return document["meshes"][0]["primitives"][0]; }
  nlohmann::json& material() { return document["materials"][0]; }

  void write(const std::filesystem::path& file) {
    const std::string name = file.stem().string() + ".bin";
    write_text(file.parent_path() / name, buffer);
    document["buffers"][0]["uri"] = name;
    write_text(file, document.dump());
  }
};

/// The square [-1, 1]² in the plane z = 0 with its front towards +z, of one material; coordinates of pictures cover the whole
/// picture, with their origin at the square's upper left corner.
inline GltfBuilder square() {
  GltfBuilder made;
  made.document = nlohmann::json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "materials": [{"name": "m", "pbrMetallicRoughness": {"metallicFactor": 0}}],
    "meshes": [{"primitives": [{"material": 0}]}]})");
  const std::size_t positions = made.accessor(std::vector<float>{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, 3);
  const std::size_t coordinates = made.accessor(std::vector<float>{0, 1, 1, 1, 1, 0, 0, 0}, 2);
  made.primitive()["attributes"] = {{"POSITION", positions}, {"TEXCOORD_0", coordinates}};
  made.primitive()["indices"] = made.accessor(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, 1);
  return made;
}

inline void append_chunk(std::string& file, const char* type, std::string bytes, char padding) {
  bytes.resize((bytes.size() + 3) / 4 * 4, padding);
  const auto length = static_cast<std::uint32_t>(bytes.size());
  file.append(reinterpret_cast<const char*>(&length), sizeof length).append(type, 4).append(bytes);
}

/// The binary form of a document.
inline std::string glb(const nlohmann::json& document, const std::string& buffer) {
  std::string chunks;
  append_chunk(chunks, "JSON", document.dump(), ' ');
  append_chunk(chunks, "BIN\0", buffer, '\0');
  const std::uint32_t header[] = {2, static_cast<std::uint32_t>(chunks.size() + 12)};
  return "glTF" + std::string(reinterpret_cast<const char*>(header), sizeof header) + chunks;
}

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Tests that load documents from a folder of their own.
class GltfTest : public testing::Test {
 protected:
  Scene load_document(GltfBuilder made) {
    made.write(folder_ / "m.gltf");
    return load_scene(folder_ / "m.gltf");
  }
  std::string error_of_document(GltfBuilder made) {
    made.write(folder_ / "m.gltf");
    return error_of([&] { load_scene(folder_ / "m.gltf"); });
  }
  ScratchFolder folder_;
};

}  // namespace gibench::test
