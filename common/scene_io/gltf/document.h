/// A glTF 2.0 document: its JSON, its buffers, and the bytes that its URIs stand for.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/scene_io/gltf/gltf_value.h"

namespace gibench {

/// A .gltf or .glb file (glTF 2.0 specification). Lengths and offsets are held against what is there before anything is
/// allocated for them.
class GltfDocument {
 public:
  /// Throws InputError at `place` where the file cannot be read, is cut short, is not glTF 2, or requires an extension
  /// that is not supported.
  GltfDocument(const std::filesystem::path& file, const std::string& place);
  ~GltfDocument();
  GltfDocument(const GltfDocument&) = delete;
  GltfDocument& operator=(const GltfDocument&) = delete;

  const std::filesystem::path& file() const { return source_.file; }
  GltfValue root() const;
  /// Element `index` of a list at the top ("meshes"), refused where there is none.
  GltfValue item(const char* list, std::size_t index) const;
  /// Elements of such a list; 0 where it is missing.
  std::size_t count(const char* list) const;

  /// The bytes of a bufferView. Loads its buffer at the first call.
  std::string_view view_bytes(std::size_t view);
  /// Where a URI that is no data: URI leads to; percent-encoded or, as some programs write it, not.
  std::filesystem::path path_of_uri(const std::string& uri) const;

 private:
  /// Bytes that were read from elsewhere, or those of the file's own binary chunk.
  struct Buffer {
    bool is_loaded = false;
    std::string owned;
    std::string_view bytes;
  };

  std::string_view json_of_binary();
  void check_version() const;
  void check_required_extensions() const;
  std::string_view buffer(std::size_t index);
  void load_buffer(const GltfValue& value, Buffer& buffer) const;

  GltfSource source_;
  std::unique_ptr<nlohmann::json> json_;
  std::string file_bytes_;  ///< of a GLB
  std::optional<std::string_view> binary_chunk_;
  std::vector<Buffer> buffers_;
};

}  // namespace gibench
