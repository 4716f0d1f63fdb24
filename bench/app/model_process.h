/// The reading of models in a process of its own: what a damaged file does to the reader of its format ends that process alone.
#pragma once

#include <optional>

#include "bench/measure/model_limits.h"
#include "common/scene_io/models/read_model.h"

namespace gibench {

/// Reads as read_model() does; files that Assimp reads in a child, this program called anew, so that `main` has to begin with
/// answer_as_model_process(), as run_program() does. Throws InputError for a file on which the child crashed or passed a limit,
/// and what the child's reader threw.
ModelReader reader_in_child(const ModelLimits& limits);

/// Where this process is such a child: reads the model, hands it to the parent, and gives the exit status. Elsewhere empty.
std::optional<int> answer_as_model_process(int argc, char** argv, const ModelReader& reader = read_model);

}  // namespace gibench
