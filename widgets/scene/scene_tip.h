#pragma once

#include <QPoint>
#include <optional>
#include <string>

#include "widgets/scene/scene_tools.h"

class QHelpEvent;
class QWidget;

namespace carom {

// The tooltip of what is under the mouse in a scene: of the sign of an overlap, of an impact's mark, else
// of a body, whose figures it follows.
class SceneTip {
 public:
  explicit SceneTip(QWidget* view) : view_(view) {}

  // `pressed`: a button is down, so that there is none.
  void show(const QHelpEvent& asked, const SceneSight& sight, bool pressed);
  // The sight has another frame: the tooltip is updated, or hidden if its subject is gone.
  void follow(const SceneSight& sight);

 private:
  struct Subject {
    int body = -1;                   // -1: none
    std::optional<double> impact{};  // s
    std::string overlap{};           // what is said of it

    bool operator==(const Subject&) const = default;
  };

  [[nodiscard]] Subject subject_at(const SceneSight& sight) const;
  void say(const QPoint& global, const SceneSight& sight);

  QWidget* view_;
  std::optional<Subject> subject_;
  QPoint at_;
};

}  // namespace carom
