#pragma once

#include "widgets/base/plain_text.h"

namespace carom {

// One line of text, elided with …; the caller sets the tooltip.
class ElidedLabel : public PlainLabel {
 public:
  using PlainLabel::PlainLabel;
  void set_whole(const QString& text) {
    whole_ = text;
    elide();
    updateGeometry();
  }
  [[nodiscard]] const QString& whole() const { return whole_; }
  [[nodiscard]] QSize sizeHint() const override {
    return {fontMetrics().horizontalAdvance(whole_) + 2, QLabel::sizeHint().height()};
  }
  [[nodiscard]] QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QLabel::resizeEvent(event);
    elide();
  }

 private:
  void elide() { setText(fontMetrics().elidedText(whole_, Qt::ElideRight, width())); }
  QString whole_;
};

}  // namespace carom
