#include <QSettings>
#include <QSplitter>

#include "app/lab/document_files.h"
#include "app/lab/drawer.h"
#include "app/lab/lab_window.h"

// What the lab's window remembers from one start to the next: its sizes, its colours and the files of late.
namespace carom {
namespace {

constexpr int kTallEnough = 760;  // px: a lower window starts with the drawer folded

}  // namespace

void LabWindow::standard_layout() {
  // The scene gets what a wider window has more.
  columns_->setSizes({888, 368});
  // A taller window gives the scene more; the drawer shows three rows.
  drawer_->set_folded(false);
  middle_->setSizes({540, 190});
  right_->setSizes({300, 420});
  inspector_action_->setChecked(true);
  drawer_->set_folded(height() < kTallEnough);
}

void LabWindow::restore_layout(const QSettings& settings) {
  files_->set_recent(settings.value("recent").toStringList());
  if (!settings.contains("window")) return;
  restoreGeometry(settings.value("window").toByteArray());
  columns_->restoreState(settings.value("columns").toByteArray());
  middle_->restoreState(settings.value("middle").toByteArray());
  right_->restoreState(settings.value("right").toByteArray());
  inspector_action_->setChecked(settings.value("inspector", true).toBool());
  drawer_->set_folded(settings.value("folded", false).toBool());
}

void LabWindow::keep_layout(QSettings& settings) const {
  settings.setValue("recent", files_->recent());
  settings.setValue("window", saveGeometry());
  settings.setValue("columns", columns_->saveState());
  settings.setValue("middle", middle_->saveState());
  settings.setValue("right", right_->saveState());
  settings.setValue("inspector", inspector_action_->isChecked());
  settings.setValue("folded", drawer_->folded());
  // The system's colours are followed until others are chosen.
  if (theme_chosen_) settings.setValue("dark", theme_.dark);
}

}  // namespace carom
