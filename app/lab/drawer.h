#pragma once

#include <QFrame>

class QTabWidget;

namespace carom {

// Pages under the scene, one shown at a time. A click on the tab of the shown page folds the drawer to its line
// of tabs, and any tab unfolds it. It is the last part of a splitter. A page that is taller than its room
// scrolls.
class Drawer : public QFrame {
  Q_OBJECT

 public:
  explicit Drawer(QWidget* parent = nullptr);

  void add(QWidget* page, const QString& title);
  void set_title(const QWidget* page, const QString& title);
  // Shows this page, folded or not.
  void choose(QWidget* page);
  // Whether it is the chosen page of the drawer.
  [[nodiscard]] bool shows(const QWidget* page) const;

  void set_folded(bool folded);
  [[nodiscard]] bool folded() const { return folded_; }

 signals:
  void pageChanged();
  void foldedChanged(bool folded);

 private:
  [[nodiscard]] int index_of(const QWidget* page) const;

  QTabWidget* tabs_;
  bool folded_ = false;
  int unfolded_ = 190;  // px, its height then
};

}  // namespace carom
