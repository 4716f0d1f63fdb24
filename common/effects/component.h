/// The parts of the light at a surface that are told apart.
#pragma once

#include <array>

namespace gibench {

/// Light straight from the lights (no reflection before the surface asked about, its own emission included where the
/// quantity leaves it), the rest, or both.
enum class Component { direct, indirect, total };

inline constexpr std::array all_components{Component::direct, Component::indirect, Component::total};

/// As files and options name it.
constexpr const char* to_string(Component component) {
  switch (component) {
    case Component::direct: return "direct";
    case Component::indirect: return "indirect";
    case Component::total: break;
  }
  return "total";
}

}  // namespace gibench
