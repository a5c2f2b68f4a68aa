#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace carom {

// A line over the lab that cannot be overlooked and doesn't stand in the way: something to be known, with one
// button or two.
class NoticeBar : public QFrame {
  Q_OBJECT

 public:
  explicit NoticeBar(QWidget* parent = nullptr);

  // Shown until it is hidden. Without a text, `accept` has no button.
  void say(const QString& text, const QString& accept, const QString& dismiss);

 signals:
  void accepted();
  void dismissed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QLabel* text_;
  QPushButton* accept_;
  QPushButton* dismiss_;
};

}  // namespace carom
