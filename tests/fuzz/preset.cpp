#include "physics/preset/preset.h"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>
#include <string>

#include "physics/preset/preset_file.h"
#include "tests/fuzz/targets.h"

namespace carom::fuzz {
namespace {

constexpr std::size_t kLongestLine = 500;  // bytes

void check_line(const std::string& line) {
  const bool controls =
      std::any_of(line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  if (controls || line.size() > kLongestLine)
    throw std::logic_error(fmt::format("not one short line: {}", line));
}

}  // namespace

void try_preset(std::string_view bytes) {
  Preset preset;
  try {
    preset = parse_preset(bytes, "input");
  } catch (const SceneError& error) {
    check_line(error.what());
    return;
  }
  const std::string written = write_preset(preset);
  std::string again;
  try {
    again = write_preset(parse_preset(written, "written"));
  } catch (const SceneError& error) {
    throw std::logic_error(fmt::format("what Carom wrote is refused: {}", error.what()));
  }
  if (again != written) throw std::logic_error("what Carom wrote changes when it is read and written again");
}

}  // namespace carom::fuzz
