// The entry points of libFuzzer for one target, CAROM_FUZZ_TARGET. Inputs that are presets are mutated as
// JSON values; others, and now and then presets too, as bytes.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "physics/preset/json_text.h"
#include "physics/scene/validate.h"
#include "tests/fuzz/json_mutator.h"
#include "tests/fuzz/targets.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  carom::fuzz::CAROM_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  constexpr int kBytesEvery = 16;  // one mutation in so many is of bytes
  constexpr int kMostChanges = 4;
  carom::fuzz::Random random(seed);
  if (random() % kBytesEvery == 0) return LLVMFuzzerMutate(data, size, most);
  // Bytes behind the object belong to the target and stay.
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t end = bytes.rfind('}') + 1;  // npos + 1 is 0
  try {
    carom::Json preset = carom::parse_json(bytes.substr(0, end));
    for (std::uint64_t left = 1 + random() % kMostChanges; left > 0; --left)
      carom::fuzz::mutate(preset, random);
    std::string text = preset.dump(-1, ' ', false, carom::Json::error_handler_t::replace);
    text += bytes.substr(end);
    if (text.size() > most) return LLVMFuzzerMutate(data, size, most);
    std::memcpy(data, text.data(), text.size());
    return text.size();
  } catch (const carom::SceneError&) {
    return LLVMFuzzerMutate(data, size, most);
  }
}
