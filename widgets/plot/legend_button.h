#pragma once

#include <QPen>
#include <QToolButton>

namespace carom {

// One curve in a plot's legend: a sample of its line and its name; `tip` is its description. Checked while the
// curve is shown.
class LegendButton : public QToolButton {
  Q_OBJECT

 public:
  explicit LegendButton(const QString& label, const QString& tip = {}, QWidget* parent = nullptr);

  void set_look(const QPen& line, const QColor& text);
  [[nodiscard]] QSize sizeHint() const override;
  // The name is shortened if there is no room for all of it.
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QPen line_;
  QColor text_;
};

}  // namespace carom
