#include "app/lab/floating_panel.h"

#include <QAction>
#include <QCloseEvent>
#include <QSettings>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>

namespace carom {
namespace {

class PanelWindow : public QWidget {
 public:
  PanelWindow(QWidget* panel, QWidget* owner, std::function<void()> closed)
      : QWidget(owner, Qt::Tool), closed_(std::move(closed)) {
    constexpr int kMargin = 8;  // px
    setObjectName("window");
    setAttribute(Qt::WA_StyledBackground);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    column->addWidget(panel);
  }

 protected:
  void closeEvent(QCloseEvent* event) override {
    event->ignore();  // it goes once the panel is back
    closed_();
  }

 private:
  std::function<void()> closed_;
};

}  // namespace

FloatingPanel::FloatingPanel(QWidget* panel, const QString& name, const QString& title)
    : QObject(panel),
      panel_(panel),
      home_(qobject_cast<QSplitter*>(panel->parentWidget())),
      name_(name),
      title_(title),
      action_(new QAction(tr("%1 in a window").arg(title), this)),
      place_(home_->indexOf(panel)) {
  action_->setCheckable(true);
  action_->setToolTip(tr("In a window of its own; closing it puts it back"));
  connect(action_, &QAction::toggled, this, &FloatingPanel::set_floating);
}

QToolButton* FloatingPanel::make_button() const {
  auto* button = new QToolButton;
  button->setDefaultAction(action_);
  button->setToolButtonStyle(Qt::ToolButtonIconOnly);
  button->setIconSize({14, 14});
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

void FloatingPanel::set_floating(bool floating) {
  action_->setChecked(floating);
  if (floating == this->floating()) return;
  floating ? float_off() : put_back();
  emit floatingChanged(floating);
}

void FloatingPanel::set_shown(bool shown) {
  panel_->setVisible(shown);
  if (window_ != nullptr) window_->setVisible(shown);
}

// Near its place, so that what moves there is not covered.
void FloatingPanel::float_off() {
  constexpr QPoint kAside(-40, -80);  // px
  sizes_ = home_->sizes();
  const QRect here(panel_->mapToGlobal(QPoint()), panel_->size());
  window_ = new PanelWindow(panel_, home_->window(), [this] { set_floating(false); });
  window_->setWindowTitle(title_ + " – Carom");
  window_->setGeometry(here.translated(kAside));
  if (!geometry_.isEmpty()) window_->restoreGeometry(geometry_);
  panel_->show();
  window_->show();
}

void FloatingPanel::put_back() {
  geometry_ = window_->saveGeometry();
  home_->insertWidget(std::min(place_, home_->count()), panel_);
  panel_->show();
  if (home_->count() == sizes_.size()) home_->setSizes(sizes_);
  window_->hide();
  window_->deleteLater();
  window_ = nullptr;
}

void FloatingPanel::restore(const QSettings& settings) {
  geometry_ = settings.value(name_ + "_window").toByteArray();
  set_floating(settings.value(name_ + "_floats", false).toBool());
}

void FloatingPanel::keep(QSettings& settings) const {
  settings.setValue(name_ + "_floats", floating());
  settings.setValue(name_ + "_window", floating() ? window_->saveGeometry() : geometry_);
}

}  // namespace carom
