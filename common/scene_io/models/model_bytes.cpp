#include "common/scene_io/models/model_bytes.h"

#include <cstring>
#include <type_traits>
#include <utility>

#include "common/core/error.h"

namespace gibench {

namespace {

[[noreturn]] void damaged() { throw WorkError("the bytes are no model"); }

class Writer {
 public:
  void raw(const void* from, std::size_t count) { bytes_.append(static_cast<const char*>(from), count); }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  void raw(void* to, std::size_t count) {
    if (count > rest_.size()) damaged();
    if (count > 0) std::memcpy(to, rest_.data(), count);
    rest_.remove_prefix(count);
  }
  std::size_t left() const { return rest_.size(); }

 private:
  std::string_view rest_;
};

template <class Way>
constexpr bool reads = std::is_same_v<Way, Reader>;

// pass(way, value, …) writes or reads, so that both ways have one description. Structures are taken apart by bindings, which do
// not compile where a member is forgotten.

template <class Way, class Value>
requires(std::is_trivially_copyable_v<Value> && !std::is_enum_v<Value> && !std::is_same_v<Value, bool>) void pass(Way& way,
                                                                                                                  Value& value) {
  way.raw(&value, sizeof value);
}

template <class Way>
void pass(Way& way, bool& value) {
  unsigned char byte = value ? 1 : 0;
  way.raw(&byte, 1);
  if constexpr (reads<Way>) value = byte != 0;
}

template <class Way>
void pass(Way& way, Bsdf& kind) {
  auto number = static_cast<unsigned>(kind);
  way.raw(&number, sizeof number);
  if constexpr (reads<Way>) {
    if (number > static_cast<unsigned>(Bsdf::mirror)) damaged();
    kind = static_cast<Bsdf>(number);
  }
}

template <class Way, class List>
std::size_t pass_size(Way& way, List& list) {
  std::size_t size = list.size();
  way.raw(&size, sizeof size);
  if constexpr (reads<Way>) {
    using Item = typename List::value_type;
    constexpr std::size_t least = std::is_trivially_copyable_v<Item> ? sizeof(Item) : sizeof size;  // bytes of an item
    if (size > way.left() / least) damaged();
    list.resize(size);
  }
  return size;
}

template <class Way>
void pass(Way& way, std::string& text) {
  const std::size_t size = pass_size(way, text);
  way.raw(text.data(), size);
}

template <class Way, class Item>
void pass(Way& way, std::vector<Item>& list);

template <class Way, class First, class Second, class... Rest>
void pass(Way& way, First& first, Second& second, Rest&... rest) {
  pass(way, first);
  pass(way, second);
  (pass(way, rest), ...);
}

template <class Way>
void pass(Way& way, EnvironmentLight& light) {
  auto& [radiance, image, rotation] = light;
  GIBENCH_CHECK(!image, "a model file has no image as surroundings");
  pass(way, radiance, rotation);
}

template <class Way>
void pass(Way& way, Light& light) {
  std::size_t kind = light.index();
  way.raw(&kind, sizeof kind);
  if constexpr (reads<Way>) {
    if (kind >= std::variant_size_v<Light>) damaged();
    const auto make = [&]<std::size_t... kinds>(std::index_sequence<kinds...>) {
      ((kind == kinds ? static_cast<void>(light.emplace<kinds>()) : static_cast<void>(0)), ...);
    };
    make(std::make_index_sequence<std::variant_size_v<Light>>());
  }
  std::visit([&](auto& one) { pass(way, one); }, light);
}

template <class Way>
void pass(Way& way, Material& material) {
  auto& [name, bsdf, diffuse, specular, exponent, roughness, f0, reflectance, emission] = material;
  pass(way, name, bsdf, diffuse, specular, exponent, roughness, f0, reflectance, emission);
}

template <class Way>
void pass(Way& way, Camera& camera) {
  auto& [name, position, look_at, up, vertical_fov_degrees, width, height] = camera;
  pass(way, name, position, look_at, up, vertical_fov_degrees, width, height);
}

template <class Way>
void pass(Way& way, ModelPart& part) {
  auto& [name, material, geometry] = part;
  auto& [vertices, faces] = geometry;
  pass(way, name, material, vertices, faces);
}

template <class Way>
void pass(Way& way, ModelMaterial& made) {
  auto& [material, two_sided] = made;
  pass(way, material, two_sided);
}

template <class Way>
void pass(Way& way, ModelLight& made) {
  auto& [light, position] = made;
  pass(way, light, position);
}

template <class Way>
void pass(Way& way, ModelCamera& made) {
  auto& [camera, position, look_at] = made;
  pass(way, camera, position, look_at);
}

template <class Way>
void pass(Way& way, Model& model) {
  auto& [parts, materials, lights, cameras, warnings] = model;
  pass(way, parts, materials, lights, cameras, warnings);
}

template <class Way, class Item>
void pass(Way& way, std::vector<Item>& list) {
  const std::size_t size = pass_size(way, list);
  if constexpr (std::is_trivially_copyable_v<Item>) way.raw(list.data(), size * sizeof(Item));
  else
    for (Item& item : list) pass(way, item);
}

void check_indices(const Model& model) {
  for (const ModelPart& part : model.parts) {
    if (part.material >= model.materials.size()) damaged();
    for (const Face& face : part.geometry.faces)
      for (const std::uint32_t corner : face.corners)
        if (corner >= part.geometry.vertices.size()) damaged();
  }
}

}  // namespace

std::string bytes_of(const Model& model) {
  Writer writer;
  // The description serves both ways, and reading needs what can be changed; writing changes nothing.
  pass(writer, const_cast<Model&>(model));
  return writer.take();
}

Model model_of_bytes(std::string_view bytes) {
  Reader reader(bytes);
  Model model;
  pass(reader, model);
  if (reader.left() > 0) damaged();
  check_indices(model);
  return model;
}

}  // namespace gibench
