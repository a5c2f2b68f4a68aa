#include "widgets/run/impacts_table.h"

#include <QHeaderView>
#include <algorithm>
#include <cstddef>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace carom {
namespace {

enum Column { kNumber, kTime, kBodies, kClosing, kNormal, kTangential, kLost };

class ImpactsModel : public FigureModel {
 public:
  using FigureModel::FigureModel;

  void set_filter(const ImpactFilter& filter) {
    filter_ = filter;
    stale_ = true;
  }

  void set(const Frame& frame, const Recorder& recorder) {
    const Ring<ImpactRecord>& all = recorder.impacts();
    // A run that went back may have as many impacts as before.
    const Seen seen{frame.run,
                    frame.impact_count,
                    all.size(),
                    frame.playing,
                    all.size() > 0 ? all.back().time : 0.0,
                    all.size() > 0 ? all.back().normal_impulse : 0.0};
    if (!std::exchange(stale_, false) && seen == seen_) return;
    seen_ = seen;
    bodies_ = frame.bodies;
    const std::size_t most = frame.playing ? ImpactsTable::kMostWhilePlaying : all.size();
    impacts_.clear();
    for (std::size_t i = 0; i < all.size() && impacts_.size() < most; ++i) {
      const NumberedImpact impact{all[all.size() - 1 - i], frame.impact_count - static_cast<std::int64_t>(i)};
      if (filter_.keeps(impact, *bodies_)) impacts_.push_back(impact);
    }
    put_in_order();
    rows_changed(static_cast<int>(impacts_.size()));
  }

  // Those after the shown moment are pale.
  void mark(double shown) {
    if (std::exchange(shown_, shown) != shown) rows_changed(static_cast<int>(impacts_.size()));
  }

  void sort(int column, Qt::SortOrder order) override {
    column_ = column;
    order_ = order;
    put_in_order();
    rows_changed(static_cast<int>(impacts_.size()));
  }

  [[nodiscard]] double time(int row) const { return at(row).record.time; }  // s

  [[nodiscard]] bool is_sum(int) const override { return false; }
  [[nodiscard]] bool is_idle(int row, int) const override { return time(row) > shown_; }

  [[nodiscard]] Cell cell(int row, int column) const override {
    const NumberedImpact& impact = at(row);
    if (column == kNumber) return QString::number(impact.number);
    if (column == kBodies) return QString::fromStdString(name(impact.record.a) + " – " + name(impact.record.b));
    return figure_of(impact, column);
  }

 private:
  // By which news are known.
  struct Seen {
    std::uint64_t run = 0;
    std::int64_t count = -1;
    std::size_t kept = 0;
    bool playing = false;
    double last_time = 0.0;     // s
    double last_impulse = 0.0;  // N s

    bool operator==(const Seen&) const = default;
  };

  [[nodiscard]] const NumberedImpact& at(int row) const { return impacts_[static_cast<std::size_t>(row)]; }
  [[nodiscard]] const std::string& name(int body) const {
    return (*bodies_)[static_cast<std::size_t>(body)].name;
  }

  static double figure_of(const NumberedImpact& impact, int column) {
    switch (column) {
      case kNumber:
        return static_cast<double>(impact.number);
      case kTime:
        return impact.record.time;
      case kClosing:
        return impact.record.closing_speed;
      case kNormal:
        return impact.record.normal_impulse;
      case kTangential:
        return impact.record.tangential_impulse;
      default:
        return lost_energy(impact.record);
    }
  }

  // Equal ones stay the newest first.
  void put_in_order() {
    const auto less = [this](const NumberedImpact& a, const NumberedImpact& b) {
      if (column_ != kBodies) return figure_of(a, column_) < figure_of(b, column_);
      return std::tie(name(a.record.a), name(a.record.b)) < std::tie(name(b.record.a), name(b.record.b));
    };
    const auto newer = [](const NumberedImpact& a, const NumberedImpact& b) { return a.number > b.number; };
    const bool up = order_ == Qt::AscendingOrder;
    std::sort(impacts_.begin(), impacts_.end(), [&](const NumberedImpact& a, const NumberedImpact& b) {
      const bool before = up ? less(a, b) : less(b, a);
      const bool after = up ? less(b, a) : less(a, b);
      return before == after ? newer(a, b) : before;
    });
  }

  ImpactFilter filter_;
  bool stale_ = true;
  int column_ = kNumber;
  Qt::SortOrder order_ = Qt::DescendingOrder;
  double shown_ = 0.0;  // s
  Seen seen_;
  std::shared_ptr<const std::vector<Body>> bodies_;
  std::vector<NumberedImpact> impacts_;  // in their order
};

}  // namespace

ImpactsTable::ImpactsTable(QWidget* parent)
    : FigureTable(new ImpactsModel({{"#", 62},
                                    {"t / s", 78, false, 6},
                                    {"bodies", 140, true},
                                    {"closing / m/s", 92},
                                    {"jₙ / N·s", 78},
                                    {"jₜ / N·s", 78},
                                    {"lost / J", 82}},
                                   nullptr),
                  tr("Impacts"), parent) {
  setToolTip(tr("A click on an impact goes to its moment; a click on a head sorts"));
  horizontalHeader()->setSortIndicator(kNumber, Qt::DescendingOrder);
  setSortingEnabled(true);
  connect(this, &QTableView::clicked, this, [this](const QModelIndex& index) {
    emit impactChosen(static_cast<ImpactsModel*>(model())->time(index.row()));
  });
}

void ImpactsTable::set_filter(const ImpactFilter& filter) {
  static_cast<ImpactsModel*>(model())->set_filter(filter);
}

void ImpactsTable::update_from(const Frame& newest, double shown, const Recorder& recorder) {
  static_cast<ImpactsModel*>(model())->set(newest, recorder);
  static_cast<ImpactsModel*>(model())->mark(shown);
}

void ImpactsTable::show_impact(double time) {
  const auto* impacts = static_cast<const ImpactsModel*>(model());
  for (int row = 0; row < impacts->rowCount(); ++row) {
    if (impacts->time(row) != time) continue;
    setCurrentIndex(impacts->index(row, 0));
    return;
  }
}

}  // namespace carom
