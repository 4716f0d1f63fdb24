/// Stored references: path-traced answers in independent replicates, keyed by a hash of scene, lights, path
/// class, seed and version. Never made or replaced without being asked for; every file is written beside and
/// then renamed, so that a killed run leaves the old or the new one, whole.
#pragma once

#include <filesystem>
#include <optional>

#include "common/reference/reference.h"
#include "common/scene/scene.h"

namespace gibench {

/// References in folders, one each, named by their key: meta.json, which a reader understands (scene, question,
/// samples, seconds, relative standard errors), and the replicates as files with a checksum.
class ReferenceStore {
 public:
  /// All bits, or those that their noise leaves meaning, of pixels fewer than of the surface.
  enum class Keep { all, packed };

  explicit ReferenceStore(std::filesystem::path folder);

  /// Empty where there is none. Throws DamagedReference for a damaged one, with its file.
  std::optional<Reference> find(const Scene& scene, const ReferenceQuestion& question) const;
  /// Writes or replaces the reference of this question, whole: a reader, or the next run after a kill, finds the old
  /// one or the new one. Throws as a write does if the store cannot be written.
  void save(const Scene& scene, const Reference& reference, Keep keep = Keep::all) const;
  std::filesystem::path folder_of(const Scene& scene, const ReferenceQuestion& question) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace gibench
