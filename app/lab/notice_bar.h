#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace carom {

// A line over the lab for important messages that do not block the window, with one or two buttons.
class NoticeBar : public QFrame {
  Q_OBJECT

 public:
  explicit NoticeBar(QWidget* parent = nullptr);

  // Shown until it is hidden. If `accept` has no text it has no button.
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
