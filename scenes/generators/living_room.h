/// A furnished living room by day: sun and sky through one window, three lamps, books, crockery, plants.
#pragma once

#include <cstddef>
#include <filesystem>

namespace gibench::generators {

/// Writes living-room.scene.json and its models into `folder`, which is made where missing. Returns the number of triangles
/// of the scene, about 50 000. Throws InputError where a file cannot be written.
std::size_t write_living_room(const std::filesystem::path& folder);

}  // namespace gibench::generators
