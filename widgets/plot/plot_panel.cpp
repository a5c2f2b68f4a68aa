#include "widgets/plot/plot_panel.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QPointer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <qwt_plot.h>
#include <tuple>
#include <utility>

#include "widgets/base/ask.h"
#include "widgets/plot/note_menu.h"
#include "widgets/plot/plot_content.h"
#include "widgets/plot/plot_dialog.h"
#include "widgets/plot/plot_export.h"
#include "widgets/plot/plot_scale.h"
#include "widgets/plot/run_plot.h"
#include "widgets/plot/runs_legend.h"

namespace carom {
namespace {

// Whether both are drawn the same, but for their notes.
bool looks_alike(const PlotContent& a, const PlotContent& b) {
  Plot plot = a.plot;
  plot.notes = b.plot.notes;
  return plot == b.plot && a.title == b.title &&
         std::equal(a.lines.begin(), a.lines.end(), b.lines.begin(), b.lines.end(),
                    [](const PlotLine& x, const PlotLine& y) {
                      return x.label == y.label && x.theory == y.theory && x.first_theory == y.first_theory;
                    });
}

}  // namespace

PlotPanel::PlotPanel(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  legend_ = new RunsLegend(this);
  connect(legend_, &RunsLegend::toggled, this, [this](std::size_t run, bool shown) {
    runs_[run].shown = shown;
    schedule();
  });
  layout->addWidget(legend_);
  timer_.setSingleShot(true);
  timer_.setInterval(0);
  connect(&timer_, &QTimer::timeout, this, &PlotPanel::refresh);
  quiet_.setSingleShot(true);
  constexpr int kQuiet = 25;  // ms without new frames
  quiet_.setInterval(kQuiet);
  connect(&quiet_, &QTimer::timeout, this, [this] {
    if (waiting_ > 0) refresh();
  });
  menu_ = new QMenu(tr("&Plots"), this);
  menu_->setToolTipsVisible(true);
  for (const PlotContent& content : named_plots()) {
    QAction* action = menu_->addAction(content.title);
    action->setToolTip(content.tip);
    action->setCheckable(true);
    const std::string& id = content.plot.id;
    action->setData(QString::fromStdString(id));
    connect(action, &QAction::triggered, this, [this, &id](bool on) { set_shown(id, on); });
  }
  menu_->addSeparator();
  QAction* another = menu_->addAction(tr("&New plot..."));
  another->setToolTip(tr("Any quantity of the scene or of its bodies, over time or over another one"));
  connect(another, &QAction::triggered, this, [this] { edit(nullptr); });
  set_plots({}, {});
}

PlotPanel::~PlotPanel() {
  for (RunPlot* plot : std::exchange(plots_, {})) {
    plot->disconnect(this);
    delete plot;
  }
}

void PlotPanel::set_theme(const Theme& theme) {
  theme_ = theme;
  for (RunPlot* plot : plots_) plot->set_theme(theme);
  legend_->show_runs(runs_, theme_);
  schedule();
}

void PlotPanel::set_plots(const std::vector<Plot>& plots, const std::vector<Body>& bodies) {
  std::vector<PlotContent> contents;
  for (const Plot& plot : plots.empty() ? default_plots() : plots)
    contents.push_back(content_of(plot, bodies, first_theories_));
  bodies_ = bodies;
  mark_a_.reset();
  mark_b_.reset();
  zoomed_.clear();
  time_zoom_.reset();
  for (RunPlot* plot : std::exchange(plots_, {})) put_away(plot);
  for (const PlotContent& content : contents) insert(plots_.size(), content);
  mark_menu();
  schedule();
}

// Plots know bodies by their index.
void PlotPanel::set_bodies(const std::vector<Body>& bodies, const std::vector<Plot>& plots) {
  const auto end = static_cast<std::ptrdiff_t>(std::min(bodies.size(), bodies_.size()));
  const bool same_places = std::equal(bodies.begin(), bodies.begin() + end, bodies_.begin(),
                                      [](const Body& a, const Body& b) { return a.name == b.name; });
  bodies_ = bodies;
  if (!same_places) return set_plots(plots, bodies);
  change_plots(plots);
}

void PlotPanel::change_plots(const std::vector<Plot>& plots) {
  std::vector<PlotContent> contents;
  for (const Plot& plot : plots) contents.push_back(content_of(plot, bodies_, first_theories_));
  const auto shows = [](const RunPlot* plot, const PlotContent& content) {
    return looks_alike(plot->content(), content);
  };
  if (plots == chosen() && std::equal(plots_.begin(), plots_.end(), contents.begin(), shows)) return;
  std::vector<RunPlot*> old = std::exchange(plots_, {});
  for (const PlotContent& content : contents) {
    const auto shown =
        std::find_if(old.begin(), old.end(), [&](const RunPlot* each) { return shows(each, content); });
    if (shown == old.end()) {
      insert(plots_.size(), content);
      continue;
    }
    plots_.push_back(*shown);
    old.erase(shown);
    plots_.back()->set_notes(content.plot.notes);
    static_cast<QVBoxLayout*>(layout())->insertWidget(static_cast<int>(plots_.size()), plots_.back(), 1);
  }
  for (RunPlot* plot : old) drop(plot);
  mark_menu();
  schedule();
}

void PlotPanel::insert(std::size_t place, const PlotContent& content) {
  auto* plot = new RunPlot(content, theme_, this);
  static_cast<QVBoxLayout*>(layout())->insertWidget(static_cast<int>(place) + 1, plot, 1);
  plots_.insert(plots_.begin() + static_cast<std::ptrdiff_t>(place), plot);
  plot->set_run_before(before_, bodies_);
  connect_plot(plot);
}

void PlotPanel::drop(RunPlot* plot) {
  std::erase(plots_, plot);
  std::erase(zoomed_, plot);
  if (zoomed_.empty()) time_zoom_.reset();
  put_away(plot);
}

// It is in no list any more. If it was under the mouse, hiding it sends a mouse event to the plot below, which
// may ask for all plots. It is deleted later, when none of its functions is running.
void PlotPanel::put_away(RunPlot* plot) {
  plot->disconnect(this);
  plot->hide();
  plot->deleteLater();
}

void PlotPanel::changed() {
  mark_menu();
  schedule();
  emit layoutChanged();
}

void PlotPanel::add(const Plot& plot) {
  const std::size_t count = plots_.size();
  insert(count, content_of(plot, bodies_, first_theories_));
  changed();
  if (plots_.size() > count) emit plotAdded(plots_.back());  // it was not refused
}

void PlotPanel::replace(RunPlot* old, const Plot& plot) {
  const PlotContent content = content_of(plot, bodies_, first_theories_);
  const auto place = static_cast<std::size_t>(std::find(plots_.begin(), plots_.end(), old) - plots_.begin());
  drop(old);
  insert(place, content);
  changed();
}

void PlotPanel::remove(RunPlot* plot) {
  if (plots_.size() < 2) return;
  drop(plot);
  changed();
}

bool PlotPanel::has(const RunPlot* plot) const {
  return std::find(plots_.begin(), plots_.end(), plot) != plots_.end();
}

std::vector<Plot> PlotPanel::chosen() const {
  std::vector<Plot> all;
  for (const RunPlot* plot : plots_) all.push_back(plot->content().plot);
  return all;
}

std::vector<Curve> PlotPanel::curves() const {
  std::vector<Curve> all;
  for (const RunPlot* plot : plots_) {
    for (const PlotLine& line : plot->content().lines) {
      if (line.curve && std::find(all.begin(), all.end(), *line.curve) == all.end()) all.push_back(*line.curve);
    }
  }
  return all;
}

bool PlotPanel::shows(std::string_view id) const {
  return std::any_of(plots_.begin(), plots_.end(),
                     [id](const RunPlot* plot) { return plot->content().plot.id == id; });
}

// Named plots come first, in the order of their table.
void PlotPanel::set_shown(std::string_view id, bool shown) {
  if (shown == shows(id)) return;
  const std::span<const PlotContent> table = named_plots();
  const auto rank = [&](std::string_view wanted) {
    return std::find_if(table.begin(), table.end(), [&](const PlotContent& c) { return c.plot.id == wanted; }) -
           table.begin();
  };
  const auto place = std::find_if(plots_.begin(), plots_.end(), [&](const RunPlot* plot) {
    return rank(plot->content().plot.id) >= rank(id);
  });
  if (!shown) {
    remove(*place);
    mark_menu();
    return;
  }
  insert(static_cast<std::size_t>(place - plots_.begin()), table[static_cast<std::size_t>(rank(id))]);
  changed();
  const auto added = std::find_if(plots_.begin(), plots_.end(),
                                  [&](const RunPlot* plot) { return plot->content().plot.id == id; });
  if (added != plots_.end()) emit plotAdded(*added);  // it was not refused
}

bool PlotPanel::in_head(const QPoint& at) const {
  return std::any_of(plots_.begin(), plots_.end(), [&](const RunPlot* each) {
    return each->geometry().contains(at) && at.y() < each->y() + each->plot()->y();
  });
}

void PlotPanel::mark_menu() {
  for (QAction* action : menu_->actions()) {
    if (!action->isCheckable()) continue;
    const bool shown = shows(action->data().toString().toStdString());
    action->setChecked(shown);
    action->setEnabled(!shown || plots_.size() > 1);
  }
}

void PlotPanel::edit(RunPlot* plot) {
  auto* dialog = new PlotDialog(bodies_, this);
  if (plot != nullptr) dialog->set_plot(plot->content().plot);
  // The plot may be deleted while the dialog is open.
  ask(dialog, [this, dialog, is_new = plot == nullptr, changed = QPointer<RunPlot>(plot)] {
    if (is_new) {
      add(dialog->plot());
    } else if (changed != nullptr && has(changed)) {
      replace(changed, dialog->plot());
    }
  });
}

// Entries for the plot under the mouse, and for all plots.
void PlotPanel::contextMenuEvent(QContextMenuEvent* event) {
  const auto under = std::find_if(plots_.begin(), plots_.end(),
                                  [&](const RunPlot* plot) { return plot->geometry().contains(event->pos()); });
  if (under == plots_.end()) {
    menu_->popup(event->globalPos());
    return;
  }
  RunPlot* plot = *under;
  // The entries act on this plot while it exists.
  const auto with_plot = [this, there = QPointer<RunPlot>(plot)](auto&& what) {
    return [this, there, what] {
      if (there != nullptr && has(there)) what(there.data());
    };
  };
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setToolTipsVisible(true);
  QAction* change =
      menu->addAction(tr("&Change this plot..."), this, with_plot([this](RunPlot* it) { edit(it); }));
  change->setEnabled(plot->content().plot.id.empty());
  if (!change->isEnabled()) change->setToolTip(tr("A built-in plot cannot be changed: make a new one"));
  QAction* away =
      menu->addAction(tr("&Remove this plot"), this, with_plot([this](RunPlot* it) { remove(it); }));
  away->setEnabled(plots_.size() > 1);
  menu->addSeparator();
  QWidget* canvas = plot->plot()->canvas();
  add_note_entries(*menu, *plot, canvas->mapFromGlobal(event->globalPos()), this, [this] { changed(); });
  menu->addSeparator();
  menu->addAction(tr("&Save the picture..."), this, with_plot([this](RunPlot* it) { emit pictureAsked(it); }));
  menu->addAction(tr("&Copy the picture"), this, with_plot([this](RunPlot* it) {
                    show_now();
                    QGuiApplication::clipboard()->setPixmap(plot_picture(*it));
                  }));
  menu->addAction(tr("Save the &data..."), this, with_plot([this](RunPlot* it) { emit dataAsked(it); }));
  menu->addAction(tr("Copy &all the data"), this,
                  with_plot([this](RunPlot* it) { emit dataCopyAsked(it, false); }))
      ->setToolTip(tr("As a table for a spreadsheet, with every digit, from the start until now"));
  menu->addAction(tr("Copy the data that is s&hown"), this,
                  with_plot([this](RunPlot* it) { emit dataCopyAsked(it, true); }))
      ->setToolTip(tr("The same of the time that the plots show"));
  menu->addSeparator();
  menu->addActions(menu_->actions());
  menu->popup(event->globalPos());
}

void PlotPanel::connect_plot(RunPlot* plot) {
  connect(plot, &RunPlot::timeZoomAsked, this, [this, plot](double at, double factor) {
    if (!plot->over_time()) {
      plot->axes().zoom_x(at, factor);
      mark_zoomed(plot);
      return;
    }
    const QwtInterval now = time_range();
    set_time_zoom(plot, {at + (now.minValue() - at) * factor, at + (now.maxValue() - at) * factor});
  });
  connect(plot, &RunPlot::valueZoomAsked, this, [this, plot](double at, double factor) {
    plot->axes().zoom_values(at, factor);
    mark_zoomed(plot);
  });
  connect(plot, &RunPlot::panAsked, this, [this, plot](const QPointF& from, const QPointF& to) {
    plot->axes().pan_values(from.y(), to.y());
    if (!plot->over_time()) {
      plot->axes().pan_x(from.x(), to.x());
      mark_zoomed(plot);
      return;
    }
    const QwtInterval now = time_range();
    const double by = from.x() - to.x();
    set_time_zoom(plot, {now.minValue() + by, now.maxValue() + by});
  });
  connect(plot, &RunPlot::boxAsked, this, [this, plot](const QRectF& box) {
    const QwtInterval x(box.left(), box.right());
    plot->axes().zoom_to(plot->over_time() ? QwtInterval() : x, QwtInterval(box.top(), box.bottom()));
    if (plot->over_time()) set_time_zoom(plot, x);
    mark_zoomed(plot);
  });
  connect(plot, &RunPlot::resetAsked, this, [this, plot] {
    if (plot->over_time()) take_back_mark();
    reset_zoom();
  });
  connect(plot, &RunPlot::curvesChanged, this, &PlotPanel::schedule);
  connect(plot, &RunPlot::timeHovered, this, [this](const std::optional<double>& time) {
    for (RunPlot* each : plots_) each->set_cursor(time);
    schedule();
  });
  connect(plot, &RunPlot::timeClicked, this, &PlotPanel::set_mark);
  connect(plot, &RunPlot::scrubBegan, this, &PlotPanel::scrubBegan);
  connect(plot, &RunPlot::scrubbed, this, &PlotPanel::scrubbed);
  connect(plot, &RunPlot::scrubEnded, this, &PlotPanel::scrubEnded);
  connect(plot, &RunPlot::impactClicked, this, [this](double time) {
    before_mark_.reset();
    emit impactChosen(time);
  });
}

void PlotPanel::set_mark(double time, bool second) {
  before_mark_ = std::pair(mark_a_, mark_b_);
  (second ? mark_b_ : mark_a_) = time;
  schedule();
  emit marksChanged();
}

// The first click of a double click has set one.
void PlotPanel::take_back_mark() {
  if (!before_mark_) return;
  std::tie(mark_a_, mark_b_) = *std::exchange(before_mark_, std::nullopt);
  schedule();
  emit marksChanged();
}

// Moves to the next or the previous record of the first curve.
void PlotPanel::move_mark(int by, bool second) {
  const std::optional<double>& mark = second ? mark_b_ : mark_a_;
  if (!mark) return;
  for (const Curve& curve : curves()) {
    const Series<1>* series = runs_.front().recorder->series(curve);
    if (series == nullptr) continue;
    const SeriesPoint<1>* to = by > 0 ? series->after(*mark) : series->at(std::nextafter(*mark, -1.0));
    if (to != nullptr) set_mark(to->at, second);
    return;
  }
}

void PlotPanel::clear_marks() {
  mark_a_.reset();
  mark_b_.reset();
  schedule();
  emit marksChanged();
}

ReadingMarks PlotPanel::marks() const {
  const QwtInterval shown = time_range();
  return {mark_a_, mark_b_, shown.minValue(), shown.maxValue()};
}

std::vector<PlotContent> PlotPanel::contents() const {
  std::vector<PlotContent> all;
  for (const RunPlot* plot : plots_) all.push_back(plot->content());
  return all;
}

void PlotPanel::update_from(const std::vector<PlottedRun>& runs) {
  const std::vector<PlottedRun> before = std::exchange(runs_, runs);
  bool same = before.size() == runs_.size();
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const auto known = std::find_if(before.begin(), before.end(),
                                    [&](const PlottedRun& other) { return other.run() == runs_[i].run(); });
    runs_[i].shown = known == before.end() || known->shown || runs_.size() == 1;
    same = same && before[i].name == runs_[i].name && before[i].shown == runs_[i].shown;
  }
  if (!same) {
    legend_->show_runs(runs_, theme_);
    schedule();
  }
  schedule_news();
}

