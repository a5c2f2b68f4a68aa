#include "widgets/plot/runs_legend.h"

#include <QGridLayout>
#include <QSignalBlocker>
#include <algorithm>

#include "widgets/plot/legend_button.h"

namespace carom {

RunsLegend::RunsLegend(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(8, 0, 8, 0);
  grid_->setSpacing(2);
  hide();
}

void RunsLegend::show_runs(const std::vector<PlottedRun>& runs, const Theme& theme) {
  setVisible(runs.size() > 1);
  while (buttons_.size() > runs.size()) {
    LegendButton* button = buttons_.back();
    buttons_.pop_back();
    button->disconnect(this);
    button->hide();
    button->deleteLater();
  }
  for (std::size_t i = buttons_.size(); i < runs.size(); ++i) {
    buttons_.push_back(new LegendButton(runs[i].name, {}, this));
    connect(buttons_.back(), &LegendButton::toggled, this, [this, i](bool shown) { emit toggled(i, shown); });
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const QSignalBlocker quiet(buttons_[i]);
    buttons_[i]->setChecked(runs[i].shown);
    buttons_[i]->setText(runs[i].name);
    buttons_[i]->set_look(pen_of_run(i, theme, 2.2), theme.text);
  }
  place();
}

void RunsLegend::place() {
  int widest = 1;
  for (const LegendButton* button : buttons_) widest = std::max(widest, button->sizeHint().width());
  const int count = std::max(static_cast<int>(buttons_.size()), 1);
  const int columns = std::clamp(parentWidget()->width() / (widest + grid_->spacing()), 1, count);
  for (int i = 0; i < static_cast<int>(buttons_.size()); ++i)
    grid_->addWidget(buttons_[static_cast<std::size_t>(i)], i / columns, i % columns);
}

void RunsLegend::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place();
}

}  // namespace carom
