#include "widgets/run/experiment_preview.h"

#include <QApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>

#include "widgets/base/plain_text.h"
#include "widgets/run/experiment_list.h"

namespace carom {

ExperimentPreview::ExperimentPreview(ExperimentList& list, QWidget* parent)
    : QWidget(parent), list_(list), title_(new PlainLabel(this)) {
  constexpr QPoint kCorner(12, 12);  // px, of the chips of a scene
  title_->setObjectName("chip");
  title_->move(kCorner);
  setToolTip(tr("A click opens this experiment"));
  hide();
  connect(qApp, &QApplication::focusChanged, this,
          [this](const QWidget* /*old*/, const QWidget* now) { leave_for(now); });
}

void ExperimentPreview::show_start(const Frame& start, const std::optional<View>& view, const SceneLook& look,
                                   const QString& title) {
  start_ = start;
  view_ = view;
  options_ = look.options;
  theme_ = look.theme;
  title_->setText(tr("%1: Enter opens it, Esc goes back").arg(title));
  title_->adjustSize();
  setAccessibleName(title_->text());
  show();
  raise();
  update();
}

void ExperimentPreview::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  SceneLook look = scene_look(start_, view_, options_, theme_, size());
  paint_scene(painter, start_, look);
}

void ExperimentPreview::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) emit chosen();
}

void ExperimentPreview::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  update();
}

void ExperimentPreview::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  qApp->installEventFilter(this);
}

void ExperimentPreview::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  qApp->removeEventFilter(this);
}

bool ExperimentPreview::eventFilter(QObject* watched, QEvent* event) {
  const bool other_size = event->type() == QEvent::Resize && watched == parentWidget();
  if (event->type() == QEvent::MouseButtonPress || other_size) leave_for(qobject_cast<QWidget*>(watched));
  return false;
}

void ExperimentPreview::leave_for(const QWidget* widget) {
  if (!isVisible() || widget == nullptr || widget->window() != window()) return;
  if (widget == this || isAncestorOf(widget) || widget == &list_ || list_.isAncestorOf(widget)) return;
  hide();
  emit left();
}

}  // namespace carom
