/// The domains of errors: where they are taken.
#pragma once

#include <array>

namespace gibench {

/// The surface samples, or the pixels of a camera.
enum class Domain {
  image,    ///< radiance in the camera's image, W/(m² sr)
  surface,  ///< irradiance at the surface samples, W/m²
};

inline constexpr std::array all_domains{Domain::image, Domain::surface};

/// As records name it.
constexpr const char* to_string(Domain domain) { return domain == Domain::image ? "image" : "surface"; }

}  // namespace gibench
