/// Stored references: path-traced answers in independent replicates, keyed by a hash of scene, lights, path
/// class, seed and version. Never made or replaced without being asked for; every file is written beside and
/// then renamed, so that a killed run leaves the old or the new one, whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/metrics/replicas.h"
#include "common/scene/scene.h"

namespace gibench {

/// What a reference is of; hashed into its folder's name.
struct ReferenceQuestion {
  std::string path_class;  ///< light-path expression, e.g. "C.*[LOB]", or with bounces "C.{0,3}[LOB]"
  std::uint64_t seed = 1;
  std::size_t surface_samples = 0;  ///< irradiance at area_uniform_samples(world, count, seed)
  std::optional<Camera> camera;     ///< radiance image; empty: surface samples only
  int pixel_samples = 1;            ///< camera rays per pixel
};

/// direct and indirect replicates of one set of values.
struct ReferenceValues {
  Replicas direct, indirect;
};

struct Reference {
  ReferenceQuestion question;
  std::uint64_t samples_per_replica = 0;  ///< paths for each value in each replicate
  double seconds = 0.0;                   ///< spent so far on making it
  ReferenceValues surface;                ///< W/m²
  ReferenceValues image;                  ///< W/(m² sr), row-major from the top
};

/// Hash of everything in the scene that light transport sees: geometry, materials, lights and environment pixels, in
/// their order. Not names, file paths, the origin, cameras, exposure, edits or reconstruction groups.
std::string scene_key(const Scene& scene);
/// The folder name of a reference: hash of scene_key, question and the store's format version.
std::string reference_key(const Scene& scene, const ReferenceQuestion& question);

/// Adds the samples of `more` to `into`, replicate by replicate, weighted by their numbers: the same, to rounding, as if
/// all had been taken at once. The replicates of `more` must come from other random numbers (a continued sequence, or
/// another shard). InputError where the two answer different questions or differ in their replicates.
void merge(Reference& into, const Reference& more);

/// Root mean square of the standard errors over the root mean square of the values, over values and channels: what the
/// reference's own noise is, as a share. Empty without values, with under two replicates, or where all values are 0.
std::optional<double> relative_standard_error(const Replicas& replicas);

/// References in folders, one each, named by their key: meta.json, which a reader understands (scene, question,
/// samples, seconds, relative standard errors), and the replicates as little-endian floats with a checksum.
class ReferenceStore {
 public:
  explicit ReferenceStore(std::filesystem::path folder);

  /// Empty where there is none. Throws InputError for a damaged one, with its file.
  std::optional<Reference> find(const Scene& scene, const ReferenceQuestion& question) const;
  /// Writes or replaces the reference of this question, whole: a reader, or the next run after a kill, finds the old
  /// one or the new one. InputError if the store cannot be written.
  void save(const Scene& scene, const Reference& reference) const;
  std::filesystem::path folder_of(const Scene& scene, const ReferenceQuestion& question) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace gibench
