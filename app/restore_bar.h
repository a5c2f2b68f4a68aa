#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace carom {

// A line over the lab that waits without being in the way: unsaved work that can be brought back.
class RestoreBar : public QFrame {
  Q_OBJECT

 public:
  explicit RestoreBar(QWidget* parent = nullptr);

  // Shows an offer with two buttons, or only something to be known with one.
  void offer(const QString& text);
  void tell(const QString& text);

 signals:
  void restoreClicked();
  void discardClicked();  // also: what was told is known

 private:
  QLabel* text_;
  QPushButton* restore_;
  QPushButton* discard_;
};

}  // namespace carom
