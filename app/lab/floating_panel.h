#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>
#include <functional>

class QAction;
class QSettings;
class QToolButton;
class QWidget;

namespace carom {

// A panel that can stand in a window of its own; closing that window docks it again. The keys of the window
// that it came from go on to work there.
class FloatingPanel : public QObject {
  Q_OBJECT

 public:
  // `name` is that of its settings; `dock` puts the panel into its place.
  FloatingPanel(QWidget* panel, const QString& name, const QString& title, std::function<void()> dock);

  void set_floating(bool floating);
  [[nodiscard]] bool floating() const { return window_ != nullptr; }
  // Floats with the upper left corner of its window here (px of the screen).
  void float_at(const QPoint& corner);
  // Shows or hides it, with its window if it has one.
  void set_shown(bool shown);

  // Checked while it floats, for the menu and the button in its head.
  [[nodiscard]] QAction* action() const { return action_; }
  [[nodiscard]] QToolButton* make_button() const;

  void restore(const QSettings& settings);
  void keep(QSettings& settings) const;

 signals:
  void aboutToFloat();
  void floatingChanged(bool floating);

 private:
  void float_off();
  void put_back();

  QWidget* panel_;
  QString name_;
  QString title_;
  std::function<void()> dock_;
  QAction* action_;
  QWidget* window_ = nullptr;
  QByteArray geometry_;  // of its window, the last time
};

}  // namespace carom