void PlotPanel::reset_zoom() {
  zoomed_.clear();
  time_zoom_.reset();
  for (RunPlot* plot : plots_) {
    plot->set_chip_visible(false);
    plot->axes().forget_values();
  }
  schedule();
}

void PlotPanel::set_time_zoom(RunPlot* plot, const QwtInterval& range) {
  // Zoomed in further, pixels would share one double; further out there is nothing to see.
  const double magnitude = std::max(std::abs(range.minValue()), std::abs(range.maxValue()));
  constexpr double kLongest = 1e9;  // s
  if (range.width() < 1e-12 * magnitude || magnitude > kLongest) return;
  time_zoom_ = range;
  mark_zoomed(plot);
}

void PlotPanel::mark_zoomed(RunPlot* plot) {
  if (std::find(zoomed_.begin(), zoomed_.end(), plot) == zoomed_.end()) zoomed_.push_back(plot);
  plot->set_chip_visible(true);
  schedule();
}

QwtInterval PlotPanel::time_range() const {
  if (time_zoom_) return *time_zoom_;
  const double reach = before_ ? before_->reach : 0.0;
  return {0.0, time_axis_end(std::max(runs_.front().recorder->time(), reach), duration_)};
}

void PlotPanel::schedule() {
  if (isVisible() && !timer_.isActive()) timer_.start();
}

