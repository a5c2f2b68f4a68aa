#pragma once

#include <QMainWindow>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/lab/scrubbing.h"
#include "app/lab/session.h"
#include "physics/preset/preset.h"
#include "widgets/theme/theme.h"

class QAction;
class QKeySequence;
class QLabel;
class QMenu;
class QToolBar;
class QToolButton;
class QSettings;

namespace carom {

struct Paste;
struct Regrouping;
class BeforeAfterPanel;
class BodiesSheet;
class ComparePanel;
class DocumentFiles;
class Drawer;
class ExperimentList;
class ExperimentPreview;
class ImpactsPanel;
class GroupTools;
class Inspector;
class LabExports;
class MarkedInterval;
class LedgerTable;
class MethodBar;
class NoticeBar;
class PanelDocks;
class PlotPanel;
class ReadingTable;
class SceneChips;
class SceneView;
class StopEditor;
class StudyPanel;
class ToolColumn;
class TransportBar;
class WorkRecovery;

// The lab: experiments, scene over transport over tables, plots. It shows a session, and forwards the user's
// actions to it.
class LabWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit LabWindow(const Theme& theme);
  ~LabWindow() override;

  // Opens a built-in experiment or a file; on an error shows a message and keeps the present scene. Returns
  // true if it is shown at once: the user is asked about unsaved changes first.
  bool open(const std::string& file_or_name);
  // Shows a scene with a known source; `name` marks it in the list.
  void show_scene(const Preset& preset, const QString& name, const QString& file);
  // Runs to `time` as fast as possible and returns when it is shown, or when the run is lost.
  void run_until(double time);
  // Keeps unsaved work in `folder` from now on, at most ten seconds behind, and offers work left there by
  // windows that ended unexpectedly.
  void keep_work(const QString& folder);

  // What is remembered from one start to the next (lab_memory.cpp).
  void restore_layout(const QSettings& settings);
  void keep_layout(QSettings& settings) const;

