#include "common/scene_io/gltf/document.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/core/names.h"
#include "common/scene_io/gltf/extensions.h"
#include "common/scene_io/gltf/uri.h"

namespace gibench {

namespace {

constexpr std::size_t header_bytes = 12, chunk_header_bytes = 8;
constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
constexpr const char* copy_again = "it is cut short or damaged; copy or export it again";

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

std::string bytes_text(std::size_t count) { return std::to_string(count) + " bytes"; }

/// What nlohmann says of a fault, in one line and without the code of its class.
std::string short_reason(const nlohmann::json::exception& error) {
  std::string text = error.what();
  if (const auto end = text.find("] "); end != std::string::npos) text.erase(0, end + 2);
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20; }, ' ');
  return text;
}

}  // namespace

GltfDocument::GltfDocument(const std::filesystem::path& file, const std::string& place)
    : source_{file, place}, file_bytes_(read_file(file)) {
  const std::string_view text = file_bytes_.starts_with("glTF") ? json_of_binary() : std::string_view(file_bytes_);
  try {
    json_ = std::make_unique<nlohmann::json>(nlohmann::json::parse(text));
  } catch (const nlohmann::json::exception& error) {
    source_.refuse("its JSON", "is broken: " + short_reason(error), copy_again);
  }
  if (!binary_chunk_) file_bytes_.clear();
  if (!json_->is_object()) source_.refuse("its JSON", "is not an object");
  check_version();
  check_required_extensions();
  buffers_.resize(count("buffers"));
}

GltfDocument::~GltfDocument() = default;

/// The chunks of a GLB (glTF 2.0, 4.4): the first is returned, the second noted.
std::string_view GltfDocument::json_of_binary() {
  const std::string& bytes = file_bytes_;
  if (bytes.size() < header_bytes + chunk_header_bytes)
    source_.refuse("its header", "has " + bytes_text(bytes.size()) + ", too few for a GLB", copy_again);
  if (const std::uint32_t version = number_at(bytes, 4); version != 2)
    source_.refuse("its header", "says version " + std::to_string(version) + ", and only glTF 2 is read",
                   "export it as glTF 2.0");
  const std::size_t end = number_at(bytes, 8);
  if (end > bytes.size())
    source_.refuse("its header", "announces " + bytes_text(end) + " and the file has " + std::to_string(bytes.size()),
                   copy_again);
  std::string_view text;
  for (std::size_t at = header_bytes; at + chunk_header_bytes <= end;) {
    const bool is_first = at == header_bytes;
    const std::size_t length = number_at(bytes, at);
    const std::uint32_t type = number_at(bytes, at + 4);
    at += chunk_header_bytes;
    if (length > end - at)
      source_.refuse("the chunk at byte " + std::to_string(at),
                     "announces " + bytes_text(length) + " and " + std::to_string(end - at) + " follow", copy_again);
    const std::string_view chunk = std::string_view(bytes).substr(at, length);
    if (is_first && type != json_chunk) source_.refuse("its first chunk", "is not JSON", copy_again);
    if (is_first) text = chunk;
    if (!is_first && type == binary_chunk && !binary_chunk_) binary_chunk_ = chunk;
    at += length;
  }
  return text;
}

void GltfDocument::check_version() const {
  const GltfValue asset = root().at("asset");
  const std::string version = asset.text_or("minVersion", asset.at("version").text());
  if (version != "2.0")
    source_.refuse("asset", "says version " + in_quotes(version) + ", and only glTF 2.0 is read", "export it as glTF 2.0");
}

void GltfDocument::check_required_extensions() const {
  const auto required = root().find("extensionsRequired");
  for (std::size_t i = 0; required && i < required->size(); ++i) {
    const std::string name = required->at(i).text();
    if (!is_supported_gltf_extension(name))
      source_.refuse("extensionsRequired", "names " + name + ", which is not supported", "export it without " + name);
  }
}

GltfValue GltfDocument::root() const { return {*json_, source_, ""}; }

GltfValue GltfDocument::item(const char* list, std::size_t index) const {
  const auto all = root().find(list);
  if (!all || index >= all->size())
    source_.refuse(list, "has no element " + std::to_string(index) + ", only " + std::to_string(all ? all->size() : 0));
  return all->at(index);
}

std::size_t GltfDocument::count(const char* list) const {
  const auto all = root().find(list);
  return all ? all->size() : 0;
}

std::filesystem::path GltfDocument::path_of_uri(const std::string& uri) const {
  const std::filesystem::path folder = source_.file.parent_path();
  for (std::string name : {percent_decoded(uri), uri}) {
    std::error_code ignored;
    if (std::filesystem::exists(folder / name, ignored)) return folder / name;
    std::replace(name.begin(), name.end(), '\\', '/');  // as written on Windows
    if (std::filesystem::exists(folder / name, ignored)) return folder / name;
  }
  return folder / percent_decoded(uri);
}

void GltfDocument::load_buffer(const GltfValue& value, Buffer& buffer) const {
  const auto uri = value.find("uri");
  if (!uri) {
    if (&buffer != buffers_.data() || !binary_chunk_)
      value.refuse("has no \"uri\", and the file has no binary chunk for it", copy_again);
    buffer.bytes = *binary_chunk_;
    return;
  }
  const std::string text = uri->text();
  if (is_data_uri(text)) {
    auto data = data_of_uri(text);
    if (!data) uri->refuse("is a data: URI that is not base64", copy_again);
    buffer.owned = *std::move(data);
  } else if (is_remote_uri(text)) {
    uri->refuse("is " + in_quotes(text) + ", and only local files are read", "download it beside the model file");
  } else {
    try {
      buffer.owned = read_file(path_of_uri(text));
    } catch (const InputError& error) {
      uri->refuse("names a file that cannot be read (" + std::string(error.what()) + ")", "copy it beside the model file");
    }
  }
  buffer.bytes = buffer.owned;
}

std::string_view GltfDocument::buffer(std::size_t index) {
  const GltfValue value = item("buffers", index);
  Buffer& buffer = buffers_[index];
  if (buffer.is_loaded) return buffer.bytes;
  const std::size_t announced = value.at("byteLength").whole_number();
  load_buffer(value, buffer);
  if (buffer.bytes.size() < announced)
    value.refuse("announces " + bytes_text(announced) + " and there are " + std::to_string(buffer.bytes.size()), copy_again);
  buffer.bytes = buffer.bytes.substr(0, announced);  // a GLB's chunk is padded
  buffer.is_loaded = true;
  return buffer.bytes;
}

std::string_view GltfDocument::view_bytes(std::size_t view) {
  const GltfValue value = item("bufferViews", view);
  const std::string_view bytes = buffer(value.at("buffer").whole_number());
  const std::size_t offset = value.whole_number_or("byteOffset", 0), length = value.at("byteLength").whole_number();
  if (offset > bytes.size() || length > bytes.size() - offset)
    value.refuse("ends at byte " + std::to_string(offset + length) + " of a buffer of " + std::to_string(bytes.size()));
  return bytes.substr(offset, length);
}

}  // namespace gibench
