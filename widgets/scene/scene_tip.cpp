#include "widgets/scene/scene_tip.h"

#include <QHelpEvent>
#include <QToolTip>
#include <QWidget>

#include "widgets/scene/body_text.h"
#include "widgets/scene/drag_limits.h"
#include "widgets/scene/hit.h"
#include "widgets/scene/impact_marks.h"

namespace carom {

void SceneTip::show(const QHelpEvent& asked, const SceneSight& sight, bool pressed) {
  at_ = asked.pos();
  subject_.reset();
  const Subject subject = pressed || !sight.frame ? Subject() : subject_at(sight);
  if (subject == Subject()) return QToolTip::hideText();
  subject_ = subject;
  say(asked.globalPos(), sight);
}

void SceneTip::follow(const SceneSight& sight) {
  if (!subject_) return;
  const bool shown = QToolTip::isVisible() && view_->underMouse();
  if (shown && sight.frame && subject_at(sight) == *subject_) return say(view_->mapToGlobal(at_), sight);
  if (shown) QToolTip::hideText();
  subject_.reset();
}

SceneTip::Subject SceneTip::subject_at(const SceneSight& sight) const {
  for (const Overlap& overlap : sight.kept) {
    if (!on_sign(sight.camera.to_screen(overlap.at), at_)) continue;
    const QString text = overlap_text(overlap, {.at = overlap.at, .scale = sight.camera.scale});
    return {.overlap = (text + ": play parts them").toStdString()};
  }
  if (const auto impact = impact_at(sight.marks, sight.camera, at_)) return {.impact = impact->time};
  return {.body = body_at(*sight.frame, sight.camera, at_)};
}

void SceneTip::say(const QPoint& global, const SceneSight& sight) {
  if (!subject_->overlap.empty())
    return QToolTip::showText(global, QString::fromStdString(subject_->overlap), view_);
  const auto impact = impact_at(sight.marks, sight.camera, at_);
  const QString text =
      impact ? impact_text(*sight.frame->bodies, *impact) : body_text(*sight.frame, subject_->body);
  QToolTip::showText(global, text, view_);
}

}  // namespace carom
