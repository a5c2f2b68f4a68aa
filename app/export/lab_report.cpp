#include "app/export/lab_report.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <set>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/model/needs.h"
#include "physics/preset/preset.h"
#include "physics/record/frame.h"
#include "physics/record/jump_moment.h"
#include "widgets/base/figure_table.h"
#include "widgets/base/method_names.h"
#include "widgets/base/number_text.h"
#include "widgets/plot/plot_export.h"
#include "widgets/plot/run_plot.h"
#include "widgets/print/print_blocks.h"
#include "widgets/run/before_after.h"

namespace carom {
namespace {

constexpr int kMostRows = 24;      // of a table
constexpr double kGap = 18.0;      // px between two pictures
constexpr double kCaption = 20.0;  // px
constexpr double kPlot = 210.0;    // px, height of a plot

QString tr(const char* text) { return QCoreApplication::translate("LabReport", text); }

// Distance in s of the moments just before and after an impact: a round part of a step.
double near_by(const Method& method) { return std::pow(10.0, std::floor(std::log10(method.step) + 1e-9)); }

QString step_text(const Method& m) {
  const IntegratorChoice& integrator = choice_of(kIntegrators, m.integrator);
  const QString step = short_figure(1e3 * m.step) + " ms";
  if (integrator.adaptive) return tr("tolerance %1 m and m/s a step").arg(short_figure(m.tolerance));
  return integrator.order == 0 ? tr("none; results every %1").arg(step) : "h = " + step;
}

template <class Choice>
QString choice_text(const Choice& choice) {
  return text_of(choice.label) + ": " + text_of(choice.tip);
}

// "RK4, impacts at their own time, ...": the complete method in a line.
QString method_line(const Method& m) {
  return QStringList{text_of(choice_of(kIntegrators, m.integrator).label),
                     text_of(choice_of(kImpacts, m.impacts).label),
                     text_of(choice_of(kContacts, m.contacts).label), step_text(m)}
      .join(", ");
}

QString name_of(const RunEdit& edit, const LabReport& report) {
  if (const auto* method = std::get_if<Method>(&edit.what)) return method_line(*method);
  if (edit.id == 0) return tr("%1 added").arg(QString::fromStdString(added_body(edit).name));
  const auto known = report.edit_names.find(edit.id);
  return known != report.edit_names.end() ? known->second : tr("change of the scene");
}

// Builds the report's blocks, in order.
class Writer {
 public:
  explicit Writer(const LabReport& report) : report_(report) {}

  std::vector<PrintBlock> write(const ReportMoments& moments) {
    head();
    if (!report_.questions.isEmpty()) question(report_.questions.front());
    scenes(moments.scenes);
    plots();
    before_and_after_table(moments.first_impact.get());
    ledger();
    method();
    for (const QString& text : report_.questions.mid(1)) question(text);
    return std::move(blocks_);
  }

 private:
  void add(PrintBlock block, std::optional<double> gap = {}) {
    if (gap) block.gap = *gap;
    blocks_.push_back(std::move(block));
  }

  void head() {
    const Theme& theme = light_theme();
    add(print_text(tr("Lab report"), print_font(12), theme.muted));
    add(print_text(report_.title, print_font(26, true), theme.text), 2.0);
    if (report_.until_shown)
      add(print_text(tr("Up to the moment t = %1 s of a run of %2 s")
                         .arg(short_figure(report_.ends.front().time, 6), short_figure(report_.recorded, 6)),
                     print_font(12), theme.muted),
          2.0);
    add(print_fields({{tr("Name"), report_.name, 0.48},
                      {tr("Class"), report_.form, 0.22},
                      {tr("Date"), report_.date, 0.30}}));
  }

  void question(const QString& text) {
    add(print_heading(text));
    constexpr int kLeastLines = 4;
    add(print_ruled(kLeastLines));
  }

  void scenes(const std::vector<std::vector<Frame>>& moments) {
    if (moments.empty()) return;
    add(print_heading(tr("The run")));
    const bool alone = moments.size() == 1;
    const int columns = alone ? 1 : 2;
    const double width = (PrintPages::kTextWidth - kGap * (columns - 1)) / columns;
    const QSizeF window = report_.look.camera.viewport;
    const double height = width * std::clamp(window.height() / window.width(), 0.3, 0.75);
    SceneLook look = report_.look;
    look.theme = light_theme();
    look.options.text_size = 9.0;
    look.options.line_scale = 0.8;
    look = on_viewport(look, {width, height});
    std::vector<PrintBlock> row;
    for (std::size_t i = 0; i < moments.size(); ++i) {
      row.push_back(scene(moments[i], look));
      if (static_cast<int>(row.size()) < columns && i + 1 < moments.size()) continue;
      add(print_row(std::move(row), columns, kGap), i < 2 ? 8.0 : 12.0);
      row.clear();
    }
  }

