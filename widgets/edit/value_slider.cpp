#include "widgets/edit/value_slider.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyle>
#include <cmath>

namespace carom {
namespace {

constexpr int kPlaces = 10'000;  // of the slider, far more than pixels
constexpr int kKnob = 14;        // px, as in the style sheet

}  // namespace

ValueSlider::ValueSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setRange(0, kPlaces);
  setFocusPolicy(Qt::ClickFocus);  // for Esc
  setMinimumWidth(3 * kKnob);
  setObjectName("value");
}

void ValueSlider::show_value(const Range& range, double value) {
  if (!grip_) scale_ = slider_scale(range, value);
  const bool is_signed = scale_.low < 0.0;
  if (property("signed").toBool() != is_signed) {
    setProperty("signed", is_signed);
    style()->unpolish(this);
    style()->polish(this);
  }
  setValue(static_cast<int>(std::lround(kPlaces * scale_.place_of(value))));
}

int ValueSlider::room() const { return std::max(width() - kKnob, 1); }

double ValueSlider::knob() const { return room() * static_cast<double>(value()) / kPlaces; }

void ValueSlider::pull_to(double pixels) { emit moved(scale_.value_at(pixels / room(), 1.0 / room())); }

void ValueSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const double x = event->position().x() - kKnob / 2.0;
  const bool on_knob = std::abs(x - knob()) <= kKnob / 2.0;
  grip_ = on_knob ? x - knob() : 0.0;
  emit began();
  if (!on_knob) pull_to(x);
}

void ValueSlider::mouseMoveEvent(QMouseEvent* event) {
  if (grip_) pull_to(event->position().x() - kKnob / 2.0 - *grip_);
}

void ValueSlider::mouseReleaseEvent(QMouseEvent* /*event*/) { grip_.reset(); }

// The wheel scrolls the page.
void ValueSlider::wheelEvent(QWheelEvent* event) { event->ignore(); }

bool ValueSlider::event(QEvent* event) {
  // Esc ends the pull before it is a shortcut of the window.
  if (event->type() == QEvent::ShortcutOverride && grip_ &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();
    return true;
  }
  return QSlider::event(event);
}

void ValueSlider::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape || !grip_) return event->ignore();
  grip_.reset();
  emit cancelled();
}

}  // namespace carom
