#include "widgets/plot/reading_table.h"

#include <algorithm>
#include <limits>

namespace carom {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// The readings of one curve.
struct Row {
  QString name;
  double at_a = kNone;
  double at_b = kNone;
  double slope = kNone;
  double area = kNone;
  double mean = kNone;
  double least = kNone;
  double largest = kNone;
  bool exact = true;
};

Row read(const Series<1>& series, const ReadingMarks& marks, const ShownUnit& unit) {
  Row row;
  const auto value_at = [&](const std::optional<double>& time) {
    const SeriesPoint<1>* point = time ? series.at(*time) : nullptr;
    return point == nullptr ? kNone : unit.of(point->value[0]);
  };
  row.at_a = value_at(marks.a);
  row.at_b = value_at(marks.b);
  double from = marks.from;
  double to = marks.to;
  if (marks.a && marks.b) {
    from = std::min(*marks.a, *marks.b);
    to = std::max(*marks.a, *marks.b);
    if (to > from) row.slope = (row.at_b - row.at_a) / (*marks.b - *marks.a);
  }
  row.exact = from >= series.whole_since();
  std::vector<SeriesPoint<1>> points;
  series.read(from, to, points);
  const SeriesPoint<1>* before = nullptr;
  double area = 0.0;
  for (const SeriesPoint<1>& p : points) {
    if (p.at < from || p.at > to) continue;
    row.least = std::fmin(row.least, unit.of(p.value[0]));
    row.largest = std::fmax(row.largest, unit.of(p.value[0]));
    if (before != nullptr) area += 0.5 * (p.at - before->at) * (p.value[0] + before->value[0]);
    before = &p;
    from = std::min(from, p.at);
  }
  if (before == nullptr) return row;
  const auto first = std::find_if(points.begin(), points.end(), [&](const auto& p) { return p.at >= from; });
  const double length = before->at - first->at;
  if (length > 0.0) {
    row.area = unit.of(area);
    row.mean = row.area / length;
  }
  return row;
}

class ReadingModel : public FigureModel {
 public:
  using FigureModel::FigureModel;

  void set(std::vector<Row> rows) {
    read_ = std::move(rows);
    rows_changed(static_cast<int>(read_.size()));
  }

  [[nodiscard]] bool is_sum(int) const override { return false; }
  [[nodiscard]] bool is_idle(int row, int /*column*/) const override { return !at(row).exact; }
  [[nodiscard]] QString tip(int row, int /*column*/) const override {
    return at(row).exact ? at(row).name : tr("%1: only extremes are kept of this part").arg(at(row).name);
  }

  [[nodiscard]] Cell cell(int row, int column) const override {
    const Row& r = at(row);
    const auto known = [](double value) { return std::isnan(value) ? Cell() : Cell(value); };
    switch (column) {
      case 0:
        return r.name;
      case 1:
        return known(r.at_a);
      case 2:
        return known(r.at_b);
      case 3:
        return known(r.at_b - r.at_a);
      case 4:
        return known(r.slope);
      case 5:
        return known(r.area);
      case 6:
        return known(r.mean);
      case 7:
        return known(r.least);
      default:
        return known(r.largest);
    }
  }

 private:
  [[nodiscard]] const Row& at(int row) const { return read_[static_cast<std::size_t>(row)]; }

  std::vector<Row> read_;
};

}  // namespace

ReadingTable::ReadingTable(QWidget* parent)
    : FigureTable(new ReadingModel({{"curve", 144, true},
                                    {"at A", 67, false, 4},
                                    {"at B", 67, false, 4},
                                    {"B − A", 67, false, 4},
                                    {"slope / s", 67, false, 3},
                                    {"area · s", 67, false, 3},
                                    {"mean", 67, false, 3},
                                    {"least", 67, false, 3},
                                    {"largest", 67, false, 3}},
                                   nullptr),
                  tr("Reading"), parent) {
  // Curves of several methods differ in the end of their names.
  setTextElideMode(Qt::ElideMiddle);
}

void ReadingTable::update_from(const std::vector<PlottedRun>& runs, const std::vector<PlotContent>& plots,
                               const ReadingMarks& marks) {
  std::vector<Row> rows;
  Row time;
  time.name = tr("time / s");
  time.at_a = marks.a.value_or(kNone);
  time.at_b = marks.b.value_or(kNone);
  rows.push_back(time);
  for (const PlotContent& content : plots) {
    for (const PlotLine& line : content.lines) {
      const QString name =
          line.unit.behind(line.label.isEmpty() ? content.title : content.title + ", " + line.label);
      for (const PlottedRun& run : runs) {
        const Series<1>* series = line.curve && run.shown ? run.recorder->series(*line.curve) : nullptr;
        if (series == nullptr) continue;
        Row row = read(*series, marks, line.unit);
        row.name = runs.size() > 1 ? run.name + ": " + name : name;
        rows.push_back(row);
      }
    }
  }
  static_cast<ReadingModel*>(model())->set(std::move(rows));
}

}  // namespace carom
