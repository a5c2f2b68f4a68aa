#include "widgets/compare/compare_table.h"

#include <QPainter>
#include <QPixmap>
#include <cmath>

#include "widgets/base/method_names.h"
#include "widgets/base/plotted_run.h"
#include "widgets/base/rounding.h"

namespace carom {

double reach_of(const Frame& frame) {
  return frame.state.size() > 0 ? frame.state.q.topRows<2>().cwiseAbs().maxCoeff() : 0.0;
}

namespace {

constexpr int kAngle = 3;
constexpr int kImpactTimes = 4;
constexpr int kDrift = 5;
constexpr int kCost = 6;

class CompareModel : public FigureModel {
 public:
  using FigureModel::FigureModel;

  void set(const std::vector<std::shared_ptr<const Frame>>& frames) {
    frames_ = frames;
    std::vector<Method> methods;
    for (const auto& frame : frames_) methods.push_back(frame->method);
    names_ = names_of(methods);
    rows_changed(static_cast<int>(frames_.size()));
  }
  void set_theme(const Theme& theme) {
    theme_ = theme;
    rows_changed(static_cast<int>(frames_.size()));
  }

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override {
    if (role == Qt::DisplayRole && knows(index.row())) {
      if (const QString text = rounding(index.row(), index.column()); !text.isEmpty()) return text;
    }
    if (role != Qt::DecorationRole || index.column() != 0) return FigureModel::data(index, role);
    constexpr QSize kSample(22, 12);  // px
    constexpr int kDots = 2;
    QPixmap sample(kSample * kDots);
    sample.setDevicePixelRatio(kDots);
    sample.fill(Qt::transparent);
    QPainter painter(&sample);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(pen_of_run(static_cast<std::size_t>(index.row()), theme_, 2.2));
    painter.drawLine(QPointF(0.0, 6.0), QPointF(kSample.width(), 6.0));
    return sample;
  }

  [[nodiscard]] bool is_sum(int) const override { return false; }
  [[nodiscard]] QString tip(int row, int column) const override {
    const Frame& frame = *frames_[static_cast<std::size_t>(row)];
    if (column == 0) return description_of(frame.method);
    const bool of_itself = frame.error && frame.error->of_itself;
    if (of_itself && column < kDrift) return tr("This run uses the method of the reference");
    if (column == 1) return tr("The largest distance of a body from where it is in the reference, now");
    if (column == 2) {
      return tr("The same, at its largest so far");
    }
    if (column == kAngle) {
      return tr("The largest error of an angle in rad, now, times how far the body reaches from its centre");
    }
    if (column == kImpactTimes) {
      if (!frame.error) return {};
      return tr("The most by which an impact came too early or too late: %1 impacts found their partner, %2 "
                "did not")
          .arg(frame.error->matched)
          .arg(frame.error->unmatched);
    }
    if (column == kDrift) return tr("Energy that the method itself gained or lost");
    return tr("Seconds of computing for a second of the scene; %1 steps so far").arg(frame.steps);
  }

  [[nodiscard]] Cell cell(int row, int column) const override {
    const Frame& frame = *frames_[static_cast<std::size_t>(row)];
    const auto known = [](double value) { return std::isnan(value) ? Cell() : Cell(value); };
    if (column == 0) return names_[static_cast<std::size_t>(row)];
    if (column == kDrift) return known(frame.ledger.numerical_drift(frame.totals.energy()));
    if (column == kCost) return frame.time > 0.0 ? Cell(frame.wall_time / frame.time) : Cell();
    if (!frame.error) return {};
    if (frame.error->of_itself) return column == 1 ? Cell(tr("reference")) : Cell();
    if (column == 1) return known(frame.error->position);
    if (column == 2) return known(frame.error->largest_position);
    if (column == kAngle) return known(frame.error->angle);
    return frame.error->matched > 0 ? Cell(frame.error->impact_time) : Cell();
  }

 private:
  // What stands in place of a figure that is rounding.
  [[nodiscard]] QString rounding(int row, int column) const {
    const Cell content = cell(row, column);
    const auto* value = std::get_if<double>(&content);
    if (value == nullptr || *value == 0.0 || column == kCost) return {};
    const Frame& frame = *frames_[static_cast<std::size_t>(row)];
    if (column == kImpactTimes) return text_of_rounding(*value, frame.time);
    return text_of_rounding(*value, column == kDrift ? frame.scales.energy : reach_of(frame));
  }

  std::vector<std::shared_ptr<const Frame>> frames_;
  std::vector<QString> names_;
  Theme theme_;
};

}  // namespace

CompareTable::CompareTable(const Theme& theme, QWidget* parent)
    : FigureTable(new CompareModel({{"method", 240, true},
                                    {"error / m", 78, false, 3},
                                    {"largest / m", 84, false, 3},
                                    {"angle / m", 78, false, 3},
                                    {"impacts / s", 84, false, 3},
                                    {"drift / J", 84, false, 3},
                                    {"CPU, s/s", 72, false, 2}},
                                   nullptr),
                  tr("Compared methods"), parent) {
  setSelectionMode(QAbstractItemView::SingleSelection);
  set_theme(theme);
}

void CompareTable::set_theme(const Theme& theme) { static_cast<CompareModel*>(model())->set_theme(theme); }

void CompareTable::update_from(const std::vector<std::shared_ptr<const Frame>>& frames) {
  static_cast<CompareModel*>(model())->set(frames);
}

}  // namespace carom
