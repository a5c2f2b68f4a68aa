#include "widgets/plot/plot_before.h"

#include <QCoreApplication>
#include <algorithm>
#include <qwt_plot.h>
#include <qwt_plot_curve.h>
#include <qwt_text.h>

#include "widgets/base/plotted_run.h"
#include "widgets/plot/legend_button.h"
#include "widgets/plot/series_data.h"
#include "widgets/plot/smooth_curve.h"

namespace carom {
namespace {

constexpr double kPale = 0.6;   // of the panel's colour
constexpr double kWidth = 1.4;  // px

// Although it has another name by now, or comes from a generator and has no number.
bool is_same(const Body& a, const Body& b) { return a.name == b.name || (a.id.number != 0 && a.id == b.id); }

bool move_bodies(std::vector<BodyIndex>& indices, std::span<const Body> bodies, std::span<const Body> others) {
  return std::all_of(indices.begin(), indices.end(), [&](BodyIndex& index) {
    if (index >= static_cast<int>(bodies.size())) return false;
    const Body& body = bodies[static_cast<std::size_t>(index)];
    const auto same =
        std::find_if(others.begin(), others.end(), [&body](const Body& other) { return is_same(body, other); });
    index = BodyIndex{static_cast<int>(same - others.begin())};
    return same != others.end();
  });
}

bool move_bodies(Quantity& quantity, std::span<const Body> bodies, std::span<const Body> others) {
  return move_bodies(quantity.bodies, bodies, others) && move_bodies(quantity.less.x_bodies, bodies, others);
}

}  // namespace

std::optional<Curve> curve_among(const Curve& curve, std::span<const Body> bodies,
                                 std::span<const Body> others) {
  Curve moved = curve;
  const bool there =
      move_bodies(moved.y, bodies, others) && (!moved.x || move_bodies(*moved.x, bodies, others));
  return there ? std::optional(std::move(moved)) : std::nullopt;
}

PlotBefore::PlotBefore(const PlotContent& content, QwtPlot* plot, QWidget* parent)
    : plot_(plot), magnitudes_(content.plot.logarithmic) {
  constexpr double kBelow = 10.0;  // theories have 15, curves 20
  for (const PlotLine& line : content.lines) {
    auto item = std::make_unique<SmoothCurve>(QwtText(line.label, QwtText::PlainText));
    auto* series = new DecimatedSeries;
    item->setData(series);
    item->setRenderHint(QwtPlotItem::RenderAntialiased);
    item->setStyle(line.curve ? QwtPlotCurve::Lines : QwtPlotCurve::Sticks);
    item->setZ(kBelow);
    lines_.push_back({.item = std::move(item), .series = series, .wanted = line.curve});
  }
  button_ = new LegendButton(
      QCoreApplication::translate("PlotBefore", "run before"),
      QCoreApplication::translate("PlotBefore", "The run that was left last, by the time since its start"),
      parent);
  button_->hide();
}

PlotBefore::~PlotBefore() = default;

void PlotBefore::set_run(const std::optional<PaleRun>& run, std::span<const Body> bodies) {
  run_ = run;
  taken_ = {};
  for (Line& line : lines_) {
    line.curve.reset();
    if (run_ && line.wanted) line.curve = curve_among(*line.wanted, bodies, *run_->run.bodies);
  }
  show_lines();
}

// Bars need no curve.
bool PlotBefore::has(const Line& line) const {
  if (!run_) return false;
  const Recorder& recorder = *run_->run.recorder;
  if (!line.wanted) return recorder.impulses().count() > 0;
  return line.curve && (recorder.series(*line.curve) != nullptr || recorder.path(*line.curve) != nullptr);
}

bool PlotBefore::there() const {
  return std::any_of(lines_.begin(), lines_.end(), [this](const Line& line) { return has(line); });
}

// The plot has no items of a run that there is not.
void PlotBefore::show_lines() {
  for (const Line& line : lines_) {
    line.item->attach(has(line) ? plot_ : nullptr);
    line.item->setVisible(shown_ && line.shown);
  }
}

void PlotBefore::set_shown(bool shown) {
  shown_ = shown;
  show_lines();
}

void PlotBefore::set_line_shown(std::size_t line, bool shown) {
  lines_[line].shown = shown;
  show_lines();
}

void PlotBefore::set_theme(const Theme& theme, const std::vector<QPen>& pens) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    QPen pen = pens[i];
    pen.setWidthF(std::min(pen.widthF(), kWidth));
    pen.setColor(blend(pen.color(), theme.panel, kPale));
    if (!lines_[i].wanted) pen.setStyle(Qt::SolidLine);
    lines_[i].item->setPen(pen);
  }
  pen_ = QPen(theme.muted, kWidth, Qt::DotLine);
  button_->set_look(pen_, theme.muted);
}

void PlotBefore::update_from(const QwtInterval& time, int columns) {
  if (!run_ || taken_ == std::pair(time, columns)) return;
  taken_ = {time, columns};
  const QwtInterval seen(std::max(time.minValue() - run_->shift, run_->run.from),
                         time.maxValue() - run_->shift);
  for (const Line& line : lines_) {
    line.series->clear();
    if (has(line) && seen.width() > 0.0) take(line, seen, columns);
  }
}

void PlotBefore::take(const Line& line, const QwtInterval& time, int columns) const {
  const Recorder& recorder = *run_->run.recorder;
  const Series<2>* path = line.curve ? recorder.path(*line.curve) : nullptr;
  if (path != nullptr) return line.series->take(*path, time, magnitudes_);
  line.series->take(line.wanted ? *recorder.series(*line.curve) : recorder.impulses(), time, columns,
                    magnitudes_);
  line.series->shift(run_->shift);
}

QRectF PlotBefore::bounds(const Line& line) const {
  const bool counts = has(line) && line.item->isVisible() && line.series->size() > 0 && !run_->run.lost;
  return counts ? line.series->boundingRect() : QRectF(0.0, 0.0, -1.0, -1.0);
}

QwtInterval PlotBefore::spread() const {
  QwtInterval all;
  for (const Line& line : lines_) {
    const QRectF bounds = this->bounds(line);
    if (bounds.width() >= 0.0) all |= QwtInterval(bounds.top(), bounds.bottom());
  }
  return all;
}

QwtInterval PlotBefore::x_spread() const {
  QwtInterval all;
  for (const Line& line : lines_) {
    const QRectF bounds = this->bounds(line);
    if (bounds.width() >= 0.0) all |= QwtInterval(bounds.left(), bounds.right());
  }
  return all;
}

std::vector<std::pair<QString, QPen>> PlotBefore::legend() const {
  if (!shown_ || !there()) return {};
  return {{button_->text(), pen_}};
}

}  // namespace carom
