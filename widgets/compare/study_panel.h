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

// The study of the scene that is shown: every integrator, both choices for impacts, a series of steps. It runs
// on threads of its own beside the lab; points appear as runs end. When another scene is shown or this one is
// edited, the results stay, labelled with their scene, until the next study.
class StudyPanel : public QWidget {
  Q_OBJECT

 public:
  explicit StudyPanel(const Theme& theme, QWidget* parent = nullptr);
  ~StudyPanel() override;  // stops a running study

  void set_theme(const Theme& theme);
  // Sets another scene, with the name of its preset. Its method's step is the centre of the study's steps.
  void set_scene(const Preset& preset, const QString& name);
  // The same scene with more bodies or another method; the study's steps stay around the preset's own.
  void edit_scene(const Preset& preset);

  // Saves the results so far; the suffix chooses the table with all digits (.csv) or the picture (.svg, .pdf,
  // .png). The file is replaced only when it is complete; otherwise returns false with the reason in `error`.
  [[nodiscard]] bool save(const QString& file, QString* error) const;

  [[nodiscard]] bool running() const { return study_ != nullptr; }
  [[nodiscard]] const StudySoFar& so_far() const { return so_far_; }
  [[nodiscard]] ErrorPlot& plot() { return *plot_; }
  // Whether so_far() belongs to the scene as shown, apart from its method.
  [[nodiscard]] bool of_the_scene_shown() const { return current_; }
  // The compared runs, after the scene that they are of where another one is shown.
  [[nodiscard]] QString words() const;

  void start(StudyOptions options = {});
  void cancel();

  [[nodiscard]] QSize minimumSizeHint() const override { return {200, 100}; }

 signals:
  // A click on a point: asks to run the shown scene under its method too.
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
  void show_below();
  void choose_steps();
  void show_steps();
  void choose_file();
  [[nodiscard]] QString tip_of(const StudyRow& row) const;

  Preset preset_;  // that is shown
  QString name_;
  Method own_;                     // the preset's
  std::optional<Preset> studied_;  // the preset of so_far_
  bool current_ = false;           // so_far_ belongs to the shown scene, apart from its method
  StudySoFar so_far_;
  std::vector<double> steps_;  // s, chosen for the scene shown; none: the usual ones
  std::size_t error_ = 0;      // of kStudyErrors
  bool against_time_ = false;
  bool stale_ = false;  // there are points that are not drawn yet
  QTimer timer_;

  QBoxLayout* layout_ = nullptr;  // the buttons are above the study or at its side
  QBoxLayout* buttons_ = nullptr;
  QToolButton* run_button_ = nullptr;
  QToolButton* error_button_ = nullptr;
  QToolButton* against_button_ = nullptr;
  QToolButton* steps_button_ = nullptr;
  QToolButton* export_button_ = nullptr;
  QStackedWidget* pages_ = nullptr;  // explanation, or the study
  QLabel* hint_ = nullptr;
  QLabel* other_ = nullptr;  // that the results are of another scene
  ErrorPlot* plot_ = nullptr;
  OrderTable* orders_ = nullptr;
  QStackedWidget* below_ = nullptr;  // progress bar, or text
  ElidedLabel* stage_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* words_ = nullptr;
  ElidedLabel* first_words_ = nullptr;
  std::unique_ptr<BackgroundStudy> study_;  // while it runs
};

}  // namespace carom
