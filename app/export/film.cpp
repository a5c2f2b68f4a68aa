#include "app/export/film.h"

#include <QBuffer>
#include <QImage>
#include <QImageReader>
#include <QPainter>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <deque>
#include <fmt/format.h>
#include <set>
#include <system_error>

#include "physics/files/output_file.h"
#include "physics/record/frame.h"
#include "physics/scene/validate.h"
#include "widgets/print/save_file.h"

namespace carom {
namespace {

constexpr double kMargin = 40.0;  // px around the bodies in the fitted view

namespace fs = std::filesystem;

// The text in a frame's file that marks it as Carom's.
constexpr const char* kMarkName = "Software";
constexpr const char* kMark = "Carom film";

// Sorted.
std::vector<std::string> names_of_frames(const fs::path& folder) {
  static const QRegularExpression name(QRegularExpression::anchoredPattern("frame-[0-9]{4,}\\.png"));
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string found = at->path().filename().string();
    if (name.match(QString::fromStdString(found)).hasMatch()) names.push_back(found);
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool is_frame_of_carom(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(file, error))) return false;  // opening a pipe would block
  return QImageReader(QString::fromStdString(file.string())).text(kMarkName) == kMark;
}

// Creates a folder with its missing parents; removes them again unless keep() is called.
class MadeFolders {
 public:
  explicit MadeFolders(const fs::path& folder) {
    std::vector<fs::path> missing;
    std::error_code nowhere;
    fs::path next = fs::absolute(folder, nowhere).lexically_normal();
    if (nowhere)
      refuse_output(folder.string(), fmt::format("no frames can be written there ({})", nowhere.message()),
                    "a folder with the right to write");
    if (next.filename().empty()) next = next.parent_path();
    for (std::error_code error; !fs::exists(next, error) && next != next.root_path(); next = next.parent_path())
      missing.push_back(next);
    for (; !missing.empty(); missing.pop_back()) {
      std::error_code error;
      if (fs::create_directory(missing.back(), error)) made_.push_back(missing.back());
      if (!error) continue;
      undo();
      refuse_output(folder.string(), fmt::format("no frames can be written there ({})", error.message()),
                    "a folder with the right to write");
    }
    if (std::error_code error; !fs::is_directory(folder, error))
      refuse_output(folder.string(), "this is not a folder", "a folder, also a new one");
  }
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;
  ~MadeFolders() { undo(); }
  void keep() { made_.clear(); }

 private:
  void undo() {
    for (std::error_code error; !made_.empty(); made_.pop_back()) fs::remove(made_.back(), error);
  }
  std::vector<fs::path> made_;
};

// All frames of a film; none is put in place before the last is complete.
class FrameFiles {
 public:
  // Checks all places and opens the first before any work.
  FrameFiles(const fs::path& folder, int count, const std::vector<fs::path>& inputs)
      : folder_(folder), made_(folder), outputs_(inputs) {
    for (int k = 1; k <= count; ++k) {
      const std::string name = frame_name(k, count).toStdString();
      names_.insert(name);
      places_.push_back(outputs_.reserve((folder / name).string()));
    }
    open_next();
  }
  void write(const QImage& image) {
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    if (!image.save(&bytes, "PNG"))
      throw SceneError(fmt::format("{}: the picture could not be made", frames_.back().name()));
    write_bytes(frames_.back(), bytes.data());
    frames_.back().finish();
    if (frames_.size() < places_.size()) open_next();
  }
  FilmFrames commit() {
    FilmFrames done;
    for (OutputFile& frame : frames_) frame.commit();
    made_.keep();
    done.written = static_cast<int>(frames_.size());
    for (const std::string& name : names_of_frames(folder_)) {
      if (names_.contains(name)) continue;
      std::error_code error;
      const bool own = is_frame_of_carom(folder_ / name);
      if (own && fs::remove(folder_ / name, error)) {
        ++done.removed;
      } else if (!own) {
        done.other.push_back(name);
      } else {
        done.stuck.push_back(name);
      }
    }
    return done;
  }

 private:
  void open_next() { frames_.emplace_back(std::move(places_[frames_.size()])); }
  fs::path folder_;
  MadeFolders made_;
  OutputSet outputs_;
  std::set<std::string> names_;
  std::vector<OutputPlace> places_;
  std::deque<OutputFile> frames_;
};

// The view for all frames: it includes the whole run.
WorldRect bounds_of(const Film& film, std::span<const double> times, const std::function<bool(double)>& go_on) {
  WorldRect all;
  const auto include = [&](std::span<const Frame> runs) {
    for (const Frame& frame : runs) {
      const WorldRect now = bounds(frame);
      if (!now.empty()) all.include((now.lower + now.upper) / 2, (now.upper - now.lower) / 2);
    }
    return true;
  };
  return visit_moments(film.runs, times, kImpactShown, include, go_on) ? all : WorldRect();
}

}  // namespace

