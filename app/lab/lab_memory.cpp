#include <QSettings>
#include <QSplitter>

#include "app/lab/document_files.h"
#include "app/lab/drawer.h"
#include "app/lab/floating_panel.h"
#include "app/lab/lab_window.h"
#include "app/lab/right_column.h"

// What the lab's window remembers from one start to the next: its sizes, its colours and the files of late.
namespace carom {
namespace {

constexpr double kRightShare = 0.291;  // of the width
constexpr int kTallEnough = 760;       // px: a lower window starts with the drawer folded

}  // namespace

void LabWindow::standard_layout() {
  for (FloatingPanel* each : floating_) each->set_floating(false);
  left_action_->setChecked(false);
  // The scene gets what a wider window has more.
  right_share_ = kRightShare;
  place_right();
  size_right();
  // A taller window gives the scene more; the drawer shows three rows.
  drawer_->set_folded(false);
  middle_->setSizes({540, 190});
  right_->set_places({});
  drawer_->set_folded(height() < kTallEnough);
}

void LabWindow::restore_layout(const QSettings& settings) {
  files_->set_recent(settings.value("recent").toStringList());
  if (!settings.contains("window")) return;
  restoreGeometry(settings.value("window").toByteArray());
  right_share_ = settings.value("right_share", kRightShare).toDouble();
  place_right();
  left_action_->setChecked(settings.value("panels_left", false).toBool());
  columns_->restoreState(settings.value("columns").toByteArray());
  middle_->restoreState(settings.value("middle").toByteArray());
  RightColumn::Places places;
  places.inspector_height = settings.value("inspector_height", places.inspector_height).toInt();
  places.inspector_open = settings.value("inspector", places.inspector_open).toBool();
  places.inspector_tab = settings.value("inspector_tab", places.inspector_tab).toBool();
  right_->set_places(places);
  drawer_->set_folded(settings.value("folded", false).toBool());
  for (FloatingPanel* each : floating_) each->restore(settings);
}

void LabWindow::keep_layout(QSettings& settings) const {
  settings.setValue("recent", files_->recent());
  settings.setValue("window", saveGeometry());
  settings.setValue("columns", columns_->saveState());
  settings.setValue("middle", middle_->saveState());
  settings.setValue("right_share", right_share_);
  settings.setValue("panels_left", right_is_left());
  const RightColumn::Places places = right_->places();
  settings.setValue("inspector_height", places.inspector_height);
  settings.setValue("inspector", places.inspector_open);
  settings.setValue("inspector_tab", places.inspector_tab);
  settings.setValue("folded", drawer_->folded());
  for (const FloatingPanel* each : floating_) each->keep(settings);
  // The system's colours are followed until others are chosen.
  if (theme_chosen_) settings.setValue("dark", theme_.dark);
}

}  // namespace carom
