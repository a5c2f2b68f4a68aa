#include <QApplication>
#include <QClipboard>
#include <QDate>
#include <QDir>
#include <QFileDialog>
#include <QLocale>
#include <QPointer>
#include <QStandardPaths>
#include <algorithm>
#include <functional>

#include "app/export/bins_export.h"
#include "app/export/film.h"
#include "app/export/lab_report.h"
#include "app/export/run_export.h"
#include "app/export/run_files.h"
#include "app/export/run_progress.h"
#include "app/lab/export_dialog.h"
#include "app/lab/film_dialog.h"
#include "app/lab/lab_window.h"
#include "app/lab/report_dialog.h"
#include "physics/files/output_set.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/preset/saved_preset.h"
#include "physics/scene/validate.h"
#include "physics/world/run_state.h"
#include "widgets/plot/plot_export.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/run_plot.h"
#include "widgets/run/ledger_table.h"
#include "widgets/run/run_tables.h"
#include "widgets/scene/scene_view.h"
#include "widgets/theme/method_names.h"
#include "widgets/theme/plain_text.h"

// What can be taken away from the lab's window.
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

}  // namespace

QString LabWindow::ask_for_file(const QString& title, const QString& suggestion, const QString& filter,
                                const QString& suffix) {
  QFileDialog dialog(this, title, {}, filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(suffix);  // the dialog's own, so that it asks before this file is replaced
  dialog.selectFile(suggestion);
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().constFirst() : QString();
}

QString LabWindow::ask_for_export(const QString& title, const QString& suggestion, const QString& filter,
                                  const QString& suffix) {
  const QString file = ask_for_file(title, suggestion, filter, suffix);
  if (file.isEmpty()) return {};
  try {
    OutputSet({session_.file().toStdString()}).reserve(file.toStdString());
    return file;
  } catch (const SceneError& error) {
    tell(this, title, QString::fromUtf8(error.what()));
    return {};
  }
}

void LabWindow::save_picture_as(const QString& stem,
                                const std::function<bool(const QString&, QString*)>& save) {
  const QString file =
      ask_for_export(tr("Save the picture"), stem + ".png", tr("Pictures (*.png *.svg *.pdf)"), "png");
  QString error;
  if (!file.isEmpty() && !save(file, &error)) {
    tell(this, tr("The picture cannot be saved"), error);
  }
}

void LabWindow::save_scene_picture() {
  save_picture_as("scene", [this](const QString& file, QString* error) { return view_->save(file, error); });
}

void LabWindow::save_plot(RunPlot* plot) {
  plots_->show_now();
  save_picture_as("plot", [plot = QPointer<RunPlot>(plot)](const QString& file, QString* error) {
    return plot == nullptr || save_plot_picture(*plot, file, error);
  });
}

void LabWindow::copy_scene_picture() { QGuiApplication::clipboard()->setImage(view_->picture()); }

void LabWindow::save_bins(const RunPlot& plot) {
  // As they stand now: the run goes on while the file is chosen.
  plots_->show_now();
  const std::vector<ShownBins> bins = plot.distribution()->bins();
  const QString file = ask_for_export(tr("Save the bins"), "bins.csv", tr("Tables (*.csv)"), "csv");
  if (file.isEmpty()) return;
  try {
    export_bins(bins, plot.content().x_unit.toStdString(), file.toStdString());
  } catch (const SceneError& error) {
    tell(this, tr("The bins cannot be saved"), QString::fromUtf8(error.what()));
  }
}

void LabWindow::save_run() {
  if (frame() == nullptr || frame()->log == nullptr) return;
  // Of the moment when it was asked for, while the run goes on.
  const std::shared_ptr<const Frame> frame = this->frame();
  const Preset document = preset();
  const QString file =
      ask_for_file(tr("Save the run as it stands"), "run.json", tr("Carom presets (*.json)"), "json");
  if (file.isEmpty()) return;
  RunProgress progress(tr("Save the run"), this);
  try {
    if (const auto run = run_at(*frame->log, frame->key_frames, frame->time, frame->steps, std::ref(progress)))
      save_preset(saved_preset(document, *run), file.toStdString());
  } catch (const SceneError& error) {
    tell(this, tr("The run cannot be saved"), QString::fromUtf8(error.what()));
  }
}

void LabWindow::save_data(const RunPlot* plot) {
  if (frame() == nullptr || frame()->log == nullptr) return;
  if (plot != nullptr && plot->distribution() != nullptr) return save_bins(*plot);
  const ReadingMarks marks = plots_->marks();
  // Of the moment when it was asked for, while the run goes on.
  const std::vector<std::shared_ptr<const Frame>> frames = session_.frames();
  std::vector<Method> methods;
  for (const auto& each : frames) methods.push_back(each->method);
  ExportDialog dialog(plot == nullptr ? QString() : plot->content().title, marks.a && marks.b,
                      names_of(methods), this);
  if (dialog.exec() != QDialog::Accepted) return;

  const Frame& frame = *frames[dialog.run()];
  DataExport what{*frame.log, frame.key_frames, session_.reference(), frame.steps, {}, 0.0, frame.time};
  if (dialog.what() == ExportDialog::What::kRun) what.columns = run_columns(*frame.bodies);
  for (const RunPlot* each : plots_->plots()) {
    const bool wanted = dialog.what() == ExportDialog::What::kPlots ||
                        (dialog.what() == ExportDialog::What::kPlot && each == plot);
    if (wanted) add_columns(each->content(), what.columns);
  }
  if (dialog.time() == ExportDialog::Time::kShown) {
    what.from = marks.from;
    what.to = std::min(what.to, marks.to);
  } else if (dialog.time() == ExportDialog::Time::kMarked) {
    what.from = std::min(*marks.a, *marks.b);
    what.to = std::max(*marks.a, *marks.b);
  }
  const QString file = ask_for_export(tr("Save the data"), "run.csv", tr("Tables (*.csv)"), "csv");
  if (file.isEmpty()) return;

  RunProgress progress(tr("Save data"), this);
  try {
    (void)export_data(what, file.toStdString(), std::ref(progress));
  } catch (const SceneError& error) {
    tell(this, tr("The data cannot be saved"), QString::fromUtf8(error.what()));
  }
}

void LabWindow::copy_data(const RunPlot* plot, bool shown) {
  if (frame() == nullptr || frame()->log == nullptr) return;
  if (plot->distribution() != nullptr) {
    plots_->show_now();
    QStringList lines;
    for (const std::string& line :
         bins_table(plot->distribution()->bins(), plot->content().x_unit.toStdString(), '\t'))
      lines << QString::fromStdString(line);
    QGuiApplication::clipboard()->setText(lines.join('\n') + '\n');
    return;
  }
  DataExport what{*frame()->log, frame()->key_frames, session_.reference(), frame()->steps, {},
                  0.0,           frame()->time};
  add_columns(plot->content(), what.columns);
  if (shown) {
    what.from = plots_->marks().from;
    what.to = std::min(what.to, plots_->marks().to);
  }
  RunProgress progress(tr("Copy data"), this);
  std::string text;
  const Copied copied = carom::copy_data(what, text, std::ref(progress));
  if (copied == Copied::kAll) QGuiApplication::clipboard()->setText(QString::fromStdString(text));
  if (copied == Copied::kTooMany) {
    tell(this, tr("Too much for the clipboard"),
         tr("These are more than %1 rows: “Save the data...” takes them all into a file.").arg(kMostCopied));
  }
}

std::vector<RunLog> LabWindow::runs() const {
  std::vector<RunLog> all;
  for (const auto& frame : session_.frames()) all.push_back(*frame->log);
  return all;
}

void LabWindow::make_film() {
  if (frame() == nullptr || frame()->log == nullptr) return;
  Film film;
  film.runs = runs();
  film.to = frame()->time > 0.0 ? frame()->time : preset().duration;
  film.speed = session_.speed();
  film.look = view_->look();
  constexpr int kWidth = 1280;  // px
  const QSizeF seen = film.look.camera.viewport;
  film.pixels = QSize(kWidth, static_cast<int>(kWidth * seen.height() / seen.width())) / 2 * 2;
  const QString folder =
      QStandardPaths::writableLocation(QStandardPaths::PicturesLocation) + "/" +
      (session_.name().isEmpty() ? QFileInfo(session_.file()).completeBaseName() : session_.name()) + "-film";
  FilmDialog dialog(film, QDir::cleanPath(folder), this);
  if (dialog.exec() != QDialog::Accepted) return;
  film = dialog.film();
  std::optional<FilmFrames> frames;
  try {
    RunProgress progress(tr("Film"), this);
    frames = save_film(film, dialog.folder().toStdString(), dialog.may_replace(),
                       {session_.file().toStdString()}, std::ref(progress));
  } catch (const SceneError& error) {
    tell(this, tr("The frames cannot be made"), QString::fromUtf8(error.what()));
    return;
  }
  if (!frames) return;
  QString details = tr("There, this makes a film of them:") + "\n\n" + encoder_line(film, frames->written);
  for (const std::string& line : remarks(*frames)) details += "\n\n" + QString::fromStdString(line);
  tell(this, tr("Film"), tr("%1 frames are in %2.").arg(QString::number(frames->written), dialog.folder()),
       details);
}

void LabWindow::make_report() {
  if (frame() == nullptr || frame()->log == nullptr) return;
  if (frame()->steps == 0 && !frame()->playing) {
    tell(this, tr("Lab report"), tr("The run has not begun: play it first."));
    return;
  }
  // So that plots and tables are of one moment.
  session_.when_still(tr("the report waits for the step that is under way"), [this] { write_report(); });
}

void LabWindow::write_report() {
  if (frame() == nullptr || frame()->log == nullptr || frame()->steps == 0) return;
  bodies_->update_from(*frame(), session_.bodies());
  ledger_->update_from(*frame());
  LabReport report;
  report.runs = runs();
  for (const auto& frame : session_.frames()) report.ends.push_back(*frame);
  report.title = QString::fromStdString(preset().title);
  report.observe = QString::fromStdString(preset().observe);
  report.date = QLocale().toString(QDate::currentDate(), "d MMMM yyyy");
  report.questions = {tr("What did you expect?"), tr("What do you see?"), tr("Why?")};
  std::vector<SeriesPoint<1>> impacts;
  session_.recorders().front()->impulses().read(0.0, frame()->time, impacts);
  if (!impacts.empty()) report.first_impact = impacts.front().at;
  report.times = report_times(report.runs.front().start.method, report.first_impact, frame()->time);
  report.look = view_->look();
  report.plots = plots_->plots();
  report.bodies = static_cast<const FigureModel*>(bodies_->model());
  report.ledger = static_cast<const FigureModel*>(ledger_->model());
  ReportDialog dialog(report, this);
  if (dialog.exec() != QDialog::Accepted) return;
  const QString file = ask_for_export(tr("Save the report"), "report.pdf", tr("Documents (*.pdf)"), "pdf");
  if (file.isEmpty()) return;

  report = dialog.report();
  RunProgress progress(tr("Lab report"), this);
  const std::optional<PrintPages> pages = report_pages(report, std::ref(progress));
  QString error;
  if (pages && !pages->save(file, report.title, &error)) tell(this, tr("The report cannot be saved"), error);
}

}  // namespace carom
