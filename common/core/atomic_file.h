/// Files written whole or not at all: the bytes go to a file beside, which is then renamed, so that a full disk or
/// a killed run leaves the old file or none, never half a file.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace gibench {

/// Writes or replaces `file`. InputError with the system's reason if that fails; then nothing has changed.
void write_file_atomically(const std::filesystem::path& file, std::span<const char> bytes);

/// A name beside `path` that no other process or call uses: hidden, and the same file system.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

/// All bytes of a file. InputError if it is missing or unreadable.
std::string read_file(const std::filesystem::path& file);

}  // namespace gibench