  [[nodiscard]] PrintBlock scene(const std::vector<Frame>& moment, const SceneLook& look) const {
    PrintBlock block;
    block.height = look.camera.viewport.height() + kCaption;
    const QString time = QString("t = %1 s").arg(short_figure(moment.front().time, 6));
    const QString what = moment_text(moment.front().time, report_);
    block.paint = [moment, look, time, what](QPainter& painter, const QRectF& where) {
      const Theme& theme = light_theme();
      const QRectF frame(where.topLeft(), look.camera.viewport);
      painter.save();
      painter.setClipRect(frame);
      painter.translate(frame.topLeft());
      SceneLook own = look;
      paint_scene(painter, moment.front(), own, std::span(moment).subspan(1));
      painter.restore();
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(theme.border, 0.75));
      painter.drawRect(frame);
      const double base = where.bottom() - 4.0;
      painter.setFont(print_font(11, true));
      painter.setPen(theme.text);
      painter.drawText(QPointF(where.left(), base), time);
      const double end = where.left() + QFontMetricsF(painter.font()).horizontalAdvance(time);
      painter.setFont(print_font(11));
      painter.setPen(theme.muted);
      painter.drawText(QPointF(end + 10.0, base), what);
    };
    return block;
  }

  void plots() {
    if (report_.plots.empty()) return;
    add(print_heading(tr("Plots")));
    for (RunPlot* plot : report_.plots) {
      PrintBlock block;
      block.height = kPlot;
      block.paint = [plot](QPainter& painter, const QRectF& where) { paint_plot(*plot, painter, where); };
      add(std::move(block), plot == report_.plots.front() ? 8.0 : 16.0);
    }
  }

  // Of the first impact, which the scenes show too.
  void before_and_after_table(const JumpMoment* first_impact) {
    if (report_.bodies == nullptr) return;
    const auto table = [this](const QString& heading, const QString& moments, const FigureModel& figures) {
      add(print_heading(heading));
      add(print_text(moments, print_font(12), light_theme().muted), 4.0);
      blocks_.back().with_next = true;
      add(print_table(figures, kMostRows));
    };
    if (first_impact == nullptr)
      return table(tr("Before and after"),
                   tr("Before: t = 0. After: t = %1 s.").arg(short_figure(report_.ends.front().time, 6)),
                   *report_.bodies);
    BeforeAfterModel figures(nullptr);
    figures.set(carom::before_and_after(*first_impact));
    table(tr("Before and after the first impact"),
          tr("t = %1 s. Theory: the closed law of the impact. Error: as a share of its largest speed.")
              .arg(short_figure(first_impact->time(), 6)),
          figures);
  }

  void ledger() {
    if (report_.ledger == nullptr) return;
    add(print_heading(tr("Where energy and momentum went")));
    add(print_table(*report_.ledger, kMostRows));
    const double drift = report_.ends.front().ledger.numerical_drift(report_.ends.front().totals.energy());
    const double energy = report_.ends.front().scales.energy;
    QString text = tr("The numerical drift is what the method itself gained or lost: %1 J").arg(figure(drift));
    if (energy > 0.0)
      text += tr(", which is %1 of the largest energy of the run, %2 J")
                  .arg(figure(std::abs(drift) / energy, 2), figure(energy));
    add(print_text(text + ".", print_font(12), light_theme().muted), 8.0);
  }

  void method() {
    const RunSetup& start = report_.runs.front();
    const Method& m = start.method;
    add(print_heading(tr("The method")));
    const auto entry = [&](const QString& name, const QString& text) {
      blocks_.back().with_next = true;  // keeps it together
      add(print_entry(name, text));
    };
    if (!report_.observe.isEmpty()) entry(tr("To be seen"), report_.observe);
    entry(tr("Integrator"), choice_text(choice_of(kIntegrators, m.integrator)));
    entry(tr("Step"), step_text(m));
    entry(tr("Impacts"), choice_text(choice_of(kImpacts, m.impacts)));
    entry(tr("Contacts"), choice_text(choice_of(kContacts, m.contacts)));
    const NeedsText needs = text_of_needs(start);
    const auto joined = [](const std::vector<std::string>& parts) {
      QStringList all;
      for (const std::string& part : parts) all << QString::fromStdString(part);
      return all.isEmpty() ? tr("nothing") : all.join(", ");
    };
    entry(tr("Modelled"), joined(needs.modelled));
    entry(tr("Not needed"), joined(needs.not_needed));
    changes();
    entry(tr("The run"), tr("%1 s in %2 steps with %3 impacts; %4 evaluations of a body's acceleration")
                             .arg(short_figure(report_.ends.front().time, 6))
                             .arg(report_.ends.front().steps)
                             .arg(report_.ends.front().impact_count)
                             .arg(report_.ends.front().evaluations));
    compared();
    if (report_.ends.front().status != "ok")
      entry(tr("Notices"), QString::fromStdString(report_.ends.front().status));
  }

