/// The JSON Schema of scene files: scenes/scene.schema.json, part of the program.
#pragma once

namespace gibench {

/// The text of scenes/scene.schema.json (JSON Schema draft 7) as it was when the program was built.
const char* scene_schema_text();

}  // namespace gibench
