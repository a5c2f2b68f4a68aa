#include <CLI/CLI.hpp>
#include <QApplication>
#include <QDir>
#include <QSettings>
#include <cstdlib>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/standard_output.h"
#include "app/lab/autosave.h"
#include "app/lab/lab_window.h"
#include "app/library/preset_library.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/plain_text.h"

namespace carom {
namespace {

bool has_display() {
  const auto set = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  return set("DISPLAY") || set("WAYLAND_DISPLAY") || set("QT_QPA_PLATFORM");
}

int open_lab(Arguments arguments, const std::string& preset) {
  const std::string wanted = preset.empty() ? kDefaultExperiment : preset;
  (void)read_preset(find_preset(wanted));  // reports a bad file on the terminal first
  if (!has_display()) {
    print_out("There is no display: the experiment runs here instead of in the lab.\n\n");
    run_preset(wanted);
    const std::string picture = QDir::current().filePath("carom-lab.png").toStdString();
    save_window_picture(arguments, wanted, picture);
    print_out("\npicture of the lab: {}\n", printable(picture));
    return kGood;
  }
  QApplication application(arguments.argc, arguments.argv);
  QApplication::setApplicationName("Carom");
  QSettings settings("carom", "carom");
  const bool system_dark = QApplication::palette().color(QPalette::Window).lightnessF() < 0.5F;
  const Theme& theme = settings.value("dark", system_dark).toBool() ? dark_theme() : light_theme();
  apply_theme(application, theme);
  std::vector<std::string> skipped;
  (void)preset_library(&skipped);
  for (const std::string& line : skipped) print_error(line);
  LabWindow window(theme);
  window.restore_layout(settings);
  window.open(wanted);
  window.show();
  window.keep_work(autosave_folder());
  const int code = QApplication::exec();
  window.keep_layout(settings);
  return code;
}

}  // namespace

Command add_lab_command(CLI::App& program, Arguments arguments) {
  const auto preset = std::make_shared<std::string>();
  program.add_option("preset", *preset, "a preset file, or the name of a built-in experiment")
      ->type_name("FILE|NAME");
  return {&program, [preset, arguments] { return open_lab(arguments, *preset); }};
}

}  // namespace carom
