#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/standard_output.h"
#include "app/library/preset_library.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/plain_text.h"

namespace carom {
namespace {

int list_presets() {
  std::vector<std::string> faults;
  const std::vector<LibraryEntry> library = preset_library(&faults);
  if (library.empty()) {
    throw SceneError(
        fmt::format("{}: no experiments are here; allowed: a folder of presets, named by CAROM_PRESETS",
                    shortened(preset_folder().string(), kMostOfFileName)));
  }
  struct Line {
    std::string topic;
    std::string name;
    std::string text;
  };
  std::vector<Line> lines;
  for (const LibraryEntry& entry : library) {
    try {
      const Preset preset = read_preset(entry.file);
      const std::string text = preset.title + (preset.observe.empty() ? "" : ": ") + preset.observe;
      lines.push_back({printable(entry.topic), printable(entry.name), printable(text)});
    } catch (const SceneError& error) {
      faults.emplace_back(error.what());
    }
  }
  std::size_t widest = 0;
  for (const Line& line : lines) widest = std::max(widest, characters(line.name));
  std::string topic;
  for (const Line& line : lines) {
    if (line.topic != topic) {
      print_out("{}{}\n", topic.empty() ? "" : "\n", line.topic);
      topic = line.topic;
    }
    print_out("  {}{}  {}\n", line.name, std::string(widest - characters(line.name), ' '), line.text);
  }
  for (const std::string& fault : faults) print_error(fault);
  return kGood;
}

}  // namespace

Command add_list_command(CLI::App& program, Arguments /*arguments*/) {
  return {program.add_subcommand("list", "the built-in experiments"), list_presets};
}

}  // namespace carom
