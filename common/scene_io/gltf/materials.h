/// The materials of a glTF document, as its primitives wear them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/scene_io/gltf/pictures.h"
#include "common/scene_io/model.h"

namespace gibench {

/// Adds materials to a model. A material is added once for each set of values that it has on the primitives that wear it:
/// pictures and vertex colours are means over what each primitive shows of them.
class GltfMaterials {
 public:
  GltfMaterials(GltfDocument& document, Model& model) : document_(document), pictures_(document), model_(model) {}

  /// Index into Model::materials of what the primitive wears.
  std::size_t of(const GltfPrimitive& primitive);
  /// One warning for each material with anything that is not simulated or was changed.
  void warn() const;

 private:
  std::size_t default_material();

  GltfDocument& document_;
  GltfPictures pictures_;
  Model& model_;
  std::optional<std::size_t> default_;
  std::map<std::size_t, std::vector<std::size_t>> variants_;  ///< by the file's index: those in the model
  std::map<std::size_t, std::vector<std::string>> remarks_;   ///< the same: what to tell, each once
};

}  // namespace gibench