  // The other methods, as outlines beside the scene's own.
  void compared() {
    for (std::size_t i = 1; i < report_.runs.size(); ++i) {
      const Frame& end = report_.ends[i];
      blocks_.back().with_next = true;
      add(print_entry(
          i == 1 ? tr("Compared with") : QString(),
          tr("%1: numerical drift %2 J")
              .arg(method_line(end.method), figure(end.ledger.numerical_drift(end.totals.energy())))));
    }
  }

  static NeedsText text_of_needs(const RunSetup& setup) {
    return text_of(needs_of(setup.scene), setup.scene, setup.method.contacts);
  }

  void changes() {
    const QStringList lines = edit_lines(report_);
    for (qsizetype i = 0; i < lines.size(); ++i) {
      blocks_.back().with_next = true;
      add(print_entry(i == 0 ? tr("Changed") : QString(), lines[i]));
    }
  }

  const LabReport& report_;
  std::vector<PrintBlock> blocks_;
};

}  // namespace

std::vector<double> report_times(const Method& method, std::optional<double> first_impact, double end) {
  std::vector<double> times{0.0};
  if (first_impact && method.impacts == ImpactsId::kLocated) {
    const double near = near_by(method);
    const double before = std::ceil(*first_impact / near - 1e-6) - 1.0;
    times.insert(times.end(), {before * near, (std::floor(*first_impact / near + 1e-6) + 1.0) * near});
  } else if (first_impact) {
    times.insert(times.end(), {*first_impact - method.step, *first_impact});
  } else {
    for (const int third : {1, 2}) times.push_back(short_figure(third * end / 3.0, 3).toDouble());
  }
  times.push_back(end);
  std::erase_if(times, [end](double t) { return t < 0.0 || t > end; });
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

QString moment_text(double time, const LabReport& report) {
  if (time == 0.0) return tr("start");
  if (report.first_impact) {
    const double off = time - *report.first_impact;
    const Method& method = report.runs.front().method;
    const double near = 1.001 * (method.impacts == ImpactsId::kLocated ? near_by(method) : method.step);
    if (off < 0.0 && off >= -near) return tr("just before the first impact");
    if (off >= 0.0 && off <= near) return tr("just after the first impact");
  }
  if (time != report.ends.front().time) return {};
  return report.until_shown ? tr("shown moment") : tr("end");
}

QStringList edit_lines(const LabReport& report) {
  constexpr qsizetype kMostChanges = 12;
  QStringList lines;
  std::set<std::pair<std::uint64_t, std::size_t>> told;  // parts of one edit are told once, by their kind
  for (const RunEdit& edit : report.runs.front().edits) {
    if (edit.time > report.ends.front().time ||
        (edit.id != 0 && !told.emplace(edit.id, edit.what.index()).second))
      continue;
    lines << tr("from t = %1 s: %2").arg(short_figure(edit.time, 6), name_of(edit, report));
  }
  const qsizetype more = lines.size() - kMostChanges;
  if (more > 0) lines = lines.first(kMostChanges) << tr("and %1 more").arg(more);
  return lines;
}

std::optional<ReportMoments> report_moments(const LabReport& report,
                                            const std::function<bool(double)>& progress) {
  ReportMoments moments;
  const auto keep = [&](std::span<const Frame> runs) {
    moments.scenes.emplace_back(runs.begin(), runs.end());
    return true;
  };
  const double end = report.times.empty() ? 1.0 : std::max(report.times.back(), 1e-12);
  const auto go_on = [&](double time) { return progress(std::min(1.0, time / end)); };
  if (!visit_moments(report.runs, report.times, kImpactShown, keep, go_on)) return std::nullopt;
  bool cancelled = false;
  const auto not_cancelled = [&] { return !(cancelled = !progress(1.0)); };
  if (report.first_impact)
    moments.first_impact = first_jump_moment(report.runs.front(), report.ends.front().time, not_cancelled);
  if (cancelled) return std::nullopt;
  return moments;
}

PrintPages report_pages(const LabReport& report, const ReportMoments& moments) {
  return PrintPages(Writer(report).write(moments), "Carom · " + report.title);
}

}  // namespace carom
