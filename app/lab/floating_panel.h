#pragma once

#include <QByteArray>
#include <QList>
#include <QObject>
#include <QString>

class QAction;
class QSettings;
class QSplitter;
class QToolButton;
class QWidget;

namespace carom {

// A panel of a splitter that can stand in a window of its own; closing that window puts it back. The keys of
// the window that it came from go on to work there.
class FloatingPanel : public QObject {
  Q_OBJECT

 public:
  // The panel stands in the splitter already. `name` is that of its settings.
  FloatingPanel(QWidget* panel, const QString& name, const QString& title);

  void set_floating(bool floating);
  [[nodiscard]] bool floating() const { return window_ != nullptr; }
  // Shows or hides it, with its window if it has one.
  void set_shown(bool shown);

  // Checked while it floats, for the menu and the button in its head.
  [[nodiscard]] QAction* action() const { return action_; }
  [[nodiscard]] QToolButton* make_button() const;

  void restore(const QSettings& settings);
  void keep(QSettings& settings) const;

 signals:
  void floatingChanged(bool floating);

 private:
  void float_off();
  void put_back();

  QWidget* panel_;
  QSplitter* home_;
  QString name_;
  QString title_;
  QAction* action_;
  QWidget* window_ = nullptr;
  int place_;            // in the splitter
  QList<int> sizes_;     // px, of the splitter with it
  QByteArray geometry_;  // of its window, the last time
};

}  // namespace carom
