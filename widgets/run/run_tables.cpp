#include "widgets/run/run_tables.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

namespace carom {
namespace {

QString text_of(const std::string& text) { return QString::fromStdString(text); }

class ImpactsModel : public FigureModel {
 public:
  using FigureModel::FigureModel;

  void set(const Frame& frame, const Recorder& recorder) {
    const Ring<ImpactRecord>& all = recorder.impacts();
    const std::size_t count = std::min<std::size_t>(all.size(), ImpactsTable::kMostRows);
    // A run that went back may have as many impacts as before.
    const bool same_newest = count > 0 && !impacts_.empty() && impacts_.front().time == all.back().time &&
                             impacts_.front().normal_impulse == all.back().normal_impulse;
    if (frame.run == run_ && frame.impact_count == impact_count_ && count == impacts_.size() &&
        (count == 0 || same_newest))
      return;
    run_ = frame.run;
    impact_count_ = frame.impact_count;
    bodies_ = frame.bodies;
    impacts_.clear();
    for (std::size_t i = 0; i < count; ++i) impacts_.push_back(all[all.size() - 1 - i]);
    rows_changed(static_cast<int>(count));
  }

  // Those after the shown moment are pale.
  void mark(const Frame& shown) {
    if (std::exchange(shown_, shown.time) != shown.time) rows_changed(static_cast<int>(impacts_.size()));
  }

  [[nodiscard]] double time(int row) const { return impacts_[static_cast<std::size_t>(row)].time; }  // s

  [[nodiscard]] bool is_sum(int) const override { return false; }
  [[nodiscard]] bool is_idle(int row, int) const override { return time(row) > shown_; }

  [[nodiscard]] Cell cell(int row, int column) const override {
    const ImpactRecord& impact = impacts_[static_cast<std::size_t>(row)];
    switch (column) {
      case 0:
        return QString::number(impact_count_ - row);
      case 1:
        return impact.time;
      case 2:
        return name(impact.a) + " – " + name(impact.b);
      case 3:
        return impact.closing_speed;
      case 4:
        return impact.normal_impulse;
      case 5:
        return impact.tangential_impulse;
      default:
        return impact.lost_to_restitution + impact.lost_to_friction + impact.lost_to_sticking;
    }
  }

 private:
  [[nodiscard]] QString name(int body) const {
    return text_of((*bodies_)[static_cast<std::size_t>(body)].name);
  }

  double shown_ = 0.0;  // s
  std::uint64_t run_ = 0;
  std::int64_t impact_count_ = -1;
  std::shared_ptr<const std::vector<Body>> bodies_;
  std::vector<ImpactRecord> impacts_;  // the newest first
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
                  parent) {
  setToolTip(tr("A click on an impact goes to its moment"));
  connect(this, &QTableView::clicked, this, [this](const QModelIndex& index) {
    emit impactChosen(static_cast<ImpactsModel*>(model())->time(index.row()));
  });
}

void ImpactsTable::update_from(const Frame& newest, const Frame& shown, const Recorder& recorder) {
  static_cast<ImpactsModel*>(model())->set(newest, recorder);
  static_cast<ImpactsModel*>(model())->mark(shown);
}

}  // namespace carom
