/// The colonnade of statues: two rows of columns joined by arches, figures on pedestals between them, sun and sky.
#pragma once

#include <cstddef>
#include <filesystem>

namespace gibench::generators {

/// Writes colonnade.scene.json and its models into `folder`, which is made where missing. Returns the number of
/// triangles of the scene, about 320 000. Throws InputError where a file cannot be written.
std::size_t write_colonnade(const std::filesystem::path& folder);

}  // namespace gibench::generators
