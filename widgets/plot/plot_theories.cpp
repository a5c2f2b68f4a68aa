#include "widgets/plot/plot_theories.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <qwt_plot.h>

#include "widgets/plot/legend_button.h"
#include "widgets/plot/theory_curve.h"

namespace carom {

PlotTheories::PlotTheories(const PlotContent& content, QwtPlot* plot, QWidget* parent) {
  QStringList formulas;
  std::size_t of_first = 0;
  for (const PlotLine& line : content.lines) {
    const Theory& theory = line.theory.empty() ? line.first_theory : line.theory;
    if (theory.empty()) continue;
    if (line.theory.empty()) ++of_first;
    auto curve =
        std::make_unique<TheoryCurve>(theory.formula, content.plot.x.has_value(), content.plot.logarithmic);
    constexpr double kBelow = 15.0;  // curves have 20
    curve->setZ(kBelow);
    curve->attach(plot);
    curves_.emplace_back(*line.curve, std::move(curve));
    const QString formula = QString::fromStdString(theory.formula.text());
    formulas << (line.label.isEmpty() ? formula : line.label + ": " + formula);
  }
  if (curves_.empty()) return;
  const QString text = of_first == 0 ? QCoreApplication::translate("PlotTheories", "theory")
                       : of_first == curves_.size()
                           ? QCoreApplication::translate("PlotTheories", "theory of the first scene")
                           : QCoreApplication::translate("PlotTheories", "theory, partly of the first scene");
  button_ = new LegendButton(text, formulas.join('\n'), parent);
}

PlotTheories::~PlotTheories() = default;

void PlotTheories::set_shown(bool shown) {
  shown_ = shown;
  for (auto& [curve, item] : curves_) item->setVisible(shown);
}

void PlotTheories::set_theme(const Theme& theme) {
  constexpr double kWidth = 1.2;  // px
  pen_ = QPen(theme.text, kWidth, Qt::CustomDashLine);
  pen_.setDashPattern({5.0, 4.0});
  for (auto& [curve, item] : curves_) item->set_pen(pen_);
  if (button_ != nullptr) button_->set_look(pen_, theme.muted);
}

void PlotTheories::update_from(const Recorder& recorder, const QwtInterval& time) {
  for (auto& [curve, item] : curves_) {
    const Series<2>* path = item->needs_path() ? recorder.path(curve) : nullptr;
    if (path != nullptr) item->take(*path, time);
  }
}

QwtInterval PlotTheories::spread(const QwtInterval& x, const QwtInterval& measured, bool begun) const {
  QwtInterval all = measured;
  if (!shown_ || !x.isValid()) return all;
  const double low = measured.minValue() - measured.width();
  const double high = measured.maxValue() + measured.width();
  for (const auto& [curve, item] : curves_) {
    const QwtInterval theory = begun ? item->spread(x) : item->usual_spread(x);
    if (!theory.isValid()) continue;
    if (!measured.isValid() || !begun) {
      all |= theory;
      continue;
    }
    all |= std::clamp(theory.minValue(), low, high);
    all |= std::clamp(theory.maxValue(), low, high);
  }
  return all;
}

std::vector<std::pair<QString, QPen>> PlotTheories::legend() const {
  if (button_ == nullptr || !shown_) return {};
  return {{button_->text(), pen_}};
}

}  // namespace carom
