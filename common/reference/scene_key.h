/// Keys of scenes and references: hashes of all that decides about the answer.
#pragma once

#include <string>

#include "common/reference/reference.h"
#include "common/scene/scene.h"

namespace gibench {

/// Hash of everything in the scene that light transport sees: geometry, materials, lights and environment pixels, in
/// their order. Not names, file paths, the origin, cameras, exposure, edits or reconstruction groups.
std::string scene_key(const Scene& scene);
/// The folder name of a reference: hash of scene_key, question and the store's format version.
std::string reference_key(const Scene& scene, const ReferenceQuestion& question);

}  // namespace gibench
