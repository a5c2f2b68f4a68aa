#pragma once

#include <QMainWindow>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/lab/autosave.h"
#include "app/lab/session.h"
#include "physics/preset/preset.h"
#include "widgets/theme/theme.h"

class QAction;
class QLabel;
class QMenu;
class QTabWidget;
class QToolBar;
class QToolButton;

namespace carom {

class BodiesTable;
class ComparePanel;
class ExperimentList;
class ImpactsTable;
class LedgerTable;
class NoticeBar;
class PlotPanel;
class ReadingTable;
class RunPlot;
class SceneView;
class StudyPanel;
class TransportBar;

// The lab: experiments, scene over transport over tables, plots. It shows a session, and forwards to it what
// the user does.
class LabWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit LabWindow(const Theme& theme);
  ~LabWindow() override;

  // Opens a built-in experiment or a file, or says in a message why not and keeps the scene that is there.
  bool open(const std::string& file_or_name);
  // Shows a scene whose source is known; `name` marks it in the list.
  void show_scene(const Preset& preset, const QString& name, const QString& file);
  // Runs on to `time` as fast as it goes and returns when it is shown, or when the run is lost before.
  void run_until(double time);
  // Keeps unsaved work in `folder` from now on, at most ten seconds behind, and offers what lies there of
  // windows that ended unexpectedly.
  void keep_work(const QString& folder);

  void set_theme(const Theme& theme);
  [[nodiscard]] SceneView& scene_view() { return *view_; }
  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] std::shared_ptr<const Frame> frame() const { return session_.frame(); }
  [[nodiscard]] const Preset& preset() const { return session_.document(); }

 public slots:
  bool save();
  bool saveAs();
  void keep_now();  // what has changed since it was last kept, if keep_work() was called

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void make_actions();
  void make_menus();
  void make_tool_bar();
  void make_body();
  void fill_library();
  void draw_thumbnails();

  void connect_session();
  void show_frame();
  void show_method();  // as wide as the tool bar has room for
  // What the edited scene needs: chips, ledger and the methods that it allows.
  void show_needs();
  void place_chips();
  bool eventFilter(QObject* watched, QEvent* event) override;

  void choose_file();
  bool may_discard();  // asks to save what the user changed; false: stay
  bool write(const QString& file);
  void compare_usual();
  void choose_step();
  void set_playing(bool playing);
  void spawn(double x, double y);

  // What can be taken away (lab_export.cpp); each asks for a file and tells in a message what went wrong.
  [[nodiscard]] QString ask_for_file(const QString& title, const QString& suggestion, const QString& filter,
                                     const QString& suffix);
  // The same for what is not the preset, which therefore never takes the place of the open one.
  [[nodiscard]] QString ask_for_export(const QString& title, const QString& suggestion, const QString& filter,
                                       const QString& suffix);
  void save_picture_as(const QString& stem, const std::function<bool(const QString&, QString*)>& save);
  void save_scene_picture();
  void save_plot(RunPlot* plot);
  void save_bins(const RunPlot& plot);  // of a histogram
  void save_run();                      // a preset that goes on from the moment that is shown
  void save_data(const RunPlot* plot);  // nullptr: of no plot in particular
  void copy_data(const RunPlot* plot, bool shown);
  void copy_scene_picture();
  void make_film();
  void make_report();
  void write_report();
  [[nodiscard]] std::vector<RunLog> runs() const;
  void show_preparing();
  void show_notices();
  void show_lost();
  // Unsaved work (lab_work.cpp).
  void offer_work();
  void restore_work();
  void discard_work();

  Theme theme_;
  Session session_;
  QTimer keeping_;
  std::unique_ptr<Autosave> autosave_;
  std::vector<KeptWork> offered_;
  QString not_kept_;        // why unsaved work is not kept; empty if it is
  std::uint64_t kept_ = 0;  // the session's revision then

  ExperimentList* list_ = nullptr;
  SceneView* view_ = nullptr;
  TransportBar* transport_ = nullptr;
  PlotPanel* plots_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  BodiesTable* bodies_ = nullptr;
  ImpactsTable* impacts_ = nullptr;
  LedgerTable* ledger_ = nullptr;
  ReadingTable* reading_ = nullptr;
  ComparePanel* compare_ = nullptr;
  StudyPanel* study_ = nullptr;
  QLabel* about_ = nullptr;
  NoticeBar* restore_bar_ = nullptr;
  NoticeBar* lost_bar_ = nullptr;  // why a run can't go on
  QString lost_;                   // as it was said last; empty while no run is lost
  QWidget* chips_ = nullptr;
  QLabel* needs_chip_ = nullptr;
  QString needs_;   // whole, where the chip is elided
  QString status_;  // likewise
  QLabel* time_chip_ = nullptr;
  QLabel* speed_chip_ = nullptr;
  QLabel* status_chip_ = nullptr;
  QLabel* position_ = nullptr;
  QToolBar* tool_bar_ = nullptr;
  QToolButton* integrator_button_ = nullptr;
  QToolButton* impacts_button_ = nullptr;
  QToolButton* contacts_button_ = nullptr;
  QToolButton* step_button_ = nullptr;
  QToolButton* plots_button_ = nullptr;
  QMenu* integrators_ = nullptr;
  QMenu* steps_ = nullptr;
  QMenu* tolerances_ = nullptr;
  QAction* theme_action_ = nullptr;
  std::vector<std::pair<QAction*, QString>> icon_actions_;  // with the icon's name, drawn anew with the theme
};

}  // namespace carom
