#include <algorithm>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/preset_library.h"
#include "app/standard_output.h"
#include "physics/preset/preset.h"

namespace carom {

int list_command() {
  const std::vector<LibraryEntry> library = preset_library();
  if (library.empty()) {
    throw SceneError(
        fmt::format("{}: no experiments are here; allowed: a folder of presets, named by CAROM_PRESETS",
                    preset_folder().string()));
  }
  std::size_t widest = 0;
  for (const LibraryEntry& entry : library) widest = std::max(widest, entry.name.size());
  std::string topic;
  for (const LibraryEntry& entry : library) {
    if (entry.topic != topic) {
      print_out("{}{}\n", topic.empty() ? "" : "\n", entry.topic);
      topic = entry.topic;
    }
    const Scene scene = read_preset(entry.file);
    print_out("  {:<{}}  {}{}{}\n", entry.name, widest, scene.title, scene.observe.empty() ? "" : ": ",
              scene.observe);
  }
  return kGood;
}

}  // namespace carom
