/// A reading hall with thousands of books by day: windows and a skylight, lamps, chairs, statues.
#pragma once

#include <cstddef>
#include <filesystem>

namespace gibench::generators {

/// Writes library.scene.json and its models into `folder`, which is made where missing. Returns the number of triangles of
/// the scene, about 500 000. Throws InputError where a file cannot be written.
std::size_t write_library(const std::filesystem::path& folder);

}  // namespace gibench::generators
