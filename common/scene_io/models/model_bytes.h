/// A model as bytes, for the way from one process of this program to another on the same machine.
#pragma once

#include <string>
#include <string_view>

#include "common/scene_io/model.h"

namespace gibench {

/// All of a model. It holds no image as surroundings, which no model file has (a failed check).
std::string bytes_of(const Model& model);

/// The model again, bit by bit. Throws WorkError where the bytes are no model: cut short, a kind or an index out of range.
Model model_of_bytes(std::string_view bytes);

}  // namespace gibench
