#include "bench/measure/reference_search.h"

#include <fmt/format.h>

#include <cstdlib>
#include <utility>

#include "common/core/data_folder.h"
#include "common/core/hash.h"

namespace gibench {

std::optional<ReferenceStore> shipped_references() {
  const char* named = std::getenv("GIBENCH_REFERENCES");
  if (named != nullptr && *named == '\0') return std::nullopt;
  return ReferenceStore(named != nullptr ? std::filesystem::path(named) : data_folder() / "scenes" / "references");
}

std::uint64_t fingerprint_of(const std::vector<SurfaceSample>& samples) {
  std::vector<std::uint32_t> places;
  places.reserve(2 * samples.size());
  for (const SurfaceSample& sample : samples) {
    places.push_back(static_cast<std::uint32_t>(sample.object));
    places.push_back(static_cast<std::uint32_t>(sample.face));
  }
  return hash_bytes(places.data(), places.size() * sizeof(std::uint32_t)) | 1U;
}

ReferenceSearch::ReferenceSearch(std::filesystem::path own, Stores stores, const LoadedScene& scene, int threads,
                                 std::function<void(const std::string&)> warn)
    : own_(std::move(own)), stores_(stores), scene_(scene), threads_(threads), warn_(std::move(warn)) {}

std::optional<Reference> ReferenceSearch::find(const ReferenceQuestion& question) const {
  auto found = own_.find(scene_.scene(), question);
  return found || stores_ == Stores::own_only ? std::move(found) : find_shipped(question);
}

std::optional<Reference> ReferenceSearch::find_shipped(const ReferenceQuestion& question) const {
  const auto store = shipped_references();
  auto found = store ? store->find(scene_.scene(), question) : std::nullopt;
  if (!found) return std::nullopt;
  ReferenceQuestion surface = question;
  surface.camera.reset();
  if (fingerprint_of(measuring_points(*scene_.world, surface, threads_).surface) == found->points) return found;
  warn_(fmt::format(
      "the reference of {} that came with the program is not used: on this machine the surface samples fall on other faces",
      scene_.scene().name));
  return std::nullopt;
}

}  // namespace gibench
