#include <QApplication>
#include <memory>
#include <optional>

#include "app/cli/commands.h"
#include "app/cli/count_progress.h"
#include "app/cli/no_screen.h"
#include "app/cli/options.h"
#include "app/cli/standard_output.h"
#include "app/export/film.h"
#include "app/library/preset_library.h"
#include "physics/preset/preset.h"
#include "physics/scene/validate.h"

namespace carom {
namespace {

struct FilmOptions {
  std::string preset;
  MethodOptions method;
  std::optional<double> from;  // s; without it the start
  std::optional<double> to;    // s; without it the preset's duration
  double rate = 25.0;          // frames a second of the film
  double speed = 1.0;          // seconds of the run a second of the film
  std::string output;          // folder
  bool replace = false;        // replace existing frames
  bool dark = false;
  int width = 1280;  // px
  int height = 720;
};

int make_film(Arguments arguments, const FilmOptions& options) {
  Film film;
  const Preset preset = preset_with_method(options.preset, options.method);
  film.runs = {{setup_of(preset), {}}};
  film.from = options.from.value_or(start_time(preset.saved));
  check_time(options.preset, preset, "--from", film.from);
  film.to = options.to.value_or(preset.duration);
  film.rate = options.rate;
  film.speed = options.speed;
  film.pixels = {options.width, options.height};
  const auto count = static_cast<int>(film_times(film).size());

  use_no_screen();
  const QApplication application(arguments.argc, arguments.argv);
  const Theme& theme = options.dark ? dark_theme() : light_theme();
  apply_theme(*qApp, theme);
  const std::optional<View>& view = preset.view;
  film.look = scene_look({}, view, {}, theme, film.pixels);
  film.whole = !view;
  std::optional<FilmFrames> frames;
  {
    CountProgress progress(100, "%");
    frames = save_film(film, options.output, options.replace, {find_preset(options.preset)}, [&](double share) {
      progress.reach(static_cast<int>(100.0 * share));
      return true;
    });
  }
  if (!frames)
    throw SceneError(options.preset + ": there is nothing to film; allowed: a preset with bodies or a view");
  for (const std::string& line : remarks(*frames)) print_out("{}\n", line);
  print_out("{} frames in {}; there, this makes a film of them:\n{}\n", count, printable(options.output),
            encoder_line(film, count).toStdString());
  if (frames->lost) throw RunLostError(*frames->lost);
  return kGood;
}

}  // namespace

Command add_film_command(CLI::App& program, Arguments arguments) {
  const auto options = std::make_shared<FilmOptions>();
  CLI::App& command = *program.add_subcommand("film", "numbered pictures of a run, to make a film of");
  add_preset_option(command, options->preset)->required();
  add_time_option(command, "--from", options->from, "first moment, s (default: the start)");
  add_time_option(command, "--to", options->to, "end, s (default: the preset's duration)");
  add_method_options(command, options->method);
  command.add_option("--rate", options->rate, "frames a second of the film (default: 25)")->type_name("N");
  command
      .add_option("--speed", options->speed,
                  "seconds of the run in one of the film, below 1 for slow motion (default: 1)")
      ->type_name("X");
  add_output_option(command, "-o,--output", options->output, "a folder for frame-0001.png, frame-0002.png ...")
      ->required()
      ->type_name("DIR");
  command.add_flag("--replace", options->replace, "frames that the folder has already");
  command.add_flag("--dark", options->dark, "in the dark colours");
  add_size_option(command, "--width", options->width, "px, even, 200 to 8000 (default: 1280)");
  add_size_option(command, "--height", options->height, "px, even, 200 to 8000 (default: 720)");
  return {&command, [options, arguments] { return make_film(arguments, *options); }};
}

}  // namespace carom
