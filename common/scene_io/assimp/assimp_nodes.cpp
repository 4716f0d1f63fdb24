#include "common/scene_io/assimp/assimp_nodes.h"

namespace gibench {

Transform transform_of(const aiNode& node) {
  Transform transform;
  for (const aiNode* at = &node; at != nullptr; at = at->mParent) {
    const aiMatrix4x4& m = at->mTransformation;
    const glm::dmat3 linear(m.a1, m.b1, m.c1, m.a2, m.b2, m.c2, m.a3, m.b3, m.c3);  // GLM takes columns
    transform.linear = linear * transform.linear;
    transform.translation = linear * transform.translation + Vec3d(m.a4, m.b4, m.c4);
  }
  return transform;
}

Transform transform_of(const aiScene& scene, const aiString& node_name) {
  const aiNode* node = scene.mRootNode->FindNode(node_name);
  return node != nullptr ? transform_of(*node) : Transform{};
}

}  // namespace gibench
