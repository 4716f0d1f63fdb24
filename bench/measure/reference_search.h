/// References looked up: in the user's own store, then in the one that came with the program.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "bench/measure/loaded_scene.h"
#include "bench/measure/measuring.h"

namespace gibench {

/// `scenes/references` of the data folder; never written to. The environment variable GIBENCH_REFERENCES names another store,
/// or none where it is empty.
std::optional<ReferenceStore> shipped_references();

/// Fingerprint of surface samples: of the objects and faces that they lie on, in their order. Never 0.
std::uint64_t fingerprint_of(const std::vector<SurfaceSample>& samples);

/// Looks up references of one scene at one set of surface samples.
class ReferenceSearch {
 public:
  enum class Stores { own_only, own_then_shipped };

  /// `warn` gets a line where the reference that came with the program cannot be used.
  ReferenceSearch(std::filesystem::path own, Stores stores, const LoadedScene& scene, int threads,
                  std::function<void(const std::string&)> warn);

  /// Throws DamagedReference.
  std::optional<Reference> find(const ReferenceQuestion& question) const;
  /// That of the program, if it was taken at the same surface samples.
  std::optional<Reference> find_shipped(const ReferenceQuestion& question) const;

 private:
  ReferenceStore own_;
  Stores stores_;
  const LoadedScene& scene_;
  int threads_;
  std::function<void(const std::string&)> warn_;
};

}  // namespace gibench
