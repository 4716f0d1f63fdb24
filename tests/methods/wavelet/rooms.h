/// Small scenes for the tests of the wavelet method, and what is made of them.
#pragma once

#include <utility>
#include <vector>

#include "common/scene/made_scenes.h"
#include "methods/wavelet/precomputation.h"
#include "methods/wavelet/transform.h"

namespace gibench::test {

inline wavelet::Settings wavelet_settings(std::vector<std::pair<std::string, std::string>> settings = {}) {
  return wavelet::settings_from(Parameters(wavelet::settings_schema(), std::move(settings)));
}

/// A floor, a wall that touches it along an edge, a triangle and a sheet between them that both sides of reflect.
inline Scene open_corner() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.6F));
  builder.quad("floor", white, {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}});
  builder.quad("wall", white, {{{0, 0, 0}, {1, 0, 0}, {1.2F, 1, 0}, {0, 0.8F, 0}}});
  builder.object("roof", white, {{0, 1.1F, 0}, {1, 1.2F, 0}, {0.4F, 1.1F, 1}}, {{0, 1, 2, 2}});
  builder.quad("sheet", white, {{{0.3F, 0.4F, 0.3F}, {0.3F, 0.5F, 0.8F}, {0.8F, 0.5F, 0.8F}, {0.8F, 0.4F, 0.3F}}}, true);
  return builder.build("open corner");
}

/// A closed room that glows all over.
inline Scene furnace(float albedo) {
  made::SceneBuilder builder;
  builder.room("room", builder.diffuse("glowing", Rgb(albedo), Rgb(1.0F)), Vec3(0.0F), Vec3(1.0F, 1.5F, 2.0F));
  return builder.build("furnace");
}

}  // namespace gibench::test