// A frame after a pause is shown at once.
void PlotPanel::schedule_news() {
  if (!isVisible() || timer_.isActive()) return;
  const bool paused = !quiet_.isActive();
  quiet_.start();
  if (++waiting_ >= plots_.size() || paused || !(time_range() == shown_)) timer_.start();
}

void PlotPanel::refresh() {
  timer_.stop();
  waiting_ = 0;
  shown_ = time_range();
  for (RunPlot* plot : plots_) take_news(plot, shown_);
  align();
  for (RunPlot* plot : plots_) {
    plot->set_time_range(shown_);  // with the ticks that the aligned width has room for
    plot->replot();
  }
}

void PlotPanel::take_news(RunPlot* plot, const QwtInterval& range) {
  plot->set_time_range(range);
  // A histogram depends on the visible time.
  const bool hold = (time_zoom_ && plot->distribution() == nullptr) ||
                    std::find(zoomed_.begin(), zoomed_.end(), plot) != zoomed_.end();
  plot->update_from(runs_, hold);
  plot->set_marks(mark_a_, mark_b_);
  plot->set_playhead(playhead_);
}

void PlotPanel::set_duration(double seconds) {
  if (std::exchange(duration_, seconds) != seconds) schedule();
}

void PlotPanel::set_run_before(const std::optional<PaleRun>& run) {
  const bool same = run ? before_ && run->same_as(*before_) : !before_;
  if (same) return;
  before_ = run;
  for (RunPlot* plot : plots_) plot->set_run_before(before_, bodies_);
  schedule();
}

