#include "widgets/plot/run_plot.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QStringList>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <qwt_axis.h>
#include <qwt_plot.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_plot_marker.h>
#include <qwt_symbol.h>
#include <qwt_text.h>

#include "physics/preset/preset.h"
#include "widgets/base/elided_label.h"
#include "widgets/base/number_text.h"
#include "widgets/base/plain_text.h"
#include "widgets/plot/distribution.h"
#include "widgets/plot/legend_button.h"
#include "widgets/plot/legend_row.h"
#include "widgets/plot/plot_axes.h"
#include "widgets/plot/plot_before.h"
#include "widgets/plot/plot_canvas.h"
#include "widgets/plot/plot_gestures.h"
#include "widgets/plot/plot_impacts.h"
#include "widgets/plot/plot_labels.h"
#include "widgets/plot/plot_notes.h"
#include "widgets/plot/plot_playhead.h"
#include "widgets/plot/plot_scale.h"
#include "widgets/plot/plot_theories.h"
#include "widgets/plot/series_data.h"
#include "widgets/plot/smooth_curve.h"
#include "widgets/plot/zoom_box.h"

namespace carom {
namespace {

constexpr double kSumWidth = 4.5;  // px
constexpr int kLeastHeight = 120;  // px: two of them below the inspector of a small window

// Of a part or a component beside the main line, where several runs are plotted: the colour is that of the run,
// the dashes are those of the part, and further apart the later the run. No main line has them: its gaps are
// 2 widths.
QPen pen_of_part(std::size_t part, std::size_t run, const Theme& theme) {
  const double gap = 3.0 + 1.5 * static_cast<double>(run);  // widths of the pen
  const std::array<QList<qreal>, 4> dashes = {
      QList<qreal>{7.0, gap}, {1.0, gap}, {7.0, gap, 1.0, gap}, {7.0, gap, 1.0, gap, 1.0, gap}};
  QPen pen(theme.series[run % theme.series.size()], 0.7 * kPlotLineWidth);
  pen.setDashPattern(dashes[part % dashes.size()]);
  return pen;
}

}  // namespace

RunPlot::RunPlot(PlotContent content, const Theme& theme, QWidget* parent)
    : QFrame(parent), content_(std::move(content)) {
  setObjectName("panel");
  setMinimumHeight(kLeastHeight);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(12, 6, 8, 6);
  layout->setSpacing(2);
  build_plot();
  build_header();
  layout->addWidget(plot_, 1);
  set_theme(theme);
  axes_->fit_values({});
  set_time_range(time_range_);
}

// The plot must still be complete when the leave event arrives.
RunPlot::~RunPlot() { hide(); }

void RunPlot::build_header() {
  setAccessibleName(tr("Plot of %1").arg(content_.title));
  plot_->setAccessibleName(accessibleName());
  auto* header = new QHBoxLayout;
  header->setSpacing(4);
  auto* title = new ElidedLabel(this);
  title->setObjectName("title");
  title->set_whole(content_.title);
  constexpr int kLeastTitle = 80;  // px: a long one doesn't keep the window wide
  title->setMinimumWidth(std::min(kLeastTitle, title->sizeHint().width()));
  unit_ = new PlainLabel(content_.unit.name, this);
  unit_->setObjectName("muted");
  title->setCursor(Qt::OpenHandCursor);
  title->setToolTip(plain_tip(content_.tip.isEmpty() ? content_.title : content_.tip));
  legend_ = new LegendRow(this);
  header->addWidget(title, 0, Qt::AlignTop);
  header->addWidget(unit_, 0, Qt::AlignTop);
  header->addStretch(1);
  header->addWidget(legend_, 0, Qt::AlignTop);
  for (const PlotLine& line : content_.lines) {
    auto* button = new LegendButton(content_.legend(line), line.tip, this);
    lines_.push_back({button, {}});
    legend_->add(button);
    connect(button, &LegendButton::toggled, this, [this, i = lines_.size() - 1](bool shown) {
      for (std::size_t k = 0; k < runs_.size(); ++k)
        lines_[i].items[k].item->setVisible(shown && runs_[k].shown);
      before_->set_line_shown(i, shown);
      emit curvesChanged();
    });
  }
  if (LegendButton* theory = theories_->button(); theory != nullptr) {
    legend_->add(theory);
    connect(theory, &LegendButton::toggled, this, [this](bool shown) {
      theories_->set_shown(shown);
      emit curvesChanged();
    });
  }
  for (std::size_t i = 0; distribution_ != nullptr && i < distribution_->buttons().size(); ++i) {
    LegendButton* button = distribution_->buttons()[i];
    legend_->add(button);
    connect(button, &LegendButton::toggled, this, [this, i](bool shown) {
      distribution_->set_shown(i, shown);
      emit curvesChanged();
    });
  }
  legend_->add(before_->button());
  legend_->set_there(before_->button(), false);
  connect(before_->button(), &LegendButton::toggled, this, [this](bool shown) {
    before_->set_shown(shown);
    emit curvesChanged();
  });
  static_cast<QVBoxLayout*>(layout())->addLayout(header);
}

void RunPlot::build_plot() {
  plot_ = new QwtPlot(this);
  plot_->setAutoReplot(false);
  plot_->setMinimumSize(120, 60);
  plot_->plotLayout()->setAlignCanvasToScales(true);
  if (content_.shows != PlotContent::Shows::kLines) {
    distribution_ = std::make_unique<Distribution>(content_.shows, plot_, this);
  }
  auto* canvas = new PlotCanvas(plot_);
  plot_->setCanvas(canvas);
  canvas->setCursor(Qt::CrossCursor);
  canvas->setToolTip(
      tr("Wheel: zoom in time. Ctrl+wheel: zoom the values. Ctrl+drag: zoom to a box.\n"
         "Drag: move. Double click or Ctrl+Home: show all again.\n"
         "Click: mark A, with Shift: mark B; the Reading tab shows the values there and between.\n"
         "Click on an impact: goes to its moment."));
  axes_ = std::make_unique<PlotAxes>(plot_, over_time() ? ShownUnit{"s"} : content_.x_unit, content_.unit,
                                     content_.plot.logarithmic);

  grid_ = std::make_unique<QwtPlotGrid>();
  grid_->enableX(false);
  grid_->attach(plot_);
  theories_ = std::make_unique<PlotTheories>(content_, plot_, this);
  before_ = std::make_unique<PlotBefore>(content_, plot_, this);
  notes_ = std::make_unique<PlotNotes>(plot_);
  notes_->set_notes(content_.plot.notes);
  cursor_ = std::make_unique<QwtPlotMarker>();
  cursor_->setLineStyle(QwtPlotMarker::VLine);
  cursor_->setVisible(false);
  cursor_->attach(plot_);

  for (std::size_t i = 0; i < marks_.size(); ++i) {
    marks_[i] = std::make_unique<QwtPlotMarker>();
    marks_[i]->setLineStyle(QwtPlotMarker::VLine);
    marks_[i]->setLabelAlignment(Qt::AlignRight | Qt::AlignBottom);
    marks_[i]->setVisible(false);
    marks_[i]->attach(plot_);
  }

  labels_ = new PlotLabels(plot_);
  zoom_box_ = new ZoomBox(plot_);
  connect(zoom_box_, qOverload<const QRectF&>(&QwtPlotPicker::selected), this, &RunPlot::boxAsked);
  auto* gestures = new PlotGestures(plot_);
  connect(gestures, &PlotGestures::timeZoomAsked, this, &RunPlot::timeZoomAsked);
  connect(gestures, &PlotGestures::valueZoomAsked, this, &RunPlot::valueZoomAsked);
  connect(gestures, &PlotGestures::panAsked, this, &RunPlot::panAsked);
  // The first click of a double click on an impact goes there; the second one does no more.
  connect(gestures, &PlotGestures::resetAsked, this, [this](const QPointF& at) {
    if (!over_time() || !impact_at(at)) emit resetAsked();
  });
  connect(gestures, &PlotGestures::hovered, this, &RunPlot::hover);
  connect(gestures, &PlotGestures::clicked, this, [this](const QPointF& at, Qt::KeyboardModifiers modifiers) {
    click(at, modifiers.testFlag(Qt::ShiftModifier));
  });
  playhead_ = new PlotPlayhead(plot_);  // its head goes before the other gestures
  connect(playhead_, &PlotPlayhead::scrubBegan, this, &RunPlot::scrubBegan);
  connect(playhead_, &PlotPlayhead::scrubbed, this, &RunPlot::scrubbed);
  connect(playhead_, &PlotPlayhead::scrubEnded, this, &RunPlot::scrubEnded);
}

void RunPlot::set_theme(const Theme& theme) {
  theme_ = theme;
  plot_->setCanvasBackground(theme.panel);
  static_cast<PlotCanvas*>(plot_->canvas())->set_focus_color(theme.accent);
  grid_->setPen(theme.grid, 1.0);
  cursor_->setLinePen(theme.muted, 1.0, Qt::DashLine);
  playhead_->set_color(theme.text);
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    marks_[i]->setLinePen(theme.accent, 1.2);
    QwtText label(i == 0 ? "A" : "B");
    label.setColor(theme.accent);
    marks_[i]->setLabel(label);
  }
  labels_->set_color(theme.muted);
  axes_->set_color(theme.muted);
  zoom_box_->setRubberBandPen(QPen(theme.accent, 1.0, Qt::DashLine));
  theories_->set_theme(theme);
  if (distribution_ != nullptr) distribution_->set_theme(theme);
  notes_->set_theme(theme);
  set_looks();
}

