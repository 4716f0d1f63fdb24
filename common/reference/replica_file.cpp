#include "common/reference/replica_file.h"

#include <bit>
#include <cstring>
#include <string>
#include <system_error>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/core/hash.h"
#include "common/reference/damaged_reference.h"

namespace gibench {

namespace {

static_assert(std::endian::native == std::endian::little, "files hold the bytes as they are in memory");
static_assert(sizeof(Rgb) == 12, "a value is three floats");

struct Header {
  char magic[8] = {'G', 'I', 'B', 'R', 'E', 'P', 'L', '1'};
  std::uint64_t replicas = 0, values = 0, checksum = 0;
};
static_assert(sizeof(Header) == 32);

std::uint64_t checksum_of(const Header& header, const char* data, std::size_t size) {
  const std::uint64_t counts = hash_bytes(&header.replicas, 2 * sizeof header.replicas);
  return hash_bytes(data, size, counts);
}

void check_file(bool good, const std::filesystem::path& file, const std::string& problem) {
  if (!good) throw DamagedReference(file, problem);
}

}  // namespace

std::uint64_t write_replicas(const std::filesystem::path& file, const Replicas& replicas) {
  Header header;
  header.replicas = replicas.count();
  header.values = replicas.size();
  const std::size_t replica_bytes = replicas.size() * sizeof(Rgb);
  std::string bytes(sizeof header + replicas.count() * replica_bytes, '\0');
  char* const data = bytes.data() + sizeof header;
  for (std::size_t r = 0; r < replicas.count() && replica_bytes > 0; ++r) {
    GIBENCH_CHECK(replicas.replicas[r].size() == replicas.size(), "all replicates estimate the same values");
    std::memcpy(data + r * replica_bytes, replicas.replicas[r].data(), replica_bytes);
  }
  header.checksum = checksum_of(header, data, bytes.size() - sizeof header);
  std::memcpy(bytes.data(), &header, sizeof header);
  write_file_atomically(file, bytes);
  return header.checksum;
}

Replicas read_replicas(const std::filesystem::path& file, std::uint64_t checksum) {
  std::error_code unreadable;
  check_file(std::filesystem::exists(file, unreadable), file, "it is missing");
  const std::string bytes = read_file(file);
  Header header;
  check_file(bytes.size() >= sizeof header && std::memcmp(bytes.data(), header.magic, sizeof header.magic) == 0, file,
             "it does not begin as a file of replicates");
  std::memcpy(&header, bytes.data(), sizeof header);
  const std::size_t size = bytes.size() - sizeof header;
  // Counts are compared by division: a damaged one may be anything.
  const bool fits = header.replicas == 0 || header.values == 0
                        ? size == 0
                        : size % header.replicas == 0 && size / header.replicas % sizeof(Rgb) == 0 &&
                              size / header.replicas / sizeof(Rgb) == header.values;
  check_file(fits, file, "its length does not fit its counts");
  const char* const data = bytes.data() + sizeof header;
  check_file(checksum_of(header, data, size) == header.checksum, file, "its checksum does not fit its values");
  check_file(header.checksum == checksum, file, "it is not the file that meta.json names");
  Replicas replicas;
  const std::size_t replica_bytes = header.values * sizeof(Rgb);
  for (std::size_t r = 0; r < header.replicas; ++r) {
    std::vector<Rgb>& replica = replicas.replicas.emplace_back(header.values);
    if (replica_bytes > 0) std::memcpy(replica.data(), data + r * replica_bytes, replica_bytes);
    for (const Rgb& value : replica) check_file(is_finite(value), file, "it holds a value that is not finite");
  }
  return replicas;
}

}  // namespace gibench
