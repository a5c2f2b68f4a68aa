#pragma once

#include <QFrame>

class QTabWidget;

namespace carom {

// Pages of tables, one shown at a time. A click on the tab of the shown page folds the drawer to its line
// of tabs, and any tab unfolds it. It folds in a splitter, which it shares with others; elsewhere it does not.
// A page that is taller than its room scrolls.
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
  // Whether this place (px) is beside the tabs, over the page.
  [[nodiscard]] bool in_head(const QPoint& at) const;

 signals:
  void pageChanged();
  void foldedChanged(bool folded);

 protected:
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] int index_of(const QWidget* page) const;
  [[nodiscard]] bool can_fold() const;

  QTabWidget* tabs_;
  bool folded_ = false;
};

}  // namespace carom
