#pragma once

#include <QRect>
#include <QString>
#include <QWidget>

namespace carom {

// Where a dragged panel would go: a tinted place over the window, with a word in it.
class DropMark : public QWidget {
  Q_OBJECT

 public:
  explicit DropMark(QWidget* parent);

  void show_at(const QRect& place, const QString& word);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString word_;
};

}  // namespace carom
