#include "widgets/run/before_after_panel.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
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
constexpr std::array<ChoiceText, 4> kChoices = {{
    {BeforeAfterPanel::Choice::kThis, QT_TRANSLATE_NOOP("BeforeAfterPanel", "this impact"),
     QT_TRANSLATE_NOOP(
         "BeforeAfterPanel",
         "The impact at the shown moment: PgUp and PgDn go there, or a click on it. At the newest "
         "moment without one: the last impact")},
    {BeforeAfterPanel::Choice::kLast, QT_TRANSLATE_NOOP("BeforeAfterPanel", "last"),
     QT_TRANSLATE_NOOP("BeforeAfterPanel", "The last impact of the run so far")},
    {BeforeAfterPanel::Choice::kStart, QT_TRANSLATE_NOOP("BeforeAfterPanel", "from the start"),
     QT_TRANSLATE_NOOP("BeforeAfterPanel", "All bodies at the start and at the shown moment")},
    {BeforeAfterPanel::Choice::kMarked, QT_TRANSLATE_NOOP("BeforeAfterPanel", "from A to B"),
     QT_TRANSLATE_NOOP("BeforeAfterPanel",
                       "All bodies at the marks A and B: a click in a plot, with Shift for B; or Ctrl+M, "
                       "Ctrl+Shift+M at the shown moment")},
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

// Of a run that goes on from an edit the newest moment may have no impact, though the record has.
QString none_at_end(const BeforeAfterPanel::Shown& run) {
  return run.newest.impact_count > 0
             ? BeforeAfterPanel::tr("no impact since the edit: PgUp goes to the last one")
             : BeforeAfterPanel::tr("no impact so far");
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
      return show_this(run);
    case Choice::kLast:
      if (run.newest.jumps.empty()) return show_nothing(none_at_end(run));
      return show_impact(run.newest.jumps.back(), run);
    case Choice::kStart:
      moment_.reset();
      interval_.reset();
      head_->setText(tr("from the start to t = %1 s").arg(run.shown.time, 0, 'f', 3));
      return table_->show_pair(since_start(run.start, run.shown));
    case Choice::kMarked:
      return show_marked(run);
  }
}

void BeforeAfterPanel::show_this(const Shown& run) {
  if (const auto moment = impact_of_step(run.shown, run.picked)) return show_impact(moment, run);
  const bool is_newest = run.shown.time >= run.newest.time;
  if (is_newest && !run.newest.jumps.empty()) return show_impact(run.newest.jumps.back(), run);
  show_nothing(is_newest ? none_at_end(run)
                         : tr("no impact at this moment: PgUp goes to the last one, PgDn to the next"));
}

void BeforeAfterPanel::show_impact(const std::shared_ptr<const JumpMoment>& moment, const Shown& run) {
  const double time = moment->time();
  const double just_before = std::nextafter(time, -std::numeric_limits<double>::infinity());
  const std::int64_t all = run.newest.impact_count;
  const auto [first, last] = impact_numbers(run.recorder, just_before, time, all);
  const QString number = first >= last ? tr("impact %1 of %2").arg(last).arg(all)
                                       : tr("impacts %1 to %2 of %3").arg(first).arg(last).arg(all);
  head_->setText(tr("%1, t = %2 s").arg(number).arg(time, 0, 'f', 3));
  interval_.reset();
  if (std::exchange(moment_, moment) != moment) table_->show_pair(before_and_after(*moment));
}

void BeforeAfterPanel::show_marked(const Shown& run) {
  if (!run.mark_a) return show_nothing(tr("no mark A yet: click in a plot, or Ctrl+M"));
  if (!run.mark_b) return show_nothing(tr("no mark B yet: Shift and click in a plot, or Ctrl+Shift+M"));
  if (std::max(*run.mark_a, *run.mark_b) > run.newest.time)
    return show_nothing(tr("a mark is after the run so far: play on"));
  if (run.marked == nullptr) return show_nothing(tr("the run is repeated up to the marks"));
  const QString order =
      *run.mark_a <= *run.mark_b ? tr("A, t = %1 s, to B, t = %2 s") : tr("B, t = %1 s, to A, t = %2 s");
  head_->setText(order.arg(run.marked->from, 0, 'f', 3).arg(run.marked->to, 0, 'f', 3));
  moment_.reset();
  if (std::exchange(interval_, run.marked) != run.marked) table_->show_pair(before_and_after(*run.marked));
}

void BeforeAfterPanel::show_nothing(const QString& why) {
  moment_.reset();
  interval_.reset();
  head_->setText(why);
  table_->show_nothing();
}

}  // namespace carom
