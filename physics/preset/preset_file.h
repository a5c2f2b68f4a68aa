#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/scene/validate.h"

// Preset files: JSON, SI units, "format": "carom-preset", "version": 1. Unknown and duplicate keys are
// errors, except in the free object `extra`, which is kept as it is.
namespace carom {

class Simulation;

inline constexpr int kPresetVersion = 1;

// Reads and validates. Throws SceneError whose one line begins with `origin` (a file's name).
[[nodiscard]] Preset parse_preset(std::string_view text, const std::string& origin);
[[nodiscard]] Preset read_preset(const std::filesystem::path& file);

// The text of a preset file; parse_preset() of it gives the same preset, to the last bit of every number.
[[nodiscard]] std::string write_preset(const Preset& preset);

// Writes `file` whole or not at all (see OutputFile). Throws SceneError if that fails, or if read_preset()
// would refuse the new file; the old file stays.
void save_preset(const Preset& preset, const std::filesystem::path& file);

// Checks all that a reader cannot see one value at a time: the scene (physics/scene/validate.h), whether the
// methods can run it, expectations, plots and the view. Throws SceneError with the JSON pointer of the first
// fault; `places` are those of the forces in its file.
void validate(const Preset& preset, const ForcePlaces& places);
void validate(const Preset& preset);

// The scene of a preset file with other numbers in some places. Forces stand in the order of written_places(),
// and members that hold their default stand there too. The expectations are left out. Throws SceneError if a
// place holds no number, or if the scene does not allow the number.
[[nodiscard]] Preset variant(const Preset& preset, const std::vector<Setting>& settings);

// For the reader: refuses expectations whose settings or sweep name a place that holds no number, and turns the
// places of forces from those of the file, `places`, to those of a file that Carom writes.
void resolve_places(Preset& preset, const ForcePlaces& places);

// The preset that goes on where the run stands now: `document` with the bodies where they are, the clock, what
// has stuck together among the joints, and its checkpoint. Driven bodies keep the position that their drive
// counts from. Expectations are about the run from its start, and are left out. Throws SceneError for a run
// that has numbers which no preset can have.
[[nodiscard]] Preset saved_preset(const Preset& document, const Simulation& simulation);

// Bytes that a file may have to be read: far beyond any preset.
inline constexpr std::size_t kLargestFile = 256'000'000;

// The bytes of a preset file. Never waits for a pipe or a device. Throws SceneError, one line with the file's
// name, if it is no regular file, too large or can't be read.
[[nodiscard]] std::string file_text(const std::filesystem::path& file);

}  // namespace carom
