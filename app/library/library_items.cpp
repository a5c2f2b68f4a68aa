#include "app/library/library_items.h"

#include "app/library/preset_library.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/validate.h"
#include "widgets/scene/scene_thumbnail.h"

namespace carom {

std::vector<ExperimentItem> library_items() {
  std::vector<ExperimentItem> items;
  for (const LibraryEntry& entry : preset_library()) {
    const auto name = QString::fromStdString(entry.name);
    items.push_back({name, QString::fromStdString(entry.topic), name, {}, {}});
    try {
      const Preset preset = read_preset(entry.file);
      items.back().title = QString::fromStdString(preset.title);
      items.back().observe = QString::fromStdString(preset.observe);
      items.back().about = QString::fromStdString(preset.about);
    } catch (const SceneError& error) {
      items.back().observe = QString::fromStdString(error.what());
    }
  }
  return items;
}

Frame start_frame(const Preset& preset) {
  const Simulation simulation(setup_of(preset));
  Frame frame;
  take_moment(simulation, frame);
  frame.bodies = std::make_shared<const std::vector<Body>>(simulation.bodies());
  frame.forces = std::make_shared<const Forces>(preset.scene.forces);
  return frame;
}

std::vector<QPixmap> library_pictures(const Theme& theme, double pixels) {
  std::vector<QPixmap> pictures;
  for (const LibraryEntry& entry : preset_library()) {
    pictures.emplace_back();
    try {
      pictures.back() = scene_thumbnail(start_frame(read_preset(entry.file)), theme, {52, 36}, pixels);
    } catch (const SceneError&) {
      // The list shows the reason.
    }
  }
  return pictures;
}

}  // namespace carom
