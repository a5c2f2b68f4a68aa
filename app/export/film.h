#pragma once

#include <QSize>
#include <QString>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "physics/record/replay.h"
#include "widgets/scene/scene_export.h"

namespace carom {

// A part of a run as numbered pictures for a film.
struct Film {
  static constexpr int kMostFrames = 100'000;

  std::vector<RunSetup> runs;  // of the scene's own method, and of the compared methods
  double from = 0.0;           // s of the run
  double to = 1.0;             // s of the run: no frame is after it
  double rate = 25.0;          // frames a second of the film
  double speed = 1.0;          // seconds of the run in a second of the film: below 1 it is slow motion
  QSize pixels{1280, 720};     // even numbers, as video encoders require
  double dots = 1.0;           // image px for each px of the look
  SceneLook look;              // of the first frame, on a viewport of any size
  bool whole = false;          // fit all bodies in all frames, instead of the look's camera
};

// Times of the frames, s: from, from + speed / rate, ... Throws SceneError for values that are not allowed.
[[nodiscard]] std::vector<double> film_times(const Film& film);

// "frame-0001.png", with the digits that the last of `count` frames needs, at least four.
[[nodiscard]] QString frame_name(int number, int count);
// The existing frames of a folder, "frame-" and four digits or more.
[[nodiscard]] QStringList frames_in(const QString& folder);
// The command that makes a film of them, to be run in their folder.
[[nodiscard]] QString encoder_line(const Film& film, int count);

// Result for the folder's frames.
struct FilmFrames {
  int written = 0;
  int removed = 0;                  // of an older film by Carom, which was longer
  std::vector<std::string> other;   // further frames not made by Carom: they stay, and an encoder finds them
  std::vector<std::string> stuck;   // of an older film by Carom, but could not be removed
  std::optional<std::string> lost;  // why the run was lost, if so: the last frames show its last state
};
// The lines to show to the user, beside the number written.
[[nodiscard]] std::vector<std::string> remarks(const FilmFrames& frames);

// Replays the run and writes its frames as PNG into a folder, which is created if necessary. The frames have
// temporary names until all are complete; then they replace older ones, which stay if anything fails.
// Remaining frames of an older film by Carom (marked in the file) are removed, no other file is. `progress`
// receives the completed share; if it returns false nothing is left behind, and there is no result. Throws
// SceneError, also if frames exist and may not be replaced, or if one is among the `inputs`.
[[nodiscard]] std::optional<FilmFrames> save_film(const Film& film, const std::filesystem::path& folder,
                                                  bool replace,
                                                  const std::vector<std::filesystem::path>& inputs,
                                                  const std::function<bool(double)>& progress);

}  // namespace carom
