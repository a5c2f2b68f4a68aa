#include <QApplication>
#include <optional>

#include "app/cli/commands.h"
#include "app/cli/count_progress.h"
#include "app/cli/no_screen.h"
#include "app/cli/standard_output.h"
#include "app/export/film.h"
#include "app/lab/preset_library.h"
#include "physics/preset/preset.h"
#include "physics/scene/validate.h"

namespace carom {

int film_command(int& argc, char** argv, const FilmOptions& options) {
  Film film;
  const Preset preset = preset_with_method(options.preset, options.method);
  film.runs = {{setup_of(preset), {}}};
  film.from = options.from;
  film.to = options.to.value_or(preset.duration);
  film.rate = options.rate;
  film.speed = options.speed;
  film.pixels = {options.width, options.height};
  const auto count = static_cast<int>(film_times(film).size());

  use_no_screen();
  const QApplication application(argc, argv);
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

}  // namespace carom
