#include "widgets/plot/legend_row.h"

#include <QEvent>
#include <QMenu>
#include <algorithm>
#include <utility>

#include "widgets/plot/legend_button.h"

namespace carom {
namespace {

constexpr int kGap = 4;              // px
constexpr int kMorePadding = 8;      // px
constexpr int kMostLines = 3;        // of names that all have room in them
constexpr int kLinesBeforeMenu = 2;  // where they have not

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

int LegendRow::line_height() const {
  int height = 0;
  for (const LegendButton* button : buttons_) height = std::max(height, button->sizeHint().height());
  return height;
}

QSize LegendRow::sizeHint() const { return {whole_width(), lines_ * line_height()}; }

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

// As many as have room in so many lines, if so many px at the end of the last one are kept free.
std::vector<LegendRow::Spot> LegendRow::spots(int lines, int kept) const {
  std::vector<Spot> spots;
  Spot next;
  for (const LegendButton* button : buttons_) {
    next.width = std::max(std::min(button->sizeHint().width(), width()), button->minimumSizeHint().width());
    const auto fits = [&] { return next.x + next.width <= width() - (next.line + 1 == lines ? kept : 0); };
    if (!fits() && next.x > 0 && next.line + 1 < lines) {
      next.x = 0;
      ++next.line;
    }
    if (!fits()) break;
    spots.push_back(next);
    next.x += next.width + kGap;
  }
  return spots;
}

void LegendRow::place() {
  const auto more_text = [](std::size_t count) { return tr("+ %1 more ▾").arg(count); };
  const int more_width = more_->fontMetrics().horizontalAdvance(more_text(buttons_.size())) + kMorePadding;
  std::vector<Spot> found;
  for (int lines = 1; lines <= kMostLines && found.size() < buttons_.size(); ++lines) found = spots(lines, 0);
  const bool whole = found.size() == buttons_.size();
  if (!whole) found = spots(kLinesBeforeMenu, more_width + kGap);
  shown_ = found.size();
  const int height = line_height();
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    buttons_[i]->setVisible(i < shown_);
    if (i < shown_) buttons_[i]->setGeometry(found[i].x, found[i].line * height, found[i].width, height);
  }
  const Spot last = found.empty() ? Spot() : found.back();
  const int lines = whole ? last.line + 1 : kLinesBeforeMenu;
  more_->setVisible(!whole);
  more_->setText(more_text(buttons_.size() - shown_));
  more_->setGeometry(last.line + 1 == lines && last.width > 0 ? last.x + last.width + kGap : 0,
                     (lines - 1) * height, more_width, height);
  if (std::exchange(lines_, lines) != lines) updateGeometry();
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