// The sum among a plot's lines, or the first one.
bool RunPlot::is_main(std::size_t line) const {
  const auto sum =
      std::find_if(content_.lines.begin(), content_.lines.end(), [](const PlotLine& l) { return l.sum; });
  return sum == content_.lines.end() ? line == 0
                                     : line == static_cast<std::size_t>(sum - content_.lines.begin());
}

// With one run each line has its colour; with several each run has, and the lines beside the main one are
// thinner.
QPen RunPlot::pen(std::size_t line, std::size_t run) const {
  if (runs_.size() > 1) {
    if (is_main(line)) return pen_of_run(run, theme_);
    std::size_t part = line;
    for (std::size_t k = 0; k < line; ++k) part -= is_main(k) ? 1 : 0;
    return pen_of_part(part, run, theme_);
  }
  QPen pen = pen_of_run(line, theme_);
  if (!content_.lines[line].sum) return pen;
  return QPen(blend(pen.color(), theme_.panel, 0.45), kSumWidth, Qt::SolidLine);
}

void RunPlot::set_looks() {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].button->set_look(pen(i, 0), theme_.muted);
    for (std::size_t k = 0; k < lines_[i].items.size(); ++k) {
      QPen look = pen(i, k);
      if (!content_.lines[i].curve) look.setStyle(Qt::SolidLine);
      lines_[i].items[k].item->setPen(look);
      lines_[i].items[k].item->setSymbol(nullptr);
      if (!content_.lines[i].curve) set_heads(lines_[i].items[k]);
    }
  }
  std::vector<QPen> pens;
  for (std::size_t i = 0; i < lines_.size(); ++i)
    pens.push_back(runs_.size() > 1 ? pen(i, 0) : pen_of_run(i, theme_));
  before_->set_theme(theme_, pens);
}

