#pragma once

#include <string_view>

// The fuzz targets: each takes any bytes, and throws std::logic_error, or is stopped by a sanitizer, if Carom
// breaks a promise. The ordinary tests run the finds in tests/fuzz/found/NAME again.
namespace carom::fuzz {

// The reader: any bytes either are a scene, which is written and read again unchanged, or give one clear
// line.
void try_preset(std::string_view bytes);

// A scene of up to 20 bodies runs for 0.2 s or 40 steps under a random method: the state stays finite, or the
// run is lost and reports it.
void try_simulation(std::string_view bytes);

// The same with random changes of method and added bodies: the same edits give the same run.
void try_edits(std::string_view bytes);

}  // namespace carom::fuzz