void PlotPanel::set_playhead(std::optional<double> time) {
  if (std::exchange(playhead_, time) != time) schedule();
}

// The labels' width grows in steps, so that the canvases do not shift with each new label.
void PlotPanel::align() {
  int extent = 0;
  for (const RunPlot* plot : plots_) extent = std::max(extent, plot->axes().label_extent());
  constexpr int kExtentStep = 8;  // px
  extent = (extent + kExtentStep - 1) / kExtentStep * kExtentStep;
  for (RunPlot* plot : plots_) plot->axes().set_label_extent(extent);
}

void PlotPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  schedule();
}

void PlotPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  schedule();
}

void PlotPanel::keyPressEvent(QKeyEvent* event) {
  const bool second = event->modifiers().testFlag(Qt::ShiftModifier);
  if (event->key() == Qt::Key_Home && event->modifiers() == Qt::ControlModifier) {
    reset_zoom();
  } else if (event->key() == Qt::Key_Right || event->key() == Qt::Key_Left) {
    move_mark(event->key() == Qt::Key_Right ? 1 : -1, second);
  } else if (event->key() == Qt::Key_Escape && (mark_a_ || mark_b_)) {
    clear_marks();
  } else {
    QWidget::keyPressEvent(event);
  }
}

}  // namespace carom