// The first run's curves are drawn over the others'; a single run's sum is drawn behind its parts.
void RunPlot::set_runs(const std::vector<PlottedRun>& runs) {
  const bool others = runs.size() != runs_.size() || lines_.front().items.empty();
  runs_ = runs;
  if (!others) return;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].items.clear();
    const PlotLine& line = content_.lines[i];
    for (std::size_t k = 0; k < runs.size(); ++k) {
      auto item = std::make_unique<SmoothCurve>(QwtText(line.label, QwtText::PlainText));
      auto* series = new DecimatedSeries;
      item->setData(series);
      item->setRenderHint(QwtPlotItem::RenderAntialiased);
      item->setStyle(line.curve ? QwtPlotCurve::Lines : QwtPlotCurve::Sticks);
      item->setZ(item->z() - 0.1 * static_cast<double>(k) - (line.sum && runs.size() == 1 ? 1.0 : 0.0));
      item->attach(plot_);
      lines_[i].items.push_back({std::move(item), series});
    }
  }
  set_looks();
}

bool RunPlot::shows(std::size_t line) const { return lines_[line].button->isChecked(); }

// Bars have heads, unless these would overlap.
void RunPlot::set_heads(const Item& curve) {
  constexpr int kPixelsPerHead = 4;
  const bool wanted = static_cast<int>(curve.series->size()) * kPixelsPerHead < plot_->canvas()->width();
  if (wanted == (curve.item->symbol() != nullptr)) return;
  constexpr QSize kHead(6, 6);  // px
  curve.item->setSymbol(
      wanted ? new QwtSymbol(QwtSymbol::Ellipse, curve.item->pen().color(), QPen(Qt::NoPen), kHead) : nullptr);
}

