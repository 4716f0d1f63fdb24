/// The program and the machine of a run: needed to understand a result later.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace gibench {

std::string version();
/// Of the sources that were built; "+" at its end where they differed from it; "unknown" outside of git.
std::string commit();

/// Unknown values are empty or 0.
struct Machine {
  std::string cpu, os, compiler, build;
  int cores = 0;
  std::uint64_t memory_bytes = 0;
};
/// The one that this runs on, as this program was built.
Machine this_machine();

/// {cpu, cores, memory_bytes, os, compiler, build}; unknown values are omitted.
nlohmann::ordered_json to_json(const Machine& machine);
Machine machine_of(const nlohmann::ordered_json& json);

/// Which program made a record, and where.
struct Origin {
  std::string version, commit;
  Machine machine;

  /// This program on this machine.
  static Origin here() { return {gibench::version(), gibench::commit(), this_machine()}; }
};

/// Adds {version, commit, machine}.
void write_origin(nlohmann::ordered_json& json, const Origin& origin);
Origin origin_of(const nlohmann::ordered_json& json);

/// Largest resident memory of this process so far, bytes; 0 where the system does not report it.
std::uint64_t peak_bytes();
/// Resident memory of this process now, likewise.
std::uint64_t resident_bytes();

}  // namespace gibench
