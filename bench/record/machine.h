/// Which program ran where: what a result needs to be understood later.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace gibench {

std::string version();
/// Of the sources that were built; "+" at its end where they differed from it; "unknown" outside of git.
std::string commit();

/// {cpu, cores, memory_bytes, os, compiler, build}; what cannot be told is absent.
nlohmann::ordered_json machine_json();

/// Largest resident memory of this process so far, bytes; 0 where the system does not tell.
std::uint64_t peak_bytes();

}  // namespace gibench
