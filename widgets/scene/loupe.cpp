#include "widgets/scene/loupe.h"

#include <QPainter>
#include <QPainterPath>
#include <utility>

#include "widgets/scene/paint_drawing.h"

namespace carom {

Loupe::Loupe(std::function<Drawing(const Camera&)> draw, QWidget* parent)
    : QWidget(parent), draw_(std::move(draw)) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  resize(kSide, kSide);
  hide();
}

void Loupe::show_at(const QPointF& at, const Camera& camera, const Theme& theme) {
  theme_ = theme;
  camera_ = {.center = camera.to_world(at), .scale = kTimes * camera.scale, .viewport = size()};
  move((at - QPointF(rect().center())).toPoint());
  show();
  raise();
  update();
}

void Loupe::paintEvent(QPaintEvent*) {
  constexpr double kRim = 2.0;  // px
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF disc = QRectF(rect()).adjusted(kRim, kRim, -kRim, -kRim);
  QPainterPath inside;
  inside.addEllipse(disc);
  painter.setClipPath(inside);
  paint_shapes(painter, draw_(camera_), camera_, theme_);
  painter.setClipping(false);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme_.muted, kRim));
  painter.drawEllipse(disc);
  painter.setPen(theme_.muted);
  painter.drawText(disc.adjusted(0.0, 0.0, 0.0, -8.0), Qt::AlignHCenter | Qt::AlignBottom,
                   QStringLiteral("×%1").arg(kTimes));
}

}  // namespace carom