void RunPlot::set_time_range(const QwtInterval& range) {
  time_range_ = range;
  if (over_time()) axes_->set_x(range);
}

void RunPlot::set_run_before(const std::optional<PaleRun>& run, std::span<const Body> bodies) {
  before_->set_run(run, bodies);
  legend_->set_there(before_->button(), before_->there());
}

void RunPlot::update_distribution(const Recorder& recorder, bool hold) {
  distribution_->update_from(recorder, time_range_);
  if (hold) return;
  axes_->fit_values(distribution_->spread());
  axes_->fit_x(distribution_->x_spread());
}

void RunPlot::update_from(const std::vector<PlottedRun>& runs, bool hold) {
  if (distribution_ != nullptr) {
    if (!runs.empty()) update_distribution(*runs.front().recorder, hold);
    return;
  }
  set_runs(runs);
  const int columns = std::max(plot_->canvas()->width(), 1);
  const bool magnitudes = content_.plot.logarithmic;
  QwtInterval spread;
  QwtInterval x_spread;
  Scales scales;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const Recorder& recorder = *runs[k].recorder;
    if (k == 0) scales = recorder.scales();
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const std::optional<Curve>& curve = content_.lines[i].curve;
      const Item& item = lines_[i].items[k];
      DecimatedSeries& series = *item.series;
      if (!curve) {
        series.take(recorder.impulses(), time_range_, columns, magnitudes);
        set_heads(item);
      } else if (const Series<2>* path = recorder.path(*curve); path != nullptr) {
        series.take(*path, time_range_, magnitudes);
      } else if (const Series<1>* points = recorder.series(*curve); points != nullptr) {
        series.take(*points, time_range_, columns, magnitudes);
      } else {
        series.clear();
      }
      item.item->setVisible(shows(i) && runs[k].shown);
      if (!item.item->isVisible() || series.size() == 0) continue;
      const QRectF bounds = series.boundingRect();
      spread |= QwtInterval(bounds.top(), bounds.bottom());
      x_spread |= QwtInterval(bounds.left(), bounds.right());
      if (!curve) spread |= 0.0;  // bars start at zero
    }
  }
  if (!runs.empty()) theories_->update_from(*runs.front().recorder, time_range_);
  before_->update_from(time_range_, columns);
  if (hold) {
    axes_->set_values(axes_->values());  // recomputes the ticks for the new size
    return;
  }
  if (const QwtInterval pale = before_->spread(); pale.isValid()) spread |= pale;
  if (const QwtInterval pale = before_->x_spread(); pale.isValid()) x_spread |= pale;
  const bool begun = x_spread.width() > 0.0;
  spread = theories_->spread(over_time() ? time_range_ : x_spread, spread, begun);
  const double scale = content_.scale == nullptr ? 0.0 : scales.*content_.scale;
  axes_->fit_values(spread, {content_.rounding.zero * scale, content_.rounding.range * scale});
  if (!over_time() && x_spread.isValid()) axes_->fit_x(x_spread);
}

void RunPlot::set_cursor(std::optional<double> time) {
  cursor_time_ = over_time() ? time : std::nullopt;
  cursor_->setVisible(cursor_time_.has_value());
  if (cursor_time_) cursor_->setXValue(*cursor_time_);
  show_readout();
}

void RunPlot::set_playhead(std::optional<double> time) {
  playhead_->set_time(over_time() ? time : std::nullopt);
}

void RunPlot::set_marks(std::optional<double> a, std::optional<double> b) {
  const std::array times = {a, b};
  for (std::size_t i = 0; i < times.size(); ++i) {
    marks_[i]->setVisible(times[i] && over_time());
    if (times[i]) marks_[i]->setXValue(*times[i]);
  }
}

