/// Files written whole or not at all: the bytes go to a file beside, which is then renamed, so that a full disk or
/// a killed run leaves the old file or none, never half a file.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace gibench {

/// Writes or replaces `file`, through links what they lead to. Bytes for a pipe or a character device (/dev/null, a terminal) are
/// written into it, which stays what it is. If that fails nothing has changed, and it throws with the system's reason: WorkError
/// for a full disk, InputError for anything else.
void write_file_atomically(const std::filesystem::path& file, std::span<const char> bytes);

/// What a link leads to, through every link on the way and whether it exists or not; `path` itself where it is no link. Throws
/// InputError for a circle of links.
std::filesystem::path followed(std::filesystem::path path);

/// A name beside `path` that no other process or call uses: hidden, and the same file system.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

/// All bytes of a file. InputError if it is missing or unreadable.
std::string read_file(const std::filesystem::path& file);

}  // namespace gibench
