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

// Before and after: of the impact at the shown moment, of the run's last one, or from the start to the shown
// moment. Arrows go from impact to impact.
class BeforeAfterPanel : public QWidget {
  Q_OBJECT

 public:
  enum class Choice { kThis, kLast, kStart };

  explicit BeforeAfterPanel(QWidget* parent = nullptr);
  // What is shown of a run.
  struct Shown {
    const Frame& shown;
    const Frame& newest;
    const Recorder& recorder;
    const std::vector<Body>& start;  // bodies at the start, in the order of the frames
    std::optional<double> picked;    // s, of the impact that was asked for
  };
  void update_from(const Shown& run);
  [[nodiscard]] Choice choice() const;
  void choose(Choice choice);

 signals:
  void choiceChanged();
  void impactAsked(bool forward);

 private:
  void show_impact(const std::shared_ptr<const JumpMoment>& moment, const Shown& run);

  QLabel* head_;
  QButtonGroup* choices_;
  BeforeAfterTable* table_;
  std::shared_ptr<const JumpMoment> moment_;  // that the table shows
};

}  // namespace carom
