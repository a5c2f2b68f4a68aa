#include "widgets/plot/legend_row.h"

#include <QEvent>
#include <QMenu>
#include <algorithm>
#include <vector>

#include "widgets/plot/legend_button.h"

namespace carom {
namespace {

constexpr int kGap = 4;          // px
constexpr int kMorePadding = 8;  // px
constexpr int kReadable = 90;    // px: of a curve, where some go to the menu

}  // namespace

LegendRow::LegendRow(QWidget* parent) : QWidget(parent), more_(new QToolButton(this)) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  more_->setObjectName("more");
  more_->setPopupMode(QToolButton::InstantPopup);
  more_->setMenu(new QMenu(more_));
  more_->setToolTip(tr("Curves that have no room here"));
  more_->hide();
  connect(more_->menu(), &QMenu::aboutToShow, this, &LegendRow::fill_menu);
}

void LegendRow::add(LegendButton* button) {
  if (button->text().isEmpty()) {
    button->setParent(this);
    button->hide();
    return;
  }
  button->setParent(this);
  buttons_.push_back(button);
  updateGeometry();
  place();
}

void LegendRow::set_there(LegendButton* button, bool there) {
  const bool was_there = std::find(buttons_.begin(), buttons_.end(), button) != buttons_.end();
  if (there == was_there) return;
  if (there) {
    buttons_.push_back(button);
  } else {
    std::erase(buttons_, button);
    button->hide();
  }
  updateGeometry();
  place();
}

int LegendRow::whole_width() const {
  int width = 0;
  for (const LegendButton* button : buttons_) width += button->sizeHint().width() + kGap;
  return std::max(width - kGap, 0);
}

QSize LegendRow::sizeHint() const {
  int height = 0;
  for (const LegendButton* button : buttons_) height = std::max(height, button->sizeHint().height());
  return {whole_width(), height};
}

QSize LegendRow::minimumSizeHint() const { return {std::min(kLeastWidth, whole_width()), sizeHint().height()}; }

void LegendRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place();
}

bool LegendRow::event(QEvent* event) {
  // A button's name or font has changed.
  if (event->type() == QEvent::LayoutRequest) {
    updateGeometry();
    place();
  }
  return QWidget::event(event);
}

void LegendRow::place() {
  const auto more_text = [](std::size_t count) { return tr("+ %1 more ▾").arg(count); };
  const int more_width = more_->fontMetrics().horizontalAdvance(more_text(buttons_.size())) + kMorePadding;
  const auto least = [this](const LegendButton* button) {
    const int shortest = button->minimumSizeHint().width();
    return shown_ == buttons_.size() ? shortest
                                     : std::min(std::max(shortest, kReadable), button->sizeHint().width());
  };
  const auto needed_by_shown = [&] {
    int needed = 0;
    for (std::size_t i = 0; i < shown_; ++i) needed += least(buttons_[i]) + kGap;
    return needed;
  };
  shown_ = buttons_.size();
  int room = width() + kGap;
  if (needed_by_shown() > room) {
    room -= more_width + kGap;
    do --shown_;
    while (shown_ > 0 && needed_by_shown() > room);
  }

  // The room beyond the least widths goes to the names: to each its missing width, or an equal share.
  const auto lacks = [&](const LegendButton* button) { return button->sizeHint().width() - least(button); };
  std::vector<int> lacking;
  for (std::size_t i = 0; i < shown_; ++i) lacking.push_back(lacks(buttons_[i]));
  std::sort(lacking.begin(), lacking.end());
  int spare = room - needed_by_shown();
  int most = spare;
  for (std::size_t i = 0; i < lacking.size(); ++i) {
    most = std::max(spare, 0) / static_cast<int>(lacking.size() - i);
    if (lacking[i] > most) break;
    spare -= most = lacking[i];
  }
  int x = 0;
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    LegendButton* button = buttons_[i];
    button->setVisible(i < shown_);
    if (i >= shown_) continue;
    const int width = least(button) + std::min(lacks(button), most);
    button->setGeometry(x, (height() - button->sizeHint().height()) / 2, width, button->sizeHint().height());
    x += width + kGap;
  }
  more_->setVisible(shown_ < buttons_.size());
  more_->setText(more_text(buttons_.size() - shown_));
  more_->setGeometry(x, 0, more_width, height());
}

void LegendRow::fill_menu() {
  QMenu* menu = more_->menu();
  menu->clear();
  for (std::size_t i = shown_; i < buttons_.size(); ++i) {
    LegendButton* button = buttons_[i];
    QAction* action = menu->addAction(QString(button->text()).replace('&', "&&"));
    action->setCheckable(true);
    action->setChecked(button->isChecked());
    connect(action, &QAction::toggled, button, &LegendButton::setChecked);
  }
}

}  // namespace carom
