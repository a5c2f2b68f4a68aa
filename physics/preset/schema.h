#pragma once

#include "physics/preset/json_text.h"

namespace carom {

// The JSON Schema (draft 7) of preset files, made by the functions that read them. What it cannot say is listed
// in kRules (physics/scene/validate.h): every other fault of a file that the reader refuses, the schema refuses
// as well, and the other way round.
[[nodiscard]] Json preset_schema();

}  // namespace carom
