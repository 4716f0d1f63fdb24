/// A model file in memory, in file coordinates, before it becomes objects of a scene.
#pragma once

#include <string>
#include <vector>

#include "common/scene/scene_assembler.h"

namespace gibench {

/// The faces of one node with one material, in file coordinates with the node's transform applied.
struct ModelPart {
  std::string name;          ///< of the node or its mesh; may be empty
  std::size_t material = 0;  ///< index into Model::materials
  ObjectGeometry geometry;
};

/// A material, and whether its surfaces are two-sided, which a scene says of its objects.
struct ModelMaterial {
  Material material;
  bool two_sided = false;
};

/// A punctual light of the file.
struct ModelLight {
  Light light;
  Vec3d position{0.0};  ///< file coordinates; unused by directional lights
};

/// A camera of the file.
struct ModelCamera {
  Camera camera;
  Vec3d position{0.0}, look_at{0.0};
};

/// Everything that was read.
struct Model {
  std::vector<ModelPart> parts;
  std::vector<ModelMaterial> materials;
  std::vector<ModelLight> lights;
  std::vector<ModelCamera> cameras;
  std::vector<std::string> warnings;
};

}  // namespace gibench
