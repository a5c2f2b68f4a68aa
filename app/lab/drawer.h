#pragma once

#include <QFrame>

class QTabWidget;

namespace carom {

// Pages under the scene, one shown at a time. A click on the tab of the shown page folds the drawer to its line
// of tabs, and any tab unfolds it. It is the last part of a splitter; elsewhere it does not fold. A page that
// is taller than its room scrolls.
class Drawer : public QFrame {
  Q_OBJECT

 public:
  explicit Drawer(QWidget* parent = nullptr);

  void add(QWidget* page, const QString& title);
  void set_title(const QWidget* page, const QString& title);
  // Shows this page, folded or not.
  void choose(QWidget* page);
  // At the right of the tabs.
  void add_corner(QWidget* widget);
  // As a click on this tab: opens it, or folds the drawer where it is the open one.
  void press(int tab);
  [[nodiscard]] QStringList titles() const;
  // Whether it is the chosen page of the drawer.
  [[nodiscard]] bool shows(const QWidget* page) const;

  void set_folded(bool folded);
  [[nodiscard]] bool folded() const { return folded_; }

 signals:
  void pageChanged();
  void foldedChanged(bool folded);

 protected:
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] int index_of(const QWidget* page) const;

  QTabWidget* tabs_;
  bool folded_ = false;
  int unfolded_ = 190;  // px, its height then
};

}  // namespace carom
