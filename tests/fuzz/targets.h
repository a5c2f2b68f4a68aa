#pragma once

#include <string_view>

// What the fuzzers try: each takes any bytes and throws std::logic_error, or is stopped by a sanitizer, where
// Carom breaks a promise. The finds in tests/fuzz/found/NAME are tried again by the ordinary tests.
namespace carom::fuzz {

// The reader: any bytes are a scene, which is written and read again unchanged, or one clear line.
void try_preset(std::string_view bytes);

}  // namespace carom::fuzz
