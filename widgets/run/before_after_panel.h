#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "physics/record/frame.h"
#include "physics/record/recorder.h"
#include "widgets/run/before_after.h"

class QButtonGroup;
class QLabel;

namespace carom {

// Before and after: of the impact at the shown moment (at the newest one without any: of the last), of the
// run's last one, from the start to the shown moment, or from mark A to mark B. Arrows go from impact to
// impact.
class BeforeAfterPanel : public QWidget {
  Q_OBJECT

 public:
  enum class Choice { kThis, kLast, kStart, kMarked };

  explicit BeforeAfterPanel(QWidget* parent = nullptr);
  // What is shown of a run.
  struct Shown {
    const Frame& shown;
    const Frame& newest;
    const Recorder& recorder;
    const std::vector<Body>& start;  // bodies at the start, in the order of the frames
    std::optional<double> picked{};  // s, of the impact that was asked for
    // s, the user's marks, and the run between them, if it is known.
    std::optional<double> mark_a{};
    std::optional<double> mark_b{};
    std::shared_ptr<const RunInterval> marked{};
  };
  void update_from(const Shown& run);
  [[nodiscard]] Choice choice() const;
  void choose(Choice choice);

 signals:
  void choiceChanged();
  void impactAsked(bool forward);

 private:
  void show_this(const Shown& run);
  void show_impact(const std::shared_ptr<const JumpMoment>& moment, const Shown& run);
  void show_marked(const Shown& run);
  void show_nothing(const QString& why);

  QLabel* head_;
  QButtonGroup* choices_;
  BeforeAfterTable* table_;
  // That the table shows.
  std::shared_ptr<const JumpMoment> moment_;
  std::shared_ptr<const RunInterval> interval_;
};

}  // namespace carom
