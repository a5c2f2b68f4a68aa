#include "app/lab/drawer.h"

#include <QSplitter>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>
#include <utility>

#include "app/lab/scrolled.h"

namespace carom {
namespace {

constexpr int kLeastPage = 96;  // px: two rows of a table under their heading

}  // namespace

Drawer::Drawer(QWidget* parent) : QFrame(parent), tabs_(new QTabWidget) {
  setObjectName("panel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 4, 12, 8);
  column->addWidget(tabs_);
  set_folded(false);
  // Before the click changes the page.
  connect(tabs_, &QTabWidget::tabBarClicked, this, [this](int tab) {
    if (tab >= 0) set_folded(!folded_ && tab == tabs_->currentIndex());
  });
  connect(tabs_, &QTabWidget::currentChanged, this, &Drawer::pageChanged);
}

void Drawer::add(QWidget* page, const QString& title) {
  const bool tall = page->minimumSizeHint().height() > kLeastPage;
  tabs_->addTab(tall ? scrolled<TallArea>(page) : page, title);
}

void Drawer::set_title(const QWidget* page, const QString& title) { tabs_->setTabText(index_of(page), title); }

void Drawer::choose(QWidget* page) { tabs_->setCurrentIndex(index_of(page)); }

void Drawer::press(int tab) {
  set_folded(!folded_ && tab == tabs_->currentIndex());
  tabs_->setCurrentIndex(tab);
}

QStringList Drawer::titles() const {
  QStringList titles;
  for (int tab = 0; tab < tabs_->count(); ++tab) titles << tabs_->tabText(tab);
  return titles;
}

bool Drawer::shows(const QWidget* page) const { return index_of(page) == tabs_->currentIndex(); }

int Drawer::index_of(const QWidget* page) const {
  int index = 0;
  while (tabs_->widget(index) != page && !tabs_->widget(index)->isAncestorOf(page)) ++index;
  return index;
}

void Drawer::add_corner(QWidget* widget) { tabs_->setCornerWidget(widget); }

bool Drawer::event(QEvent* event) {
  const bool left =
      event->type() == QEvent::ParentChange && qobject_cast<QSplitter*>(parentWidget()) == nullptr;
  if (left) set_folded(false);
  return QFrame::event(event);
}

bool Drawer::in_head(const QPoint& at) const { return at.y() < tabs_->y() + tabs_->tabBar()->height(); }

// Alone in its splitter it would leave a hole.
bool Drawer::can_fold() const {
  const auto* splitter = qobject_cast<const QSplitter*>(parentWidget());
  if (splitter == nullptr) return false;
  bool shares = false;
  for (int i = 0; i < splitter->count(); ++i)
    shares = shares || (splitter->widget(i) != this && !splitter->widget(i)->isHidden());
  return shares;
}

void Drawer::set_folded(bool folded) {
  const int bar = tabs_->tabBar()->sizeHint().height();
  if (folded && !can_fold()) return emit foldedChanged(false);
  tabs_->setMinimumHeight(folded ? bar : bar + kLeastPage);
  setMaximumHeight(folded ? bar + layout()->contentsMargins().top() : QWIDGETSIZE_MAX);
  if (std::exchange(folded_, folded) != folded) emit foldedChanged(folded);
}

}  // namespace carom
