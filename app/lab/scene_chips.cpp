#include "app/lab/scene_chips.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "app/lab/document_change.h"
#include "app/lab/lab_runs.h"
#include "physics/record/impact_moments.h"
#include "widgets/base/number_text.h"
#include "widgets/base/plain_text.h"
#include "widgets/run/transport_bar.h"
#include "widgets/scene/scene_view.h"

namespace carom {
namespace {

// The picked impact, or those of the step that ends at the shown moment of the record.
struct ShownImpacts {
  ImpactNumbers numbers;
  std::vector<ImpactRecord> records;
};
std::optional<ShownImpacts> shown_impacts(const LabRuns& runs) {
  if (!(runs.in_past() || runs.picked()) || !runs.there() || runs.frame()->playing) return std::nullopt;
  const Frame& shown = *runs.frame();
  const Recorder& recorder = *runs.recorders().front();
  const double rounding = kSameMoment * shown.method.step;
  const std::int64_t all = runs.newest().front()->impact_count;
  const double until = runs.picked().value_or(shown.time) + rounding;
  const double from = runs.picked() ? *runs.picked() - rounding : shown.time - shown.method.step + rounding;
  const ImpactNumbers numbers = impact_numbers(recorder, from, until, all);
  if (numbers.first > numbers.last) return std::nullopt;
  return ShownImpacts{numbers, impacts_between(recorder, from, until)};
}

QString impact_text(const ShownImpacts& shown, std::int64_t all) {
  const auto [first, last] = shown.numbers;
  return first == last ? SceneChips::tr("impact %1 of %2").arg(first).arg(all)
                       : SceneChips::tr("impacts %1 to %2 of %3").arg(first).arg(last).arg(all);
}

// "light with heavy"; empty unless it is one impact.
QString impact_pair(const ShownImpacts& shown, const std::vector<Body>& bodies) {
  if (shown.records.size() != 1) return {};
  const auto name = [&](BodyIndex body) {
    const auto index = static_cast<std::size_t>(body);
    return index < bodies.size() ? QString::fromStdString(bodies[index].name) : QString();
  };
  return SceneChips::tr("%1 with %2").arg(name(shown.records[0].a), name(shown.records[0].b));
}

// The stop's sentence without its first words: "stopped: 3rd impact"; without a stop the end of the duration.
QString stop_text(const LabRuns& runs, double duration) {
  const std::optional<Stop> stop = runs.stopped();
  if (!stop) {
    const bool at_end = !runs.in_past() && runs.at_end() && !runs.at_start() && runs.lost() == nullptr;
    return at_end ? SceneChips::tr("end, %1 s").arg(short_figure(duration)) : QString();
  }
  QString told = QString::fromStdString(sentence_of(*stop));
  for (const char* words : {"at the ", "at every ", "at ", "when "}) {
    if (!told.startsWith(words)) continue;
    told.remove(0, QString(words).size());
    break;
  }
  return SceneChips::tr("stopped: %1").arg(told);
}

QLabel* make_chip(QWidget* parent, const char* look = "chip") {
  auto* chip = new PlainLabel(parent);
  chip->setObjectName(look);
  return chip;
}

}  // namespace

SceneChips::SceneChips(SceneView& view)
    : QObject(&view),
      view_(view),
      row_(new QWidget(&view)),
      time_(make_chip(row_)),
      speed_(make_chip(row_)),
      start_(new QPushButton(row_)),
      stop_(make_chip(row_)),
      impact_(make_chip(row_)),
      follow_(new QPushButton(tr("Follow (F)"), row_)),
      status_(make_chip(&view)),
      tool_(make_chip(&view, "note")),
      position_(make_chip(&view, "note")) {
  auto* row = new QHBoxLayout(row_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  row->addWidget(time_);
  row->addWidget(speed_);
  row->addWidget(start_);
  row->addWidget(stop_);
  row->addWidget(impact_);
  stop_->setAccessibleName(tr("Why it stopped"));
  impact_->setAccessibleName(tr("Impact at this moment"));
  for (QPushButton* chip : {start_, follow_}) {
    chip->setObjectName("chip");
    chip->setFocusPolicy(Qt::NoFocus);
    chip->hide();
  }
  start_->setProperty("start", true);
  follow_->setToolTip(tr("All bodies that move have left the view: keep them in it"));
  row->addWidget(follow_);
  connect(follow_, &QPushButton::clicked, &view, &SceneView::follow);
  connect(&view, &SceneView::followOffered, this, [this](bool offered) {
    follow_->setVisible(offered);
    place();
  });
  time_->setStyleSheet("font-weight: bold;");
  speed_->setAccessibleName(tr("Speed"));
  speed_->setToolTip(tr("Simulated seconds per second"));
  tool_->setAccessibleName(tr("What the mouse does"));
  for (QLabel* chip : {stop_, impact_, status_, tool_}) chip->hide();
  view.installEventFilter(this);
  connect(&view, &SceneView::cursorMoved, this, &SceneChips::show_position);
  connect(&view, &SceneView::hintChanged, this, [this](const QString& hint) {
    hint_ = hint;
    place();
  });
  connect(&view, &SceneView::cursorLeft, position_, &QLabel::hide);
}

bool SceneChips::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) place();
  return QObject::eventFilter(watched, event);
}