std::vector<double> film_times(const Film& film) {
  const auto check = [](bool good, const char* what, double value, const std::string& allowed) {
    if (!good) throw SceneError(fmt::format("{}: {} is not allowed; allowed: {}", what, value, allowed));
  };
  check(film.from >= 0.0, "from", film.from, "a time from 0 s");
  check(film.to >= film.from && std::isfinite(film.to), "to", film.to,
        fmt::format("a time from the film's first moment, {} s, on", film.from));
  check(film.rate > 0.0 && film.rate <= 1000.0, "frames a second", film.rate, "above 0, up to 1000");
  check(film.speed >= 1e-9 && film.speed <= 1e9, "speed", film.speed, "from 1e-9 to 1e9");
  check(film.pixels.width() % 2 == 0, "width", film.pixels.width(), "an even number, which films need");
  check(film.pixels.height() % 2 == 0, "height", film.pixels.height(), "an even number, which films need");
  const double last = std::floor((film.to - film.from) * film.rate / film.speed * (1.0 + 1e-12) + 1e-9);
  if (!(last < Film::kMostFrames)) {
    throw SceneError(fmt::format("a film of {:.6g} frames is not allowed; allowed: up to {}", last + 1.0,
                                 Film::kMostFrames));
  }
  std::vector<double> times;
  for (int k = 0; k <= static_cast<int>(last); ++k) times.push_back(film.from + k * film.speed / film.rate);
  return times;
}

QString frame_name(int number, int count) {
  const int digits = std::max<int>(4, static_cast<int>(QString::number(count).size()));
  return QString("frame-%1.png").arg(number, digits, 10, QChar('0'));
}

QStringList frames_in(const QString& folder) {
  QStringList frames;
  for (const std::string& name : names_of_frames(folder.toStdString())) frames << QString::fromStdString(name);
  return frames;
}

QString encoder_line(const Film& film, int count) {
  const int digits = static_cast<int>(frame_name(1, count).size()) - 10;  // without frame- and .png
  return QString::fromStdString(
      fmt::format("ffmpeg -framerate {} -i frame-%0{}d.png -pix_fmt yuv420p film.mp4", film.rate, digits));
}

std::vector<std::string> remarks(const FilmFrames& frames) {
  std::vector<std::string> lines;
  const auto counted = [](std::size_t count) {
    return fmt::format("{} frame{}", count, count == 1 ? "" : "s");
  };
  if (frames.removed > 0)
    lines.push_back(fmt::format("{} of a longer film that was there before are removed.",
                                counted(static_cast<std::size_t>(frames.removed))));
  if (!frames.stuck.empty())
    lines.push_back(
        fmt::format("{} of a longer film that was there before could not be removed, from {} on: take them "
                    "away before this "
                    "film is made.",
                    counted(frames.stuck.size()), frames.stuck.front()));
  if (!frames.other.empty())
    lines.push_back(fmt::format(
        "{} not made by Carom, from {} on, would become part of this film: take it out of the folder first.",
        counted(frames.other.size()), frames.other.front()));
  return lines;
}

std::optional<FilmFrames> save_film(const Film& film, const fs::path& folder, bool replace,
                                    const std::vector<fs::path>& inputs,
                                    const std::function<bool(double)>& progress) {
  const std::vector<double> times = film_times(film);
  const auto count = static_cast<int>(times.size());
  if (!replace && !names_of_frames(folder).empty())
    refuse_output(folder.string(), "there are frames already", "another folder, or to replace them");
  FrameFiles files(folder, count, inputs);

  SceneLook look = on_viewport(film.look, QSizeF(film.pixels) / film.dots);
  // First the pass for the bounds, then the frames: both count as work.
  double done = 0.0;
  const double passes = film.whole ? 2.0 : 1.0;
  const double end = std::max(times.back(), 1e-12);
  const auto go_on = [&](double time) { return progress((done + std::min(1.0, time / end)) / passes); };
  if (film.whole) {
    const WorldRect all = bounds_of(film, times, go_on);
    if (all.empty()) return std::nullopt;
    look.camera.fit(all, QMarginsF(kMargin, kMargin, kMargin, kMargin));
    look.side = std::min(look.camera.viewport.width(), look.camera.viewport.height()) / look.camera.scale;
    done = 1.0;
  }

  QImage image(film.pixels, QImage::Format_RGB32);
  image.setDevicePixelRatio(film.dots);
  image.setText(kMarkName, kMark);
  std::optional<std::string> lost;
  const auto show = [&](std::span<const Frame> runs) {
    lost = runs.front().lost;
    {
      QPainter painter(&image);
      paint_scene(painter, runs.front(), look, runs.subspan(1));
    }
    files.write(image);
    return go_on(runs.front().time);
  };
  if (!visit_moments(film.runs, times, kImpactShown, show, go_on)) return std::nullopt;
  FilmFrames frames = files.commit();
  frames.lost = lost;
  return frames;
}

}  // namespace carom
