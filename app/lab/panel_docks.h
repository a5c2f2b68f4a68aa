#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <optional>

class QSettings;
class QSplitter;
class QTabBar;

namespace carom {

class Drawer;
class DropMark;
class FloatingPanel;
class PanelDrag;

// The scene and the panels round it. Each panel is docked at the left, at the right or under the scene, or
// stands in a window of its own; a drag of its head moves it. Panels of one dock stand one over the other,
// inspector, plots, drawer. Where there is little room, inspector and plots at one side are two tabs.
class PanelDocks : public QWidget {
  Q_OBJECT

 public:
  enum Panel { kInspector, kPlots, kDrawer, kPanels };
  enum Dock { kLeft, kRight, kBottom, kDocks };

  PanelDocks(QWidget* scene, QWidget* inspector, QWidget* plots, Drawer* drawer, QWidget* parent = nullptr);

  // Docks a panel there, out of its window if it has one.
  void put(Panel panel, Dock dock);
  [[nodiscard]] Dock dock_of(Panel panel) const { return places_[panel].dock; }
  [[nodiscard]] FloatingPanel& window_of(Panel panel) const { return *places_[panel].window; }
  // A part of a panel's head where it can be taken, if `in_head` holds for the place (px).
  void add_head(Panel panel, QWidget* head, std::function<bool(const QPoint&)> in_head);
  // Inspector and plots.
  void put_at_left(bool left);
  [[nodiscard]] bool at_left() const { return dock_of(kInspector) == kLeft && dock_of(kPlots) == kLeft; }
  // Everything where it stands in a new window; the drawer is unfolded.
  void reset();

  void set_tabbed(bool tabbed);
  [[nodiscard]] bool tabbed() const { return tabbed_; }
  // Over the plots the inspector opens and closes; of two tabs one is always open.
  void show_inspector(bool shown);
  [[nodiscard]] bool shows_inspector() const { return has_tabs() ? inspector_tab_ : inspector_open_; }

  // All places and sizes.
  void restore(const QSettings& settings);
  void keep(QSettings& settings);

 signals:
  void inspectorShown(bool shown);
  void docksChanged();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  struct Place {
    QWidget* panel = nullptr;
    FloatingPanel* window = nullptr;
    PanelDrag* drag = nullptr;
    Dock dock = kRight;
    int height = 0;  // px, beside a panel that takes the rest; 0: the standard one
  };
  struct Side {
    QWidget* column = nullptr;
    QTabBar* tabs = nullptr;
    QSplitter* panels = nullptr;
    double share = 0.0;  // of the width
  };

  void make_side(Dock dock);
  void add_panel(Panel panel, QWidget* widget, const QString& name, const QString& title);
  void insert(Panel panel);
  [[nodiscard]] QSplitter* splitter(Dock dock) const;
  [[nodiscard]] bool stands(Panel panel, Dock dock) const;  // docked there and shown
  [[nodiscard]] bool has_tabs() const;
  [[nodiscard]] QWidget* flexible(Dock dock) const;      // takes the height that the others leave
  [[nodiscard]] int standard_height(Panel panel) const;  // px
  [[nodiscard]] int height_of(Panel panel) const;        // px
  void keep_heights();
  void keep_widths();
  void place();
  void size_widths();
  void size_heights();
  // A drag.
  [[nodiscard]] std::optional<Dock> target(const QPoint& at) const;  // empty: a window
  [[nodiscard]] QRect target_rect(Dock dock) const;
  void show_target(Panel panel, const QPoint& global);
  void drop(Panel panel, const QPoint& global);

  QWidget* scene_;
  Drawer* drawer_;
  QSplitter* columns_;
  QSplitter* middle_;  // scene, and panels under it
  DropMark* mark_;
  std::array<Side, 2> sides_;  // left, right
  std::array<Place, kPanels> places_;
  int sized_for_ = -1;  // which columns had their widths set last
  int tabs_width_;      // px, of a side column where there is little room
  bool tabbed_ = false;
  bool inspector_open_ = true;
  bool inspector_tab_ = true;
};

}  // namespace carom
