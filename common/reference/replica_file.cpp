#include "common/reference/replica_file.h"

#include <bit>
#include <cstring>
#include <string>
#include <system_error>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/core/hash.h"
#include "common/reference/damaged_reference.h"
#include "common/reference/packed_replicas.h"

namespace gibench {

namespace {

static_assert(std::endian::native == std::endian::little, "files hold the bytes as they are in memory");
static_assert(sizeof(Rgb) == 12, "a value is three floats");

constexpr std::size_t magic_size = 8;
constexpr const char *exact_magic = "GIBREPL1", *packed_magic = "GIBREPL2";

struct Header {
  char magic[magic_size] = {};
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

std::string exact_bytes(const Replicas& replicas) {
  std::string bytes;
  for (const std::vector<Rgb>& replica : replicas.replicas)
    bytes.append(reinterpret_cast<const char*>(replica.data()), replica.size() * sizeof(Rgb));
  return bytes;
}

std::string bytes_of(const Replicas& replicas, ReplicaFormat format) {
  switch (format) {
    case ReplicaFormat::exact: return exact_bytes(replicas);
    case ReplicaFormat::packed: return pack_replicas(replicas, Grain::fine);
    case ReplicaFormat::packed_coarsely: break;
  }
  return pack_replicas(replicas, Grain::coarse);
}

/// Of a header whose counts were not checked yet: a damaged one may be anything, so that they are compared by division.
bool counts_fit(const Header& header, std::size_t size) {
  if (header.replicas == 0 || header.values == 0) return size == 0;
  return size % header.replicas == 0 && size / header.replicas % sizeof(Rgb) == 0 &&
         size / header.replicas / sizeof(Rgb) == header.values;
}

Replicas exact_replicas(const Header& header, const char* data) {
  Replicas replicas;
  const std::size_t replica_bytes = header.values * sizeof(Rgb);
  for (std::size_t r = 0; r < header.replicas; ++r) {
    std::vector<Rgb>& replica = replicas.replicas.emplace_back(header.values);
    if (replica_bytes > 0) std::memcpy(replica.data(), data + r * replica_bytes, replica_bytes);
  }
  return replicas;
}

}  // namespace

std::uint64_t write_replicas(const std::filesystem::path& file, const Replicas& replicas, ReplicaFormat format) {
  Header header;
  std::memcpy(header.magic, format == ReplicaFormat::exact ? exact_magic : packed_magic, magic_size);
  header.replicas = replicas.count();
  header.values = replicas.size();
  for (const std::vector<Rgb>& replica : replicas.replicas)
    GIBENCH_CHECK(replica.size() == replicas.size(), "all replicates estimate the same values");
  const std::string data = bytes_of(replicas, format);
  header.checksum = checksum_of(header, data.data(), data.size());
  std::string bytes(sizeof header, '\0');
  std::memcpy(bytes.data(), &header, sizeof header);
  write_file_atomically(file, bytes + data);
  return header.checksum;
}

Replicas read_replicas(const std::filesystem::path& file, std::uint64_t checksum) {
  std::error_code unreadable;
  check_file(std::filesystem::exists(file, unreadable), file, "it is missing");
  const std::string bytes = read_file(file);
  Header header;
  check_file(bytes.size() >= sizeof header, file, "it does not begin as a file of replicates");
  std::memcpy(&header, bytes.data(), sizeof header);
  const bool exact = std::memcmp(header.magic, exact_magic, magic_size) == 0;
  check_file(exact || std::memcmp(header.magic, packed_magic, magic_size) == 0, file,
             "it does not begin as a file of replicates");
  const char* const data = bytes.data() + sizeof header;
  const std::size_t size = bytes.size() - sizeof header;
  check_file(!exact || counts_fit(header, size), file, "its length does not fit its counts");
  check_file(checksum_of(header, data, size) == header.checksum, file, "its checksum does not fit its values");
  check_file(header.checksum == checksum, file, "it is not the file that meta.json names");
  const Replicas replicas = exact ? exact_replicas(header, data) : unpack_replicas({data, size}, header.replicas, header.values);
  check_file(replicas.count() == header.replicas && replicas.size() == header.values, file, "its values cannot be unpacked");
  for (const std::vector<Rgb>& replica : replicas.replicas)
    for (const Rgb& value : replica) check_file(is_finite(value), file, "it holds a value that is not finite");
  return replicas;
}

}  // namespace gibench
