#pragma once

#include <QObject>
#include <QPoint>
#include <functional>
#include <optional>
#include <vector>

class QWidget;

namespace carom {

// The drag of a panel by its head: it begins after 4 px; Escape ends it, and nothing moves. Places are in px of
// the screen.
class PanelDrag : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  ~PanelDrag() override { end(); }

  // The panel can be taken at this widget, where `in_head` holds for a place in it (px).
  void watch(QWidget* widget, std::function<bool(const QPoint&)> in_head);

 signals:
  void moved(const QPoint& to);
  void dropped(const QPoint& at);
  void cancelled();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void press(const QObject* watched, const QPoint& at, const QPoint& global);
  bool drag(const QPoint& to);
  void end();

  struct Head {
    QWidget* widget;
    std::function<bool(const QPoint&)> in_head;
  };
  std::vector<Head> heads_;
  std::optional<QPoint> pressed_;
  bool dragging_ = false;
};

}  // namespace carom
