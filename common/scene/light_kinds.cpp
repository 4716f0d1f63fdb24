#include "common/scene/light_kinds.h"

#include <utility>

namespace gibench {

namespace {

// One block a kind: what it is, and what it is made of.
template <class Alternative>
struct Kind;

template <>
struct Kind<PointLight> {
  static constexpr LightKind facts{.name = "point", .at_infinity = false, .background = false};
  template <class Parts>
  static Parts parts(auto& light) {
    return {.strength = &light.intensity, .position = &light.position};
  }
};

template <>
struct Kind<SpotLight> {
  static constexpr LightKind facts{.name = "spot", .at_infinity = false, .background = false};
  template <class Parts>
  static Parts parts(auto& light) {
    return {.strength = &light.intensity, .position = &light.position, .direction = &light.direction};
  }
};

template <>
struct Kind<DirectionalLight> {
  static constexpr LightKind facts{.name = "directional", .at_infinity = true, .background = false};
  template <class Parts>
  static Parts parts(auto& light) {
    return {.strength = &light.irradiance, .direction = &light.direction};
  }
};

template <>
struct Kind<EnvironmentLight> {
  static constexpr LightKind facts{.name = "environment", .at_infinity = true, .background = true};
  template <class Parts>
  static Parts parts(auto& light) {
    return {.strength = &light.radiance, .image = light.image.get()};
  }
};

template <class>
struct Alternatives;
template <class... Alternative>
struct Alternatives<std::variant<Alternative...>> {
  static constexpr std::array<LightKind, sizeof...(Alternative)> kinds{Kind<Alternative>::facts...};

  static std::optional<Light> of_kind(std::string_view name) {
    std::optional<Light> light;
    ((name == Kind<Alternative>::facts.name ? void(light = Alternative{}) : void()), ...);
    return light;
  }
};

template <class AnyLight>
LightParts<AnyLight> parts(AnyLight& light) {
  return std::visit([](auto& one) { return Kind<std::remove_cvref_t<decltype(one)>>::template parts<LightParts<AnyLight>>(one); },
                    light);
}

}  // namespace

const std::array<LightKind, std::variant_size_v<Light>>& light_kinds() { return Alternatives<Light>::kinds; }

const LightKind& kind_of(const Light& light) { return light_kinds()[light.index()]; }

std::optional<Light> light_of_kind(std::string_view name) { return Alternatives<Light>::of_kind(name); }

LightParts<Light> parts_of(Light& light) { return parts(light); }
LightParts<const Light> parts_of(const Light& light) { return parts(light); }

}  // namespace gibench