void SceneChips::show_tool(const QString& text) {
  tool_text_ = text;
  place();
}

void SceneChips::show_position(double x, double y) {
  position_->setText(
      QString("x = %1 m, y = %2 m").arg(x, 0, 'f', 3).arg(y, 0, 'f', 3).replace('-', QChar(0x2212)));
  position_->show();
  place();
}

void SceneChips::show_time(const LabRuns& runs) {
  QString speed = TransportBar::speed_text(runs.speed());
  if (const auto frame = runs.frame()) {
    time_->setToolTip(tr("Simulated time\n%1 steps, %2 rejected\n%3 evaluations of a body's acceleration")
                          .arg(frame->steps)
                          .arg(frame->rejected_steps)
                          .arg(frame->evaluations));
    const QString time = QString("t = %1 s").arg(runs.shown_time(), 0, 'f', 3);
    // A stop in the newest step is no moment of the past to people.
    const Frame& newest = *runs.newest().front();
    const bool in_past = runs.in_past() && frame->steps < newest.steps;
    time_->setText(in_past ? tr("%1 of %2 s").arg(time).arg(newest.time, 0, 'f', 3) : time);
    // The requested speed, or the machine's speed if that is clearly less.
    const bool lags =
        frame->playing && frame->realised_speed > 0.0 && frame->realised_speed < 0.85 * runs.speed();
    if (runs.slow()) {
      speed += tr(", slow near an impact");
    } else if (lags) {
      speed += tr(", runs at ×%1").arg(frame->realised_speed, 0, 'g', 2);
    } else if (slows_) {
      speed += tr(", slower near impacts");
    }
  } else {
    time_->setText("t = …");
  }
  speed_->setText(speed);
  speed_->setVisible(speed != TransportBar::speed_text(1.0));
  const QString stop = stop_text(runs, runs.duration());
  stop_->setText(stop);
  stop_->setVisible(!stop.isEmpty());
  const auto impacts = shown_impacts(runs);
  const QString impact = impacts ? impact_text(*impacts, runs.newest().front()->impact_count) : QString();
  impact_->setText(impact);
  impact_->setVisible(!impact.isEmpty());
  say_moment(runs, impacts ? impact_pair(*impacts, *runs.frame()->bodies) : QString());
}