std::vector<std::pair<QString, QPen>> RunPlot::legend() const {
  std::vector<std::pair<QString, QPen>> entries;
  if (runs_.size() > 1) {
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      if (runs_[k].shown) entries.emplace_back(runs_[k].name, pen_of_run(k, theme_));
    }
  }
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const QString text = lines_[i].button->text();
    if (shows(i) && !text.isEmpty()) entries.emplace_back(text, pen(i, 0));
  }
  for (auto& theory : theories_->legend()) entries.push_back(std::move(theory));
  for (auto& before : before_->legend()) entries.push_back(std::move(before));
  if (distribution_ != nullptr) return distribution_->legend();
  return entries;
}

const Series<1>* RunPlot::series_of(std::size_t line, std::size_t run) const {
  const std::optional<Curve>& curve = content_.lines[line].curve;
  return curve && run < runs_.size() ? runs_[run].recorder->series(*curve) : nullptr;
}

double RunPlot::snapped(double time) const {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Series<1>* series = series_of(i, 0);
    if (const auto* point = series == nullptr ? nullptr : series->at(time); point != nullptr) return point->at;
  }
  return time;
}

void RunPlot::set_notes(const std::vector<PlotNote>& notes) {
  content_.plot.notes = notes;
  notes_->set_notes(notes);
}

std::optional<std::size_t> RunPlot::note_at(const QPointF& pixel) const { return notes_->at(pixel); }

void RunPlot::set_chip_visible(bool visible) { labels_->set_zoomed(visible); }

void RunPlot::replot() { plot_->replot(); }

// The first run's.
std::optional<double> RunPlot::impact_at(const QPointF& at) const {
  if (!over_time() || runs_.empty()) return std::nullopt;
  const bool bars = std::any_of(content_.lines.begin(), content_.lines.end(),
                                [](const PlotLine& line) { return !line.curve.has_value(); });
  const QPointF pixel(plot_->transform(QwtAxis::XBottom, at.x()), plot_->transform(QwtAxis::YLeft, at.y()));
  return impact_under(*plot_, *runs_.front().recorder, bars, pixel);
}

void RunPlot::click(const QPointF& at, bool second) {
  if (!over_time()) return;
  const std::optional<double> impact = second ? std::nullopt : impact_at(at);
  if (impact) return emit impactClicked(*impact);
  emit timeClicked(snapped(at.x()), second);
}

void RunPlot::hover(const std::optional<QPointF>& at) {
  plot_->canvas()->setCursor(at && impact_at(*at) ? Qt::PointingHandCursor : Qt::CrossCursor);
  if (over_time()) {
    emit timeHovered(at ? std::optional(snapped(at->x())) : std::nullopt);
    return;
  }
  if (!at) return labels_->hide_values();
  const auto place = [](double value, const ShownUnit& unit) { return unit.after(figure(unit.of(value))); };
  labels_->show_values(distribution_ != nullptr
                           ? distribution_->readout(at->x())
                           : place(at->x(), content_.x_unit) + ", " + place(at->y(), content_.unit));
}

void RunPlot::show_readout() {
  if (!cursor_time_) return labels_->hide_values();
  QStringList values;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (!shows(i)) continue;
    const PlotLine& line = content_.lines[i];
    QStringList of_runs;
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      const Series<1>* series = series_of(i, k);
      const auto* point = series == nullptr ? nullptr : series->at(*cursor_time_);
      if (point == nullptr || !runs_[k].shown) continue;
      // Where only extremes are kept the value belongs to a nearby time.
      const bool near_by = *cursor_time_ < series->whole_since();
      of_runs << (near_by ? QStringLiteral("≈ ") : QString()) + figure(line.unit.of(point->value[0]));
    }
    if (of_runs.isEmpty()) continue;
    QString value = line.label + " " + of_runs.join(" | ");
    if (!line.theory.empty())
      value += tr(" (theory %1)").arg(figure(line.unit.of(line.theory.formula(*cursor_time_))));
    values << (content_.unit.name.isEmpty() ? line.unit.after(value) : value).trimmed();
  }
  labels_->show_values(figure(*cursor_time_, 5) + " s", values, content_.unit.after(QString()),
                       plot_->transform(QwtAxis::XBottom, *cursor_time_));
}

}  // namespace carom
