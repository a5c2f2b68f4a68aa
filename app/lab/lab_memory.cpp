#include <QAction>
#include <QSettings>

#include "app/lab/document_files.h"
#include "app/lab/drawer.h"
#include "app/lab/lab_window.h"
#include "app/lab/panel_docks.h"
#include "widgets/edit/bodies_sheet.h"

// What the lab's window remembers from one start to the next: its sizes, its colours and the files of late.
namespace carom {
namespace {

constexpr int kTallEnough = 760;  // px: a lower window starts with the drawer folded

}  // namespace

void LabWindow::standard_layout() {
  docks_->reset();
  drawer_->set_folded(height() < kTallEnough);
  pin_action_->setChecked(true);
}

void LabWindow::restore_layout(const QSettings& settings) {
  files_->set_recent(settings.value("recent").toStringList());
  run_before_->setChecked(settings.value("run_before", true).toBool());
  slow_action_->setChecked(settings.value("slow_near_impacts", false).toBool());
  pin_action_->setChecked(settings.value("list_pinned", true).toBool());
  if (settings.contains("columns")) sheet_->show_columns(settings.value("columns").toStringList());
  if (!settings.contains("window")) return;
  restoreGeometry(settings.value("window").toByteArray());
  docks_->restore(settings);
}

void LabWindow::keep_layout(QSettings& settings) const {
  settings.setValue("recent", files_->recent());
  settings.setValue("window", saveGeometry());
  docks_->keep(settings);
  settings.setValue("run_before", run_before_->isChecked());
  settings.setValue("slow_near_impacts", slow_action_->isChecked());
  settings.setValue("list_pinned", pin_action_->isChecked());
  settings.setValue("columns", sheet_->shown_columns());
  // The system's colours are followed until others are chosen.
  if (theme_chosen_) settings.setValue("dark", theme_.dark);
}

}  // namespace carom
