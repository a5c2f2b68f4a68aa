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

// A part of a run as numbered pictures, of which a film can be made.
struct Film {
  static constexpr int kMostFrames = 100'000;

  std::vector<RunLog> runs;  // of the scene's own method, and of those that are compared with it
  double from = 0.0;         // s of the run
  double to = 1.0;           // s of the run: no frame is after it
  double rate = 25.0;        // frames a second of the film
  double speed = 1.0;        // seconds of the run in a second of the film: below 1 it is slow motion
  QSize pixels{1280, 720};   // even numbers, which encoders of films ask for
  double dots = 1.0;         // px of a picture for one of the look's
  SceneLook look;            // of the first frame, on a viewport of any size
  bool whole = false;        // all bodies in all frames, in place of what the look's camera sees
};

// Moments of the frames, s: from, from + speed / rate, ... Throws SceneError where one of the above is not
// allowed.
[[nodiscard]] std::vector<double> film_times(const Film& film);

// "frame-0001.png", with as many digits as the last of `count` frames needs, at least four.
[[nodiscard]] QString frame_name(int number, int count);
// The frames that a folder has already, "frame-" and four digits or more.
[[nodiscard]] QStringList frames_in(const QString& folder);
// What makes a film of them, to be called in their folder.
[[nodiscard]] QString encoder_line(const Film& film, int count);

// What became of a folder's frames.
struct FilmFrames {
  int written = 0;
  int removed = 0;  // of an older film by Carom, which was longer
  std::vector<std::string>
      other;  // further frames that Carom didn't make: they stay, and an encoder finds them
  std::vector<std::string> stuck;   // of an older film by Carom, but not to be removed
  std::optional<std::string> lost;  // why the run could not go on, if so: the last frames show where it stands
};
// One line each for what of that a user should know, beside the number written.
[[nodiscard]] std::vector<std::string> remarks(const FilmFrames& frames);

// Goes through the run once more and writes its frames as PNG into a folder, which is made if it is not there.
// They come under temporary names first: only when all are there they take the places of older ones, which stay
// where something fails. What is left of an older film by Carom (its frames say so) goes too, no other file.
// `progress` is told the share that is done; where it answers false nothing is left behind, and there is no
// answer. Throws SceneError, also where frames are there and may not be replaced, or where one is among the
// `inputs`.
[[nodiscard]] std::optional<FilmFrames> save_film(const Film& film, const std::filesystem::path& folder,
                                                  bool replace,
                                                  const std::vector<std::filesystem::path>& inputs,
                                                  const std::function<bool(double)>& progress);

}  // namespace carom
