#include <QApplication>
#include <QBuffer>
#include <QDir>
#include <QFileInfo>
#include <QTimer>
#include <array>
#include <cstdlib>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/no_screen.h"
#include "app/cli/standard_output.h"
#include "app/lab/autosave.h"
#include "app/lab/lab_window.h"
#include "app/lab/preset_library.h"
#include "physics/files/output_set.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/record/run_moments.h"
#include "physics/scene/plain_text.h"
#include "widgets/print/save_file.h"
#include "widgets/scene/scene_export.h"
#include "widgets/scene/scene_view.h"

namespace carom {
namespace {

constexpr int kWidth = 1280;  // px
constexpr int kHeight = 800;

bool has_display() {
  const auto set = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  return set("DISPLAY") || set("WAYLAND_DISPLAY") || set("QT_QPA_PLATFORM");
}

QSize size_of(const PictureOptions& options) {
  return {options.width > 0 ? options.width : kWidth, options.height > 0 ? options.height : kHeight};
}

// The whole window at one moment of a run, as the bytes of a PNG file.
QByteArray window_picture(const Preset& preset, const QString& name, double time, const PictureOptions& options,
                          const Theme& theme) {
  LabWindow window(theme);
  window.resize(size_of(options));
  window.show_scene(preset, name, {});
  window.show();
  window.run_until(time);
  // When all is laid out and the plots are drawn.
  QTimer::singleShot(0,
                     [] { QTimer::singleShot(0, [] { QTimer::singleShot(0, qApp, &QApplication::quit); }); });
  QApplication::exec();
  QBuffer bytes;
  bytes.open(QIODevice::WriteOnly);
  if (!window.grab().save(&bytes, "PNG"))
    throw SceneError(fmt::format("{}: the picture could not be made", options.output));
  return bytes.data();
}

Frame frame_at(const Preset& preset, double time) {
  Frame moment;
  const auto take = [&](std::span<const Frame> frames) {
    moment = frames.front();
    return true;
  };
  (void)visit_moments(std::array{RunLog{setup_of(preset), {}}}, std::array{time}, kImpactShown, take,
                      [](double) { return true; });
  return moment;
}

}  // namespace

int picture_command(int& argc, char** argv, const PictureOptions& options) {
  const Preset preset = preset_with_method(options.preset, options.method);
  const QString output = QString::fromStdString(options.output);
  const QString suffix = QFileInfo(output).suffix().toLower();
  if (options.window && suffix != "png") {
    throw SceneError(
        fmt::format("{}: a picture of the window is not of this kind; allowed: .png", options.output));
  }
  if (suffix != "png" && suffix != "svg" && suffix != "pdf") {
    throw SceneError(fmt::format("{}: not a kind of picture; allowed: .png, .svg, .pdf", options.output));
  }
  const double time = options.at.value_or(preset.duration);
  OutputSet outputs({find_preset(options.preset)});
  OutputFile& file = *outputs.open(options.output);
  use_no_screen();
  QApplication application(argc, argv);
  const Theme& theme = options.dark ? dark_theme() : light_theme();
  apply_theme(application, theme);
  if (options.window) {
    const QString name = QString::fromStdString(find_preset(options.preset).stem().string());
    write_bytes(file, window_picture(preset, name, time, options, theme));
  } else {
    write_scene_picture(file, frame_at(preset, time), preset.view, {}, theme, size_of(options));
  }
  file.commit();
  if (const Frame moment = frame_at(preset, time); moment.lost) throw RunLostError(*moment.lost);
  return kGood;
}

int lab_command(int& argc, char** argv, const std::string& preset) {
  const std::string wanted = preset.empty() ? kDefaultExperiment : preset;
  (void)read_preset(find_preset(wanted));  // a bad file is told on the terminal, before anything else
  if (!has_display()) {
    print_out("There is no display: the experiment is run instead of the lab.\n\n");
    RunOptions run;
    run.preset = wanted;
    run_command(run);
    PictureOptions picture;
    picture.preset = wanted;
    picture.window = true;
    picture.output = QDir::current().filePath("carom-lab.png").toStdString();
    picture_command(argc, argv, picture);
    print_out("\npicture of the lab: {}\n", printable(picture.output));
    return kGood;
  }
  QApplication application(argc, argv);
  QApplication::setApplicationName("Carom");
  const bool dark = QApplication::palette().color(QPalette::Window).lightnessF() < 0.5F;
  const Theme& theme = dark ? dark_theme() : light_theme();
  apply_theme(application, theme);
  std::vector<std::string> skipped;
  (void)preset_library(&skipped);
  for (const std::string& line : skipped) print_error(line);
  LabWindow window(theme);
  window.open(wanted);
  window.show();
  window.keep_work(autosave_folder());
  return QApplication::exec();
}

}  // namespace carom
