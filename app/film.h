#pragma once

#include <QSize>
#include <QString>
#include <QStringList>
#include <functional>
#include <vector>

#include "physics/experiment/run_log.h"
#include "widgets/scene_export.h"

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
// The frames that a folder has already.
[[nodiscard]] QStringList frames_in(const QString& folder);
// What makes a film of them, to be called in their folder.
[[nodiscard]] QString encoder_line(const Film& film, int count);

// Goes through the run once more and writes its frames as PNG into a folder, which is made if it is not there.
// They come beside their place first: frames that the folder has already are replaced, if they may be, when all
// new ones are there, else nothing is written. `progress` is told the share that is done; where it answers
// false nothing is left behind, and the answer is false. Throws SceneError, also where frames are there that
// may not be replaced.
[[nodiscard]] bool save_film(const Film& film, const QString& folder, bool replace,
                             const std::function<bool(double)>& progress);

}  // namespace carom
