/// The events along a light path, from the camera: where it leaves, how it is scattered, where it ends.
#pragma once

#include <array>
#include <cstdint>

namespace gibench {

/// Scattering events are an event type (R reflection, T transmission) with a kind (D diffuse, G glossy, S singular: a
/// mirror). `light` is a light without a surface (point, spot, directional), `emitter` an emitting surface.
enum class PathEvent : std::uint8_t {
  camera,                ///< C
  diffuse_reflection,    ///< `<RD>`
  glossy_reflection,     ///< `<RG>`
  mirror_reflection,     ///< `<RS>`
  diffuse_transmission,  ///< `<TD>`
  glossy_transmission,   ///< `<TG>`
  mirror_transmission,   ///< `<TS>`
  light,                 ///< L
  emitter,               ///< O
  background,            ///< B
};
inline constexpr int path_event_count = 10;

/// A set of events, one bit each.
class PathEvents {
 public:
  constexpr PathEvents() = default;
  constexpr PathEvents(PathEvent event) : bits_(static_cast<std::uint16_t>(1U << static_cast<unsigned>(event))) {}

  constexpr bool contains(PathEvent event) const { return (bits_ >> static_cast<unsigned>(event) & 1U) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr PathEvents operator|(PathEvents other) const { return PathEvents(bits_ | other.bits_); }
  constexpr PathEvents operator&(PathEvents other) const { return PathEvents(bits_ & other.bits_); }
  constexpr PathEvents operator~() const { return PathEvents(~bits_ & ((1U << path_event_count) - 1U)); }
  PathEvents& operator|=(PathEvents other) { return *this = *this | other; }
  constexpr bool operator==(const PathEvents&) const = default;

 private:
  explicit constexpr PathEvents(unsigned bits) : bits_(static_cast<std::uint16_t>(bits)) {}
  std::uint16_t bits_ = 0;
};

inline constexpr PathEvents reflections =
    PathEvents(PathEvent::diffuse_reflection) | PathEvent::glossy_reflection | PathEvent::mirror_reflection;
inline constexpr PathEvents transmissions =
    PathEvents(PathEvent::diffuse_transmission) | PathEvent::glossy_transmission | PathEvent::mirror_transmission;
inline constexpr PathEvents light_ends = PathEvents(PathEvent::light) | PathEvent::emitter | PathEvent::background;
inline constexpr PathEvents every_event = ~PathEvents();

inline constexpr std::array<PathEvent, 6> scattering_events{PathEvent::diffuse_reflection,  PathEvent::glossy_reflection,
                                                            PathEvent::mirror_reflection,   PathEvent::diffuse_transmission,
                                                            PathEvent::glossy_transmission, PathEvent::mirror_transmission};
inline constexpr std::array<PathEvent, 3> ending_events{PathEvent::light, PathEvent::emitter, PathEvent::background};

}  // namespace gibench
