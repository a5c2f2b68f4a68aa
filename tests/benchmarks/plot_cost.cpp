// Cost of a replot after ten thousand and after ten million recorded samples, in one run, alternating; the
// memory of the records; and whether a spike of one sample is still drawn.
#include <QApplication>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <qwt_plot.h>
#include <qwt_plot_curve.h>

#include "widgets/plot/plot_panel.h"
#include "widgets/plot/run_plot.h"
#include "widgets/theme/theme.h"

using namespace carom;

namespace {

constexpr double kSpike = 50.0;

struct Bench {
  explicit Bench(std::int64_t samples) : panel(light_theme()) {
    Plot drift;
    drift.id = "drift";
    std::vector<Plot> plots = default_plots();
    plots.back() = drift;  // three plots of curves
    panel.set_plots(plots, {});
    panel.resize(400, 700);
    panel.show();
    const auto curves = std::make_shared<const std::vector<Curve>>(panel.curves());
    constexpr std::int64_t kAtOnce = 100'000;
    for (std::int64_t i = 0; i < samples;) {
      Frame frame;
      frame.run = 1;
      Rows& rows = frame.rows.emplace_back();
      rows.curves = curves;
      for (const std::int64_t end = std::min(samples, i + kAtOnce); i < end; ++i) {
        frame.time = 10.0 * static_cast<double>(i) / static_cast<double>(samples);
        rows.times.push_back(frame.time);
        for (std::size_t k = 0; k < curves->size(); ++k) {
          const double wave = std::sin((3.0 + static_cast<double>(k)) * frame.time);
          rows.values.push_back(i == samples / 3 ? kSpike : wave + 0.1 * std::sin(1e4 * frame.time));
        }
      }
      recorder->add(frame);
    }
    for (const Curve& curve : *curves) memory += static_cast<double>(recorder->series(curve)->memory());
  }

  // ms
  double replot() {
    const auto begin = std::chrono::steady_clock::now();
    panel.update_from({{recorder, "run"}});
    panel.show_now();
    QApplication::processEvents();
    return 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }

  [[nodiscard]] int spikes() const {
    int found = 0;
    for (const RunPlot* plot : panel.plots()) {
      for (const QwtPlotItem* item : plot->plot()->itemList(QwtPlotItem::Rtti_PlotCurve)) {
        const auto* curve = static_cast<const QwtPlotCurve*>(item);
        for (std::size_t i = 0; i < curve->dataSize(); ++i) {
          if (curve->sample(static_cast<int>(i)).y() == kSpike) {
            ++found;
            break;
          }
        }
      }
    }
    return found;
  }

  PlotPanel panel;
  std::shared_ptr<Recorder> recorder = std::make_shared<Recorder>();
  double memory = 0.0;
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication application(argc, argv);
  Bench few(10'000);
  Bench many(10'000'000);
  std::vector<double> of_few;
  std::vector<double> of_many;
  for (int i = 0; i < 60; ++i) {
    of_few.push_back(few.replot());
    of_many.push_back(many.replot());
  }
  fmt::print("{:>12} {:>16} {:>16} {:>14}\n", "samples", "replot of 3 / ms", "memory / MB", "spikes drawn");
  for (const auto& [bench, times, samples] :
       {std::tuple(&few, &of_few, 1e4), std::tuple(&many, &of_many, 1e7)}) {
    fmt::print("{:>12.0e} {:>16.2f} {:>16.2f} {:>10} of {}\n", samples, median(*times), bench->memory * 1e-6,
               bench->spikes(), bench->panel.curves().size());
  }
  fmt::print("ratio of the times: {:.2f}\n", median(of_many) / median(of_few));
}
