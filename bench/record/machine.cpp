#include "bench/record/machine.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <fstream>

#include "bench/record/json_fields.h"
#include "commit.h"
#include "common/core/parallel.h"

namespace gibench {

namespace {

/// The rest of the first line of `file` that starts with `key`, without separators and quotes; empty: none.
std::string value_in(const char* file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.compare(0, key.size(), key) != 0) continue;
    const std::size_t first = line.find_first_not_of(" \t:=\"", key.size());
    if (first == std::string::npos) return {};
    return line.substr(first, line.find_last_not_of("\" \t") - first + 1);
  }
  return {};
}

std::uint64_t bytes_of_process(const std::string& key) {
  const std::string text = value_in("/proc/self/status", key);
  return text.empty() ? 0 : std::stoull(text) * 1024;  // "1234 kB"
}

}  // namespace

std::string version() { return GIBENCH_VERSION; }
std::string commit() { return GIBENCH_COMMIT; }

Machine this_machine() {
  Machine machine;
  machine.cpu = value_in("/proc/cpuinfo", "model name");
  machine.cores = hardware_threads();
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGE_SIZE);
  if (pages > 0 && page > 0) machine.memory_bytes = static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page);
  machine.os = value_in("/etc/os-release", "PRETTY_NAME");
  if (utsname name{}; uname(&name) == 0)
    machine.os += std::string(machine.os.empty() ? "" : ", ") + name.sysname + " " + name.release;
#ifdef __clang__
  machine.compiler = "clang " __clang_version__;
#else
  machine.compiler = "g++ " __VERSION__;
#endif
  machine.build = GIBENCH_BUILD_TYPE;
  return machine;
}

Json to_json(const Machine& machine) {
  Json json = Json::object();
  if (!machine.cpu.empty()) json["cpu"] = machine.cpu;
  json["cores"] = machine.cores;
  if (machine.memory_bytes > 0) json["memory_bytes"] = machine.memory_bytes;
  if (!machine.os.empty()) json["os"] = machine.os;
  json["compiler"] = machine.compiler;
  json["build"] = machine.build;
  return json;
}

Machine machine_of(const Json& json) {
  Machine machine;
  read_field(json, "cpu", machine.cpu);
  read_field(json, "cores", machine.cores);
  read_field(json, "memory_bytes", machine.memory_bytes);
  read_field(json, "os", machine.os);
  read_field(json, "compiler", machine.compiler);
  read_field(json, "build", machine.build);
  return machine;
}

void write_origin(Json& json, const Origin& origin) {
  json["version"] = origin.version;
  json["commit"] = origin.commit;
  json["machine"] = to_json(origin.machine);
}

Origin origin_of(const Json& json) {
  Origin origin;
  read_field(json, "version", origin.version);
  read_field(json, "commit", origin.commit);
  origin.machine = machine_of(object_field(json, "machine"));
  return origin;
}

std::uint64_t peak_bytes() { return bytes_of_process("VmHWM"); }
std::uint64_t resident_bytes() { return bytes_of_process("VmRSS"); }

}  // namespace gibench