// "paused at 0.333 s, impact 1 of 5, light with heavy"; never the running clock.
void SceneChips::say_moment(const LabRuns& runs, const QString& impact_pair) {
  if (runs.frame() == nullptr || !runs.there()) return;
  QStringList said;
  if (runs.frame()->playing) {
    said << tr("playing");
  } else {
    said << tr("paused at %1 s").arg(runs.shown_time(), 0, 'f', 3);
    for (const QString& more : {stop_->text(), impact_->text(), impact_pair}) {
      if (!more.isEmpty()) said << more;
    }
  }
  const QString text = said.join(", ");
  if (std::exchange(said_, text) != text) view_.say(text);
}

void SceneChips::show_start(const StartOrigin& start) {
  start_->setVisible(start.from.has_value());
  if (start.from) {
    start_->setText(tr("new start, from %1 s").arg(*start.from, 0, 'f', 3) + QStringLiteral(" ▾"));
    start_->setToolTip(plain_tip(tr("This moment of the run before, with the edit: %1").arg(start.by)));
  }
  place();
}

void SceneChips::show_notices(const LabRuns& runs, const QString& more, bool lost_shown) {
  const auto frame = runs.frame();
  QStringList notices;
  if (frame == nullptr) notices << tr("preparing the scene …");
  for (const QString& notice : {runs.waits(), more}) {
    if (!notice.isEmpty()) notices << notice;
  }
  if (!runs.there() && runs.frame() != nullptr && !runs.frame()->playing && runs.way_is_long())
    notices << tr("computing this moment: t = %1 s").arg(runs.frame()->time, 0, 'f', 1);
  if (runs.replayed())
    notices
        << tr("replaying the run after an edit: t = %1 s; Space stops here").arg(*runs.replayed(), 0, 'f', 1);
  QString details;  // of what the run itself says
  if (frame != nullptr && frame->status != "ok" && !(frame->lost && lost_shown)) {
    details = QString::fromStdString(frame->status);
    notices << (frame->lost ? details : QString::fromStdString(frame->brief));
  }
  for (const auto& each : runs.frames()) {
    if (each->rows_known_until < each->time) {
      notices << tr("replaying the run for new curves: t = %1 s").arg(each->rows_known_until, 0, 'f', 1);
    } else if (!each->lost && each->time + each->method.step <= frame->time) {
      notices << tr("another method catches up: t = %1 s").arg(each->time, 0, 'f', 1);
    }
  }
  status_text_ = notices.join("; ");
  status_->setVisible(!status_text_.isEmpty());
  status_->setToolTip(plain_tip(details.isEmpty() ? status_text_ : status_text_ + "\n\n" + details));
  place();
}

void SceneChips::place() {
  constexpr int kEdge = 10;       // px
  constexpr int kGap = 6;         // px between chips
  constexpr int kPadding = 22;    // px, of a chip's text left and right, with its border
  constexpr int kLeastRoom = 60;  // px
  const auto elide = [&](QLabel* chip, const QString& text, int room) {
    chip->setText(chip->fontMetrics().elidedText(text, Qt::ElideRight, std::max(room, kLeastRoom) - kPadding));
  };
  row_->adjustSize();
  row_->move(kEdge, kEdge);
  row_->raise();
  const QString told = hint_.isEmpty() ? tool_text_ : hint_;
  const int room = view_.width() - row_->width() - 4 * kEdge;
  tool_->setText(tool_->fontMetrics().elidedText(told, Qt::ElideRight, room));
  tool_->setToolTip(plain_tip(told));
  tool_->setVisible(!told.isEmpty() && room > kLeastRoom);
  tool_->adjustSize();
  tool_->move(view_.width() - tool_->width() - kEdge - 2, kEdge + 4);
  tool_->raise();
  const int second_row = kEdge + row_->height() + kGap;
  position_->adjustSize();
  position_->move(view_.width() - position_->width() - kEdge - 2, second_row + 4);
  position_->raise();
  elide(status_, status_text_, view_.width() - 3 * kEdge - (position_->isVisible() ? position_->width() : 0));
  status_->adjustSize();
  status_->move(kEdge, second_row);
  status_->raise();
}

}  // namespace carom
