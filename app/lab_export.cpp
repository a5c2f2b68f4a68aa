#include <QApplication>
#include <QFileDialog>
#include <QMessageBox>
#include <QProgressDialog>
#include <algorithm>

#include "app/export_dialog.h"
#include "app/lab_window.h"
#include "app/run_export.h"
#include "app/run_files.h"
#include "physics/scene/validate.h"
#include "widgets/plot_export.h"
#include "widgets/plot_panel.h"
#include "widgets/run_plot.h"
#include "widgets/scene_view.h"

// What can be taken away from the lab's window.
namespace carom {

QString LabWindow::ask_for_file(const QString& title, const QString& suggestion, const QString& filter,
                                const QString& suffix) {
  QFileDialog dialog(this, title, {}, filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(suffix);  // the dialog's own, so that it asks before this file is replaced
  dialog.selectFile(suggestion);
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().constFirst() : QString();
}

void LabWindow::save_picture_as(const QString& stem,
                                const std::function<bool(const QString&, QString*)>& save) {
  const QString file =
      ask_for_file(tr("Save the picture"), stem + ".png", tr("Pictures (*.png *.svg *.pdf)"), "png");
  QString error;
  if (!file.isEmpty() && !save(file, &error)) {
    QMessageBox::warning(this, tr("The picture cannot be saved"), error.toHtmlEscaped());
  }
}

void LabWindow::save_scene_picture() {
  save_picture_as("scene", [this](const QString& file, QString* error) { return view_->save(file, error); });
}

void LabWindow::save_plot(RunPlot* plot) {
  plots_->show_now();
  save_picture_as(
      "plot", [plot](const QString& file, QString* error) { return save_plot_picture(*plot, file, error); });
}

void LabWindow::save_data(const RunPlot* plot) {
  if (frame_ == nullptr || frame_->log == nullptr) return;
  const ReadingMarks marks = plots_->marks();
  ExportDialog dialog(plot == nullptr ? QString() : plot->content().title, marks.a && marks.b, this);
  if (dialog.exec() != QDialog::Accepted) return;

  // Of the moment when it was asked for, while the run goes on.
  DataExport what{*frame_->log, frame_->key_frames, reference_, frame_->steps, {}, 0.0, frame_->time};
  const auto add = [&what](const std::optional<Quantity>& quantity) {
    if (quantity && std::find(what.columns.begin(), what.columns.end(), *quantity) == what.columns.end())
      what.columns.push_back(*quantity);
  };
  if (dialog.what() == ExportDialog::What::kRun) what.columns = run_columns(*frame_->bodies);
  for (const RunPlot* each : plots_->plots()) {
    const bool wanted = dialog.what() == ExportDialog::What::kPlots ||
                        (dialog.what() == ExportDialog::What::kPlot && each == plot);
    if (!wanted) continue;
    for (const PlotLine& line : each->content().lines) {
      if (!line.curve) continue;
      add(line.curve->x);
      add(line.curve->y);
    }
  }
  if (dialog.time() == ExportDialog::Time::kShown) {
    what.from = marks.from;
    what.to = std::min(what.to, marks.to);
  } else if (dialog.time() == ExportDialog::Time::kMarked) {
    what.from = std::min(*marks.a, *marks.b);
    what.to = std::max(*marks.a, *marks.b);
  }
  const QString file = ask_for_file(tr("Save the data"), "run.csv", tr("Tables (*.csv)"), "csv");
  if (file.isEmpty()) return;

  QProgressDialog progress(tr("Going through the run once more"), tr("Cancel"), 0, 1000, this);
  progress.setWindowTitle(tr("Save data"));
  progress.setWindowModality(Qt::WindowModal);
  try {
    (void)export_data(what, file.toStdString(), [&](double share) {
      progress.setValue(static_cast<int>(1000.0 * share));
      QApplication::processEvents();
      return !progress.wasCanceled();
    });
  } catch (const SceneError& error) {
    QMessageBox::warning(this, tr("The data cannot be saved"), QString::fromUtf8(error.what()).toHtmlEscaped());
  }
}

}  // namespace carom
