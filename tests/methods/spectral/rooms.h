/// A scene with everything that transfer is made of, for the tests of its parts.
#pragma once

#include <utility>
#include <vector>

#include "common/scene/made_scenes.h"
#include "methods/spectral/relighting.h"
#include "methods/spectral/transfer_making.h"
#include "methods/spectral/transfer_rows.h"

namespace gibench::test {

inline spectral::Settings spectral_settings(std::vector<std::pair<std::string, std::string>> settings = {}) {
  return spectral::settings_from(Parameters(spectral::settings_schema(), std::move(settings)));
}

/// A closed room one surface of which glows, with a block in it.
inline Scene closed_room() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.6F));
  builder.room("room", white, Vec3(0.0F), Vec3(1.0F, 1.5F, 2.0F));
  builder.block("block", white, {0.3F, 0.2F, 0.3F}, {0.6F, 0.5F, 0.9F}, 20.0F);
  return builder.build("closed room");
}

/// Mesh, basis and matrices of a scene, and what is needed to ask them again.
struct SpectralRoom {
  World world;
  spectral::Settings settings;
  Task task;
  spectral::TransferMaking made;

  SpectralRoom(Scene scene, std::vector<std::pair<std::string, std::string>> chosen, spectral::TransferWish wish = {})
      : world(std::move(scene), 1), settings(spectral_settings(std::move(chosen))) {
    made = spectral::make_transfer(world, settings, wish, task);
  }
  const spectral::Transfer& transfer() const { return made.transfer; }
  std::uint32_t slots() const { return transfer().basis.slots(); }
  spectral::VertexRays rays() const { return spectral::rays_of(world, transfer(), settings.rays, task.seed()); }
};

}  // namespace gibench::test
