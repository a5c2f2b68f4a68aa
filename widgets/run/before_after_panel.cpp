#include "widgets/run/before_after_panel.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "physics/record/impact_moments.h"
#include "widgets/base/plain_text.h"

namespace carom {
namespace {

struct ChoiceText {
  BeforeAfterPanel::Choice choice;
  const char* label;
  const char* tip;
};
constexpr std::array<ChoiceText, 3> kChoices = {{
    {BeforeAfterPanel::Choice::kThis, QT_TRANSLATE_NOOP("BeforeAfterPanel", "this impact"),
     QT_TRANSLATE_NOOP("BeforeAfterPanel",
                       "The impact at the shown moment: PgUp and PgDn go there, or a click on it")},
    {BeforeAfterPanel::Choice::kLast, QT_TRANSLATE_NOOP("BeforeAfterPanel", "last"),
     QT_TRANSLATE_NOOP("BeforeAfterPanel", "The last impact of the run so far")},
    {BeforeAfterPanel::Choice::kStart, QT_TRANSLATE_NOOP("BeforeAfterPanel", "from the start"),
     QT_TRANSLATE_NOOP("BeforeAfterPanel", "All bodies at the start and at the shown moment")},
}};

// The impact of the step that ends at the shown moment: the one that was asked for, else the last one.
std::shared_ptr<const JumpMoment> impact_of_step(const Frame& frame, const std::optional<double>& picked) {
  const double step = frame.method.step;
  const double rounding = kSameMoment * step;
  std::shared_ptr<const JumpMoment> found;
  for (const auto& moment : frame.jumps) {
    if (moment->time() <= frame.time - step + rounding || moment->time() > frame.time + rounding) continue;
    if (found && picked && found->time() == *picked) break;
    found = moment;
  }
  return found;
}

QToolButton* make_arrow(const QString& text, const QString& tip, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setText(text);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setAutoRaise(true);
  return button;
}

}  // namespace

BeforeAfterPanel::BeforeAfterPanel(QWidget* parent)
    : QWidget(parent),
      head_(new PlainLabel(this)),
      choices_(new QButtonGroup(this)),
      table_(new BeforeAfterTable(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 4, 0, 0);
  column->setSpacing(2);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  for (const ChoiceText& text : kChoices) {
    auto* button = new QToolButton(this);
    button->setText(tr(text.label));
    button->setToolTip(tr(text.tip));
    button->setCheckable(true);
    choices_->addButton(button, static_cast<int>(text.choice));
    row->addWidget(button);
  }
  choices_->button(static_cast<int>(Choice::kThis))->setChecked(true);
  row->addSpacing(8);
  QToolButton* back = make_arrow(QStringLiteral("◁"), tr("To the impact before"), this);
  QToolButton* on = make_arrow(QStringLiteral("▷"), tr("To the next impact"), this);
  connect(back, &QToolButton::clicked, this, [this] { emit impactAsked(false); });
  connect(on, &QToolButton::clicked, this, [this] { emit impactAsked(true); });
  row->addWidget(back);
  row->addWidget(head_);
  row->addWidget(on);
  row->addStretch(1);
  column->addLayout(row);
  constexpr int kLeastTable = 52;  // px: a row under the heading; more of them scroll in the table itself
  table_->setMinimumHeight(kLeastTable);
  column->addWidget(table_, 1);
  head_->setAccessibleName(tr("What is compared"));
  connect(choices_, &QButtonGroup::idClicked, this, &BeforeAfterPanel::choiceChanged);
}

BeforeAfterPanel::Choice BeforeAfterPanel::choice() const { return static_cast<Choice>(choices_->checkedId()); }

void BeforeAfterPanel::choose(Choice choice) {
  choices_->button(static_cast<int>(choice))->setChecked(true);
  emit choiceChanged();
}

void BeforeAfterPanel::update_from(const Shown& run) {
  switch (choice()) {
    case Choice::kThis:
      return show_impact(impact_of_step(run.shown, run.picked), run);
    case Choice::kLast:
      return show_impact(run.newest.jumps.empty() ? nullptr : run.newest.jumps.back(), run);
    case Choice::kStart:
      moment_.reset();
      head_->setText(tr("from the start to t = %1 s").arg(run.shown.time, 0, 'f', 3));
      return table_->show_pair(since_start(run.start, run.shown));
  }
}

void BeforeAfterPanel::show_impact(const std::shared_ptr<const JumpMoment>& moment, const Shown& run) {
  if (moment == nullptr) {
    moment_.reset();
    head_->setText(choice() == Choice::kThis ? tr("no impact at this moment: PgUp goes to the last one")
                                             : tr("no impact so far"));
    return table_->show_nothing();
  }
  const double time = moment->time();
  const double just_before = std::nextafter(time, -std::numeric_limits<double>::infinity());
  const std::int64_t all = run.newest.impact_count;
  const auto [first, last] = impact_numbers(run.recorder, just_before, time, all);
  const QString number = first >= last ? tr("impact %1 of %2").arg(last).arg(all)
                                       : tr("impacts %1 to %2 of %3").arg(first).arg(last).arg(all);
  head_->setText(tr("%1, t = %2 s").arg(number).arg(time, 0, 'f', 3));
  if (std::exchange(moment_, moment) != moment) table_->show_pair(before_and_after(*moment));
}

}  // namespace carom
