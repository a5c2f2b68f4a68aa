#include "app/lab/floating_panel.h"

#include <QAction>
#include <QCloseEvent>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>
#include <functional>
#include <utility>

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

FloatingPanel::FloatingPanel(QWidget* panel, const QString& name, const QString& title,
                             std::function<void()> dock)
    : QObject(panel),
      panel_(panel),
      name_(name),
      title_(title),
      dock_(std::move(dock)),
      action_(new QAction(tr("%1 in a window").arg(title), this)) {
  action_->setCheckable(true);
  action_->setToolTip(tr("In a window of its own; closing it puts it back. Dragged, it moves the panel"));
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

void FloatingPanel::float_at(const QPoint& corner) {
  set_floating(true);
  window_->move(corner);
}

void FloatingPanel::set_shown(bool shown) {
  panel_->setVisible(shown);
  if (window_ != nullptr) window_->setVisible(shown);
}

// Near its place, so that what moves there is not covered.
void FloatingPanel::float_off() {
  constexpr QPoint kAside(-40, -80);  // px
  emit aboutToFloat();
  const QRect here(panel_->mapToGlobal(QPoint()), panel_->size());
  window_ = new PanelWindow(panel_, panel_->window(), [this] { set_floating(false); });
  window_->setWindowTitle(title_ + " – Carom");
  window_->setGeometry(here.translated(kAside));
  if (!geometry_.isEmpty()) window_->restoreGeometry(geometry_);
  panel_->show();
  window_->show();
}

void FloatingPanel::put_back() {
  geometry_ = window_->saveGeometry();
  dock_();
  panel_->show();
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
