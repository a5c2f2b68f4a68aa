#pragma once

#include <QWidget>

class QSplitter;
class QTabBar;

namespace carom {

class FloatingPanel;

// The right column of the lab: the inspector over the plots or, where there is little room, two tabs.
class RightColumn : public QWidget {
  Q_OBJECT

 public:
  RightColumn(QWidget* inspector, QWidget* plots, QWidget* parent = nullptr);

  void set_tabbed(bool tabbed);
  [[nodiscard]] bool tabbed() const { return tabbed_; }

  // Over the plots the inspector opens and closes; of two tabs one is always open.
  void show_inspector(bool shown);
  [[nodiscard]] bool shows_inspector() const { return has_tabs() ? inspector_tab_ : inspector_open_; }

  // Each can stand in a window of its own; the other one then has the column.
  [[nodiscard]] FloatingPanel& inspector_window() const { return *inspector_window_; }
  [[nodiscard]] FloatingPanel& plots_window() const { return *plots_window_; }

  // What is remembered: how tall the inspector is over the plots, in px; whether it is open over them; whether
  // its tab is the open one.
  struct Places {
    int inspector_height = 300;
    bool inspector_open = true;
    bool inspector_tab = true;
  };
  [[nodiscard]] Places places() const;
  void set_places(const Places& places);

 signals:
  void inspectorShown(bool shown);

 private:
  [[nodiscard]] bool has_tabs() const;
  void place();
  void keep_height();

  QTabBar* tabs_;
  QSplitter* splitter_;
  FloatingPanel* inspector_window_;
  FloatingPanel* plots_window_;
  int inspector_height_ = Places().inspector_height;
  bool tabbed_ = false;
  bool inspector_open_ = true;
  bool inspector_tab_ = true;
};

}  // namespace carom