  void set_theme(const Theme& theme);
  [[nodiscard]] SceneView& scene_view() { return *view_; }
  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] std::shared_ptr<const Frame> frame() const { return session_.runs().frame(); }
  [[nodiscard]] const Preset& preset() const { return session_.document(); }

 public slots:
  bool save();      // true if written; a document without a file asks for one
  void keep_now();  // changes since the last time, if keep_work() was called

 protected:
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  // The layout (lab_layout.cpp).
  void make_body();
  void open_list(bool open);
  [[nodiscard]] bool list_pinned() const;
  void place_list();
  void standard_layout();
  [[nodiscard]] QWidget* make_scene();
  void make_docks();
  void make_drawer();
  void connect_views();
  void connect_timeline();
  // Stops (lab_flags.cpp).
  void connect_stops();
  void show_stops();
  void edit_stops(std::optional<std::size_t> stop);
  // The marks A and B (lab_marks.cpp).
  void connect_marks();
  void mark_shown_moment(bool second);
  void show_before_after();
  // Editing by hand (lab_editing.cpp).
  void connect_edits();
  void show_selection();
  void drop(const Vec2& at, std::optional<double> radius);  // m
  void select_drawn(const SceneEdits& edits);
  void edit_bodies(const SceneEdits& edits, const QString& name, int drag);
  void say_refusal(const QString& why);
  void say_of_edit(QString sentence);
  void forget_refusal();
  void show_aim();
  void new_document();
  void with_scene(const QString& what, const std::function<void(const Scene&)>& then);
  void copy_selection();
  void cut_selection();
  void paste();
  void paste_at(const QPointF& at);  // px of the scene view
  void duplicate_selection();
  void put(const Scene& scene, const Paste& paste, const QString& what);
  void join_selection();
  void take_selection_apart();
  void regroup(const Regrouping& made);
  void select_again(const std::vector<std::string>& names);
  void keep_selected(const SceneEdits& edits);
  // The menu of what is under the mouse in the scene (scene_menu.cpp).
  void show_scene_menu(const QPoint& at);
  void fill_menu_of_bodies(QMenu& menu);
  void add_plots_of(QMenu& menu, const std::string& body);
  void add_stops_of(QMenu& menu, const Body& now);
  void fill_menu_of_space(QMenu& menu, const QPoint& at);
  void inspect();
  // The tools of the scene (lab_tools.cpp).
  void make_tools_menu();
  void show_tool(const QAction& action, bool kept);
  [[nodiscard]] QWidget* make_tool_column();
  // Menus and the tool bar (lab_menus.cpp).
  QAction* add_action(QMenu* menu, const QString& icon, const QString& text, const QKeySequence& key,
                      const std::function<void()>& slot);
  void make_file_menu();
  void make_edit_menu();
  QMenu* add_align_menu(QMenu* to);
  void make_view_menu();
  void add_toggles(QMenu* view);
  void add_places_menu(QMenu* to);
  void make_run_menus();
  void make_starts_menu(QMenu* to);
  void make_start_chip_menu();
  void make_help_menu();
  void make_tool_bar();
  // Buttons of the tool bar that a narrow one has in a menu.
  struct FoldedGroup {
    std::vector<QAction*> actions{};
    QAction* before = nullptr;  // which they stand
    bool folded = false;
  };
  void fold(FoldedGroup& group, bool folds);
  void unfold_tool_bar();
  void fold_tool_bar(int missing);
  void name_experiment();

  void connect_session();
  void show_document();
  void preview(const QString& name);
  void place_preview();
  void leave_preview();
  void close_list();
  void show_about();
  void show_title();
  void say_saved(const QString& file);
  void say_for_a_while(const QString& text);
  void show_frame();
  void show_preparing();
  void show_run_before();  // lab_run_before.cpp
  void show_notices();
  void compare_usual();
  void set_playing(bool playing);

  Theme theme_;
  Session session_;
  DocumentFiles* files_ = nullptr;
  LabExports* exports_ = nullptr;
  WorkRecovery* recovery_ = nullptr;

  ExperimentPreview* preview_ = nullptr;
  ExperimentList* list_ = nullptr;  // a column of a wide window (list_pinned()), else over the scene
  QAction* list_action_ = nullptr;
  QAction* pin_action_ = nullptr;       // the list is a column where there is room
  QToolButton* list_button_ = nullptr;  // with the name of the open experiment
  QAction* name_in_bar_ = nullptr;      // that button
  QAction* undo_ = nullptr;
  QAction* first_start_ = nullptr;
  QAction* run_before_ = nullptr;   // the run before is shown
  QAction* slow_action_ = nullptr;  // near impacts
  SceneView* view_ = nullptr;
  SceneChips* chips_ = nullptr;
  TransportBar* transport_ = nullptr;
  StopEditor* stop_editor_ = nullptr;
  Inspector* inspector_ = nullptr;
  GroupTools* group_ = nullptr;  // in the inspector
  QAction* inspector_action_ = nullptr;
  PlotPanel* plots_ = nullptr;
  Drawer* drawer_ = nullptr;
  PanelDocks* docks_ = nullptr;     // the scene with inspector, plots and drawer round it
  QAction* left_action_ = nullptr;  // inspector and plots stand at the left
  BodiesSheet* sheet_ = nullptr;
  BeforeAfterPanel* before_after_ = nullptr;
  ImpactsPanel* impacts_ = nullptr;
  MarkedInterval* marked_ = nullptr;
  LedgerTable* ledger_ = nullptr;
  ReadingTable* reading_ = nullptr;
  ComparePanel* compare_ = nullptr;
  StudyPanel* study_ = nullptr;
  QLabel* about_ = nullptr;
  NoticeBar* restore_bar_ = nullptr;
  NoticeBar* lost_bar_ = nullptr;  // why a run is lost
  QTimer aim_time_;                // until the line to the first impact goes
  QString lost_;                   // its text; empty while no run is lost
  QString said_;                   // for a while
  QString said_of_edit_;           // what of that is about the last edit
  MethodBar* methods_ = nullptr;
  QAction* theme_action_ = nullptr;
  bool theme_chosen_ = false;  // by the user
  Scrubbing scrubbing_{session_.runs()};
  ToolColumn* tool_column_ = nullptr;
  QToolBar* bar_ = nullptr;
  FoldedGroup switches_;
  FoldedGroup files_in_bar_;
  QAction* more_ = nullptr;                                 // the menu of those that are folded
  int name_room_ = 0;                                       // px, of the name of the experiment
  std::vector<std::pair<QAction*, QString>> icon_actions_;  // with the icon's name, redrawn with the theme
};

}  // namespace carom
