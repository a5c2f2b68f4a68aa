#include "app/film.h"

#include <QDir>
#include <QImage>
#include <QPainter>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <cmath>
#include <fmt/format.h>
#include <memory>

#include "physics/experiment/run_moments.h"
#include "physics/scene/validate.h"

namespace carom {
namespace {

constexpr double kMargin = 40.0;  // px about what is shown whole

[[noreturn]] void fail(const QString& folder, const char* why) {
  throw SceneError(fmt::format("{}: {}", folder.toStdString(), why));
}

// A folder of its own beside the frames' place. What was made for it goes if the frames don't come.
class Workshop {
 public:
  explicit Workshop(const QString& folder) : folder_(folder), was_there_(QDir(folder).exists()) {
    if (QDir().mkpath(folder)) place_ = std::make_unique<QTemporaryDir>(folder + "/frames-XXXXXX");
    if (place_ == nullptr || !place_->isValid()) {
      forget();
      fail(folder, "no frames can be written there; allowed: a folder with the right to write");
    }
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;
  ~Workshop() {
    if (!done_) forget();
  }
  [[nodiscard]] QString path(const QString& name) const { return place_->filePath(name); }
  void finish() {
    for (const QString& old : frames_in(folder_)) QFile::remove(folder_ + "/" + old);
    for (const QString& name : frames_in(place_->path())) {
      if (!QFile::rename(path(name), folder_ + "/" + name)) fail(folder_, "the frames could not be put there");
    }
    done_ = true;
  }

 private:
  void forget() {
    place_.reset();
    if (!was_there_) QDir().rmdir(folder_);
  }
  QString folder_;
  bool was_there_;
  bool done_ = false;
  std::unique_ptr<QTemporaryDir> place_;
};

// What all frames show: nothing of the run is out of the picture.
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
  const auto check = [](bool good, const char* what, double value, const char* allowed) {
    if (!good) throw SceneError(fmt::format("{}: {} is not allowed; allowed: {}", what, value, allowed));
  };
  check(film.from >= 0.0, "from", film.from, "a time from 0 s");
  check(film.to >= film.from && std::isfinite(film.to), "to", film.to, "a time not before the film's start");
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
  static const QRegularExpression name("^frame-\\d{4,}\\.png$");
  return QDir(folder).entryList(QDir::Files, QDir::Name).filter(name);
}

QString encoder_line(const Film& film, int count) {
  const int digits = static_cast<int>(frame_name(1, count).size()) - 10;  // without frame- and .png
  return QString::fromStdString(
      fmt::format("ffmpeg -framerate {} -i frame-%0{}d.png -pix_fmt yuv420p film.mp4", film.rate, digits));
}

bool save_film(const Film& film, const QString& folder, bool replace,
               const std::function<bool(double)>& progress) {
  const std::vector<double> times = film_times(film);
  const auto count = static_cast<int>(times.size());
  if (!replace && !frames_in(folder).isEmpty())
    fail(folder, "there are frames already; allowed: another folder, or to replace them");
  Workshop workshop(folder);

  SceneLook look = on_viewport(film.look, QSizeF(film.pixels) / film.dots);
  // The run's own time, then the frames': the pass for the bounds is a part of the work.
  double done = 0.0;
  const double passes = film.whole ? 2.0 : 1.0;
  const double end = std::max(times.back(), 1e-12);
  const auto go_on = [&](double time) { return progress((done + std::min(1.0, time / end)) / passes); };
  if (film.whole) {
    const WorldRect all = bounds_of(film, times, go_on);
    if (all.empty()) return false;
    look.camera.fit(all, QMarginsF(kMargin, kMargin, kMargin, kMargin));
    look.side = std::min(look.camera.viewport.width(), look.camera.viewport.height()) / look.camera.scale;
    done = 1.0;
  }

  int number = 0;
  QImage image(film.pixels, QImage::Format_RGB32);
  image.setDevicePixelRatio(film.dots);
  const auto show = [&](std::span<const Frame> runs) {
    {
      QPainter painter(&image);
      paint_scene(painter, runs.front(), look, runs.subspan(1));
    }
    ++number;
    if (!image.save(workshop.path(frame_name(number, count)), "PNG"))
      fail(folder, "a frame could not be written; allowed: a place with room");
    return go_on(runs.front().time);
  };
  if (!visit_moments(film.runs, times, kImpactShown, show, go_on)) return false;
  workshop.finish();
  return true;
}

}  // namespace carom
