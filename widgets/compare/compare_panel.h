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

// The methods under which a scene runs side by side: a table of how far each is from the reference and what it
// costs, and below it what the chosen one is. It changes nothing itself: signals tell what the user wants.
class ComparePanel : public QScrollArea {
  Q_OBJECT

 public:
  explicit ComparePanel(const Theme& theme, QWidget* parent = nullptr);

  void set_theme(const Theme& theme);
  // As high as it needs to be; sideways it scrolls.
  [[nodiscard]] QSize minimumSizeHint() const override;
  // The scene with its methods in force, and what they are compared with.
  void set_scene(const Preset& preset, ReferenceId reference);
  void update_from(const std::vector<std::shared_ptr<const Frame>>& frames);

 signals:
  void methodAdded(const carom::Method& method);
  void methodRemoved(std::size_t run);
  void methodChanged(const carom::Method& method, std::size_t run);
  void stepChanged(double step, const std::vector<std::size_t>& runs, int drag);  // s, in one drag many times
  void referenceChosen(carom::ReferenceId reference);
  void usualAsked();  // Euler, RK4 and the exact run; or back

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
  std::size_t step_of_ = 0;  // whose step the slider sets
  int drag_ = 0;             // of the slider
  QTimer step_timer_;        // while the slider moves, steps are taken in moderation
};

}  // namespace carom
