#include "app/lab/lab_exports.h"

#include <QClipboard>
#include <QDate>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLocale>
#include <QPointer>
#include <QStandardPaths>
#include <algorithm>
#include <memory>
#include <optional>
#include <tuple>

#include "app/export/bins_export.h"
#include "app/export/film.h"
#include "app/export/lab_report.h"
#include "app/export/run_export.h"
#include "app/export/run_files.h"
#include "app/export/run_progress.h"
#include "app/lab/document_change.h"
#include "app/lab/document_edit.h"
#include "app/lab/document_files.h"
#include "app/lab/export_dialog.h"
#include "app/lab/film_dialog.h"
#include "app/lab/marks_text.h"
#include "app/lab/report_dialog.h"
#include "app/lab/session.h"
#include "physics/files/output_file.h"
#include "physics/preset/preset_file.h"
#include "physics/run/scene_now.h"
#include "physics/run/simulation.h"
#include "physics/scene/validate.h"
#include "widgets/base/ask.h"
#include "widgets/base/method_names.h"
#include "widgets/plot/plot_export.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/run_plot.h"
#include "widgets/run/before_after.h"
#include "widgets/run/ledger_table.h"
#include "widgets/scene/scene_view.h"

namespace carom {
namespace {

// The quantities of a plot, each once.
void add_columns(const PlotContent& content, std::vector<Quantity>& columns) {
  const auto add = [&](const std::optional<Quantity>& quantity) {
    if (quantity && std::find(columns.begin(), columns.end(), *quantity) == columns.end())
      columns.push_back(*quantity);
  };
  for (const PlotLine& line : content.lines) {
    if (!line.curve) continue;
    add(line.curve->x);
    add(line.curve->y);
  }
}

DataExport export_of(const Frame& frame, ReferenceId reference) {
  return {*frame.setup, frame.key_frames, reference, frame.steps, {}, 0.0, frame.time};
}

}  // namespace

LabExports::LabExports(QWidget* window, Session& session, const Views& views)
    : QObject(window), window_(window), session_(session), views_(views), bodies_(new BeforeAfterModel(this)) {
  connect(&views.plots, &PlotPanel::pictureAsked, this, &LabExports::save_plot);
  connect(&views.plots, &PlotPanel::dataAsked, this, &LabExports::save_data);
  connect(&views.plots, &PlotPanel::dataCopyAsked, this, &LabExports::copy_data);
  for (FigureTable* table : window->findChildren<FigureTable*>())
    connect(table, &FigureTable::saveAsked, this, [this, table] { save_table(*table); });
}

bool LabExports::has_run() const {
  return !session_.runs().newest().empty() && session_.runs().newest().front()->setup != nullptr;
}

std::vector<RunSetup> LabExports::runs() const {
  std::vector<RunSetup> all;
  for (const auto& frame : session_.runs().newest()) all.push_back(*frame->setup);
  return all;
}

void LabExports::ask_for_export(const QString& title, const QString& suggestion, const QString& filter,
                                const Then& then) {
  const FileKind kind{filter, QFileInfo(suggestion).suffix()};
  ask_for_file(window_, title, suggestion, {kind}, [=, this](const QString& file) {
    try {
      OutputSet({session_.file().toStdString()}).reserve(file.toStdString());
    } catch (const SceneError& error) {
      return show_message(window_, title, QString::fromUtf8(error.what()));
    }
    then(file);
  });
}

// --- pictures
// -----------------------------------------------------------------------------------------------------------

void LabExports::save_picture_as(const QString& stem,
                                 const std::function<bool(const QString&, QString*)>& save) {
  ask_for_export(tr("Save the picture"), stem + ".png", tr("Pictures (*.png *.svg *.pdf)"),
                 [this, save](const QString& file) {
                   QString error;
                   if (!save(file, &error)) show_message(window_, tr("The picture cannot be saved"), error);
                 });
}

void LabExports::save_scene_picture() {
  const QString moment = QString::number(session_.runs().shown_time(), 'g', 6);
  save_picture_as(tr("scene, t = %1 s").arg(moment),
                  [this](const QString& file, QString* error) { return views_.scene.save(file, error); });
}

void LabExports::copy_scene_picture() { QGuiApplication::clipboard()->setImage(views_.scene.picture()); }

void LabExports::save_plot(RunPlot* plot) {
  views_.plots.show_now();
  save_picture_as("plot", [plot = QPointer<RunPlot>(plot)](const QString& file, QString* error) {
    return plot == nullptr || save_plot_picture(*plot, file, error);
  });
}

// --- data
// -----------------------------------------------------------------------------------------------------------

void LabExports::save_table(const FigureTable& table) {
  ask_for_export(tr("Save the table"), "table.csv", tr("Tables (*.csv)"),
                 [this, csv = table.csv().toStdString()](const QString& file) {
                   try {
                     OutputFile out(file.toStdString());
                     out.write(csv);
                     out.commit();
                   } catch (const SceneError& error) {
                     show_message(window_, tr("The table cannot be saved"), QString::fromUtf8(error.what()));
                   }
                 });
}

void LabExports::save_bins(const RunPlot& plot) {
  views_.plots.show_now();
  ask_for_export(
      tr("Save the bins"), "bins.csv", tr("Tables (*.csv)"),
      [this, bins = plot.distribution()->bins(), unit = plot.content().x_unit.name](const QString& file) {
        try {
          export_bins(bins, unit.toStdString(), file.toStdString());
        } catch (const SceneError& error) {
          show_message(window_, tr("The bins cannot be saved"), QString::fromUtf8(error.what()));
        }
      });
}

void LabExports::copy_bins(const RunPlot& plot) {
  views_.plots.show_now();
  QStringList lines;
  for (const std::string& line :
       bins_table(plot.distribution()->bins(), plot.content().x_unit.name.toStdString(), '\t'))
    lines << QString::fromStdString(line);
  QGuiApplication::clipboard()->setText(lines.join('\n') + '\n');
}

void LabExports::save_data(const RunPlot* plot) {
  if (!has_run()) return;
  if (plot != nullptr && plot->distribution() != nullptr) return save_bins(*plot);
  const ReadingMarks marks = views_.plots.marks();
  const std::vector<std::shared_ptr<const Frame>> frames = session_.runs().newest();
  std::vector<Method> methods;
  for (const auto& each : frames) methods.push_back(each->method);
  const auto marked = interval_of(marks);
  auto* dialog = new ExportDialog(plot == nullptr ? QString() : plot->content().title, text_of(marked),
                                  names_of(methods), window_);
  ask(dialog, [this, dialog, frames, marks, marked, plot, reference = session_.history().document().reference] {
    const Frame& frame = *frames[dialog->run()];
    QString name = QStringLiteral("run");
    DataExport what = export_of(frame, reference);
    if (dialog->what() == ExportDialog::What::kRun) what.columns = run_columns(*frame.bodies);
    for (const RunPlot* each : views_.plots.plots()) {
      const bool wanted = dialog->what() == ExportDialog::What::kPlots ||
                          (dialog->what() == ExportDialog::What::kPlot && each == plot);
      if (wanted) add_columns(each->content(), what.columns);
    }
    if (dialog->time() == ExportDialog::Time::kShown) {
      what.from = marks.from;
      what.to = std::min(what.to, marks.to);
    } else if (dialog->time() == ExportDialog::Time::kMarked) {
      std::tie(what.from, what.to) = *marked;
      name += ", " + text_of(marked);
    }
    ask_for_export(tr("Save the data"), name + ".csv", tr("Tables (*.csv)"), [this, what](const QString& file) {
      with_progress(
          window_, tr("Save data"), tr("The data cannot be saved"),
          [what, file](const Progress& go_on) { (void)export_data(what, file.toStdString(), go_on); });
    });
  });
}

void LabExports::copy_data(const RunPlot* plot, bool shown) {
  if (!has_run()) return;
  if (plot->distribution() != nullptr) return copy_bins(*plot);
  DataExport what = export_of(*session_.runs().newest().front(), session_.history().document().reference);
  add_columns(plot->content(), what.columns);
  if (shown) {
    what.from = views_.plots.marks().from;
    what.to = std::min(what.to, views_.plots.marks().to);
  }
  struct Text {
    std::string text;
    Copied copied = Copied::kCancelled;
  };
  const auto text = std::make_shared<Text>();
  with_progress(
      window_, tr("Copy data"), tr("The data cannot be copied"),
      [=](const Progress& go_on) { text->copied = carom::copy_data(what, text->text, go_on); },
      [this, text] {
        if (text->copied == Copied::kAll)
          QGuiApplication::clipboard()->setText(QString::fromStdString(text->text));
        if (text->copied == Copied::kTooMany) {
          show_message(window_, tr("Too much for the clipboard"),
                       tr("These are more than %1 rows: “Save the data...” takes them all into a file.")
                           .arg(kMostCopied));
        }
      });
}

// --- the run
// -----------------------------------------------------------------------------------------------------------

void LabExports::save_run() {
  if (!has_run() || !session_.history().may_edit_moment()) return;
  const LabRuns& runs = session_.runs();
  const double time = runs.frame()->time;
  const Preset document = session_.document();
  const std::vector<RunEdit> left = session_.history().edits_left();  // as when the run goes on from there
  const QString suggestion = tr("run, t = %1 s.json").arg(time, 0, 'g', 6);
  ask_for_file(window_, tr("Save the run as it stands"), suggestion, {{tr("Carom presets (*.json)"), "json"}},
               [this, time, frame = runs.newest().front(), document, left](const QString& file) {
                 with_progress(window_, tr("Save the run"), tr("The run cannot be saved"),
                               [=](const Progress& go_on) {
                                 const auto run = run_at(*frame->setup, frame->key_frames, time, go_on);
                                 if (!run) return;
                                 const Preset named = as_named_in(scene_now(*run), left, document);
                                 save_preset(saved_preset(named, *run), file.toStdString());
                               });
               });
}

void LabExports::make_film() {
  if (!has_run()) return;
  Film film;
  film.runs = runs();
  film.to = session_.runs().newest().front()->time > 0.0 ? session_.runs().newest().front()->time
                                                         : session_.document().duration;
  film.speed = session_.runs().speed();
  film.look = views_.scene.look();
  constexpr int kWidth = 1280;  // px
  const QSizeF seen = film.look.camera.viewport;
  film.pixels = QSize(kWidth, static_cast<int>(kWidth * seen.height() / seen.width())) / 2 * 2;
  const QString name =
      session_.name().isEmpty() ? QFileInfo(session_.file()).completeBaseName() : session_.name();
  const QString folder =
      QStandardPaths::writableLocation(QStandardPaths::PicturesLocation) + "/" + name + "-film";
  auto* dialog = new FilmDialog(film, QDir::cleanPath(folder), interval_of(views_.plots.marks()), window_);
  ask(dialog, [this, dialog] { save_film_of(dialog->film(), dialog->folder(), dialog->may_replace()); });
}

void LabExports::save_film_of(const Film& film, const QString& folder, bool replace) {
  const auto frames = std::make_shared<std::optional<FilmFrames>>();
  with_progress(
      window_, tr("Film"), tr("The frames cannot be made"),
      [=, file = session_.file().toStdString()](const Progress& go_on) {
        *frames = save_film(film, folder.toStdString(), replace, {file}, go_on);
      },
      [=, this] {
        if (!*frames) return;
        QString details =
            tr("There, this makes a film of them:") + "\n\n" + encoder_line(film, (*frames)->written);
        for (const std::string& line : remarks(**frames)) details += "\n\n" + QString::fromStdString(line);
        show_message(window_, tr("Film"),
                     tr("%1 frames are in %2.").arg(QString::number((*frames)->written), folder), details);
      });
}

void LabExports::make_report() {
  if (!has_run()) return;
  if (session_.runs().newest().front()->steps == 0 && !session_.runs().newest().front()->playing)
    return show_message(window_, tr("Lab report"), tr("The run has not begun: play it first."));
  session_.runs().when_still(tr("the report waits for the step that is under way"), [this] { write_report(); });
}

void LabExports::write_report() {
  const LabRuns& runs = session_.runs();
  if (!has_run() || runs.newest().front()->steps == 0) return;
  std::optional<LabReport> of_shown;
  if (runs.in_past() && runs.there()) of_shown = report_until(runs.frames());
  auto* dialog = new ReportDialog(report_until(runs.newest()), of_shown, window_);
  ask(dialog, [this, dialog] {
    const LabReport report = dialog->report();
    // So that plots and tables have the same time.
    if (!report.until_shown) session_.runs().go_to_end();
    bodies_->set(since_start(session_.history().bodies(), report.ends.front()));
    views_.ledger.update_from(report.ends.front());
    ask_for_export(tr("Save the report"), file_stem_of(session_) + ".pdf", tr("Documents (*.pdf)"),
                   [this, report](const QString& file) { save_report(report, file); });
  });
}

LabReport LabExports::report_until(const std::vector<std::shared_ptr<const Frame>>& ends) const {
  const Frame& frame = *ends.front();
  LabReport report;
  report.runs = runs();
  for (const auto& each : ends) report.ends.push_back(*each);
  for (std::size_t i = 0; i < ends.size(); ++i) report.ends[i].scales = session_.runs().newest()[i]->scales;
  report.edit_names = names_of_run_edits(session_.edits());
  report.recorded = session_.runs().newest().front()->time;
  report.until_shown = frame.time < report.recorded;
  report.title = QString::fromStdString(session_.document().title);
  report.observe = QString::fromStdString(session_.document().observe);
  report.date = QLocale().toString(QDate::currentDate(), "d MMMM yyyy");
  report.questions = {tr("What did you expect?"), tr("What do you see?"), tr("Why?")};
  std::vector<SeriesPoint<1>> impacts;
  session_.runs().recorders().front()->impulses().read(0.0, frame.time, impacts);
  if (!impacts.empty() && impacts.front().at <= frame.time) report.first_impact = impacts.front().at;
  report.times = report_times(report.runs.front().method, report.first_impact, frame.time);
  report.look = views_.scene.look();
  report.plots = views_.plots.plots();
  report.bodies = bodies_;
  report.ledger = static_cast<const FigureModel*>(views_.ledger.model());
  return report;
}

void LabExports::save_report(const LabReport& report, const QString& file) {
  const auto moments = std::make_shared<std::optional<ReportMoments>>();
  with_progress(
      window_, tr("Lab report"), tr("The report cannot be saved"),
      [=](const Progress& go_on) { *moments = report_moments(report, go_on); },
      [=, this] {
        if (!*moments) return;
        QString error;
        if (!report_pages(report, **moments).save(file, report.title, &error))
          show_message(window_, tr("The report cannot be saved"), error);
      });
}

}  // namespace carom
