/// Text models read with double precision and a test for truncated files, both of which Assimp lacks.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <filesystem>
#include <string>

#include "common/core/vec.h"

namespace gibench {

/// Hands Assimp the files it asks for. Positions of an OBJ or ASCII STL file that lie far from the origin are moved
/// near it before Assimp rounds them to single precision; `shift()` is what was taken off.
class ModelFiles : public Assimp::DefaultIOSystem {
 public:
  /// Reads the file. Throws InputError at `place` where it cannot be read or is cut short (PLY with fewer lines than its
  /// header tells, OBJ ending within a line).
  ModelFiles(const std::filesystem::path& file, const std::string& place);

  Vec3d shift() const { return shift_; }

  Assimp::IOStream* Open(const char* name, const char* mode = "rb") override;

 private:
  std::string name_, text_;  // text_ is empty where the file needs no change
  Vec3d shift_{0.0};
};

}  // namespace gibench
