#include <QApplication>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/count_progress.h"
#include "app/film.h"
#include "app/no_screen.h"

namespace carom {

int film_command(int& argc, char** argv, const FilmOptions& options) {
  Film film;
  const Scene scene = scene_with_method(options.preset, options.method);
  film.runs = {{scene, {}}};
  film.from = options.from;
  film.to = options.to.value_or(scene.duration);
  film.rate = options.rate;
  film.speed = options.speed;
  film.pixels = {options.width, options.height};
  const auto count = static_cast<int>(film_times(film).size());

  use_no_screen();
  const QApplication application(argc, argv);
  const Theme& theme = options.dark ? dark_theme() : light_theme();
  apply_theme(*qApp, theme);
  const std::optional<View>& view = scene.view;
  film.look = scene_look({}, view, {}, theme, film.pixels);
  film.whole = !view;
  {
    CountProgress progress(100, "%");
    (void)save_film(film, QString::fromStdString(options.output), options.replace, [&](double share) {
      progress.reach(static_cast<int>(100.0 * share));
      return true;
    });
  }
  fmt::print("{} frames in {}; there, this makes a film of them:\n{}\n", count, options.output,
             encoder_line(film, count).toStdString());
  return kGood;
}

}  // namespace carom
