#include <QApplication>
#include <QBuffer>
#include <QFileInfo>
#include <QTimer>
#include <array>
#include <fmt/format.h>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/no_screen.h"
#include "app/cli/options.h"
#include "app/lab/lab_window.h"
#include "app/library/preset_library.h"
#include "physics/files/output_file.h"
#include "physics/preset/preset.h"
#include "physics/record/frame.h"
#include "physics/scene/validate.h"
#include "widgets/print/save_file.h"
#include "widgets/scene/scene_export.h"
#include "widgets/scene/scene_view.h"

namespace carom {
namespace {

struct PictureOptions {
  std::string preset;
  MethodOptions method;
  std::optional<double> at;  // s; without it the preset's duration
  std::string output;        // .png, .svg or .pdf
  bool window = false;       // the whole lab, .png only
  bool dark = false;
  int width = 0;   // px; 0: 1280
  int height = 0;  // px; 0: 800
};

constexpr int kWidth = 1280;  // px
constexpr int kHeight = 800;

QSize size_of(const PictureOptions& options) {
  return {options.width > 0 ? options.width : kWidth, options.height > 0 ? options.height : kHeight};
}

// The whole window at one time of a run, as the bytes of a PNG file.
QByteArray window_picture(const Preset& preset, const QString& name, double time, const PictureOptions& options,
                          const Theme& theme) {
  LabWindow window(theme);
  window.resize(size_of(options));
  window.show_scene(preset, name, {});
  window.show();
  window.run_until(time);
  // After the layout and the drawing of the plots.
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
  (void)visit_moments(std::array{setup_of(preset)}, std::array{time}, kImpactShown, take,
                      [](double) { return true; });
  return moment;
}

int save_picture(Arguments arguments, const PictureOptions& options) {
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
  check_time(options.preset, preset, "--at", time);
  OutputSet outputs({find_preset(options.preset)});
  OutputFile& file = *outputs.open(options.output);
  use_no_screen();
  QApplication application(arguments.argc, arguments.argv);
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

}  // namespace

Command add_picture_command(CLI::App& program, Arguments arguments) {
  const auto options = std::make_shared<PictureOptions>();
  CLI::App& command = *program.add_subcommand("picture", "a picture of an experiment at one moment");
  add_preset_option(command, options->preset)->required();
  add_time_option(command, "--at", options->at, "moment, s (default: the preset's duration)");
  add_method_options(command, options->method);
  add_output_option(command, "-o,--output", options->output, "a .png, .svg or .pdf file")->required();
  command.add_flag("--window", options->window, "the whole lab window (.png)");
  command.add_flag("--dark", options->dark, "in the dark colours");
  add_size_option(command, "--width", options->width, "px, 200 to 8000");
  add_size_option(command, "--height", options->height, "px, 200 to 8000");
  return {&command, [options, arguments] { return save_picture(arguments, *options); }};
}

int save_window_picture(Arguments arguments, const std::string& preset, const std::string& output) {
  PictureOptions options;
  options.preset = preset;
  options.window = true;
  options.output = output;
  return save_picture(arguments, options);
}

}  // namespace carom
