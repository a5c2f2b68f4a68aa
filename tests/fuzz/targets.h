#pragma once

#include <string_view>

// What the fuzzers try: each takes any bytes and throws std::logic_error, or is stopped by a sanitizer, where
// Carom breaks a promise. The finds in tests/fuzz/found/NAME are tried again by the ordinary tests.
namespace carom::fuzz {

// The reader: any bytes are a scene, which is written and read again unchanged, or one clear line.
void try_preset(std::string_view bytes);

// What loads, of up to 20 bodies, runs for 0.2 s or 40 steps under a random method: the state stays finite, or
// the run is lost and says so.
void try_simulation(std::string_view bytes);

// The same while methods are changed and bodies put in at random: the same edits give the same run.
void try_edits(std::string_view bytes);

}  // namespace carom::fuzz
