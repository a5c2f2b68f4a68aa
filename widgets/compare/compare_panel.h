#pragma once

#include <QScrollArea>
#include <QTimer>
#include <memory>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/record/frame.h"
#include "widgets/theme/theme.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSlider;
class QToolButton;

namespace carom {

class CompareTable;

// The methods under which a scene runs side by side: a table of their errors and costs, and controls for the
// chosen one below. It changes nothing itself: signals report the user's choices.
class ComparePanel : public QScrollArea {
  Q_OBJECT

 public:
  explicit ComparePanel(const Theme& theme, QWidget* parent = nullptr);

  void set_theme(const Theme& theme);
  // Has the height it needs; scrolls horizontally.
  [[nodiscard]] QSize minimumSizeHint() const override;
  // The scene with its current methods, and their reference.
  void set_scene(const Preset& preset, ReferenceId reference);
  void update_from(const std::vector<std::shared_ptr<const Frame>>& frames);

 signals:
  void methodAdded(const carom::Method& method);
  void methodRemoved(std::size_t run);
  void methodChanged(const carom::Method& method, std::size_t run);
  void stepChanged(double step, const std::vector<std::size_t>& runs, int drag);  // s, many times in one drag
  void referenceChosen(carom::ReferenceId reference);
  void usualAsked();  // to Euler, RK4 and the exact run, or back

 private:
  template <class Table, class Member>
  QComboBox* make_choice(const Table& table, Member member, bool short_names, const QString& tip);
  [[nodiscard]] QWidget* make_actions();
  [[nodiscard]] QWidget* make_choices();
  [[nodiscard]] std::size_t chosen() const;
  void show_chosen();
  void take_step();

  Preset preset_;
  std::vector<Method> methods_;
  ReferenceId reference_ = ReferenceId::kNone;
  CompareTable* table_ = nullptr;
  QPushButton* usual_ = nullptr;
  QToolButton* add_ = nullptr;
  QToolButton* remove_ = nullptr;
  QComboBox* references_ = nullptr;
  QLabel* uncertainty_ = nullptr;
  QComboBox* integrators_ = nullptr;
  QComboBox* impacts_ = nullptr;
  QComboBox* contacts_ = nullptr;
  QSlider* step_ = nullptr;
  QLabel* step_text_ = nullptr;
  QCheckBox* all_ = nullptr;
  std::size_t step_of_ = 0;  // run whose step the slider sets
  int drag_ = 0;             // of the slider
  QTimer step_timer_;        // limits the rate of changes while the slider moves
};

}  // namespace carom
