#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "physics/preset/preset.h"
#include "physics/study/study.h"
#include "widgets/theme/theme.h"

class QBoxLayout;
class QLabel;
class QProgressBar;
class QStackedWidget;
class QToolButton;

namespace carom {

class ElidedLabel;
class ErrorPlot;
class OrderTable;

// The study of the scene that is shown: every integrator, both choices for impacts, a row of steps. It runs on
// threads of its own while the lab goes on; points come as runs end. What was studied stays when another scene
// is shown or this one is edited, and says of which scene it is, until the next study.
class StudyPanel : public QWidget {
  Q_OBJECT

 public:
  explicit StudyPanel(const Theme& theme, QWidget* parent = nullptr);
  ~StudyPanel() override;  // stops what runs

  void set_theme(const Theme& theme);
  // Another scene, with the name of its preset. Its method tells around which step to study.
  void set_scene(const Preset& preset, const QString& name);
  // The same scene with bodies or another method; a study's steps stay where the preset has its own.
  void edit_scene(const Preset& preset);

  // What the study has found so far: by its suffix the table with all digits (.csv) or the picture (.svg, .pdf,
  // .png). The file is replaced only when the whole is ready; else the answer is false and `error` says why.
  [[nodiscard]] bool save(const QString& file, QString* error) const;

  [[nodiscard]] bool running() const { return study_ != nullptr; }
  [[nodiscard]] const StudySoFar& so_far() const { return so_far_; }
  [[nodiscard]] ErrorPlot& plot() { return *plot_; }
  // Whether so_far() is about the scene that is shown, as it is shown, but for its method.
  [[nodiscard]] bool of_the_scene_shown() const { return current_; }
  // One line: what was compared with what, and which scene's it is.
  [[nodiscard]] QString words() const;

  void start(StudyOptions options = {});
  void cancel();

  [[nodiscard]] QSize minimumSizeHint() const override { return {200, 100}; }

 signals:
  // A click on a point: the scene that is shown is to be run under its method too.
  void methodChosen(const carom::Method& method);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QToolButton* make_button(const QString& name, const QString& tip);
  void make_choices();
  void poll();
  void show_points();
  void show_words();
  void choose_file();
  [[nodiscard]] QString tip_of(const StudyRow& row) const;

  Preset preset_;  // that is shown
  QString name_;
  Method own_;                     // the preset's
  std::optional<Preset> studied_;  // what so_far_ is about
  bool current_ = false;           // it is the scene that is shown, but for its method
  StudySoFar so_far_;
  std::size_t error_ = 0;  // of kStudyErrors
  bool against_time_ = false;
  bool stale_ = false;  // points have come that were not drawn yet
  QTimer timer_;

  QBoxLayout* layout_ = nullptr;  // the buttons above the study, or at its side
  QBoxLayout* buttons_ = nullptr;
  QToolButton* run_button_ = nullptr;
  QToolButton* error_button_ = nullptr;
  QToolButton* against_button_ = nullptr;
  QToolButton* export_button_ = nullptr;
  QStackedWidget* pages_ = nullptr;  // what a study is or why there is none; the study
  QLabel* hint_ = nullptr;
  ErrorPlot* plot_ = nullptr;
  OrderTable* orders_ = nullptr;
  QStackedWidget* below_ = nullptr;  // progress; words
  ElidedLabel* stage_ = nullptr;
  QProgressBar* progress_ = nullptr;
  ElidedLabel* words_ = nullptr;
  std::unique_ptr<BackgroundStudy> study_;  // while it runs
};

}  // namespace carom
