#include "widgets/run/run_tables.h"

#include <QCoreApplication>
#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include "physics/model/mass.h"

namespace carom {
namespace {

QString text_of(const std::string& text) { return QString::fromStdString(text); }

double kinetic_energy(const State& state, const MassProperties& mass, int body) {
  return 0.5 * mass.mass[body] * state.velocity(body).squaredNorm() +
         0.5 * mass.inertia[body] * state.v(2, body) * state.v(2, body);
}

class BodiesModel : public FigureModel {
 public:
  using FigureModel::FigureModel;

  void set(const Frame& frame, const std::vector<Body>& before) {
    bodies_ = frame.bodies;
    mass_ = mass_properties(*bodies_);
    now_ = frame.state;
    before_ = initial_state(before);
    momentum_before_ = momentum_now_ = Vec2::Zero();
    total_mass_ = kinetic_before_ = kinetic_now_ = 0.0;
    moving_.clear();
    for (int i = 0; i < now_.size(); ++i) {
      if (has_infinite_mass((*bodies_)[static_cast<std::size_t>(i)])) continue;
      moving_.push_back(i);
      total_mass_ += mass_.mass[i];
      momentum_now_ += mass_.mass[i] * now_.velocity(i);
      kinetic_now_ += kinetic_energy(now_, mass_, i);
      if (i >= before_.size()) continue;
      momentum_before_ += mass_.mass[i] * before_.velocity(i);
      kinetic_before_ += kinetic_energy(before_, mass_, i);
    }
    rows_changed(static_cast<int>(moving_.size()) + 1);
  }

  [[nodiscard]] bool is_sum(int row) const override { return row == static_cast<int>(moving_.size()); }

  [[nodiscard]] Cell cell(int row, int column) const override {
    if (is_sum(row)) return sum(column);
    const int body = moving_[static_cast<std::size_t>(row)];
    const bool was_there = body < before_.size();
    switch (column) {
      case 0:
        return text_of((*bodies_)[static_cast<std::size_t>(body)].name);
      case 1:
        return mass_.mass[body];
      case 2:
        return was_there ? Cell(before_.velocity(body)) : Cell();
      case 3:
        return Cell(now_.velocity(body));
      case 4:
        return was_there ? Cell(Vec2(mass_.mass[body] * before_.velocity(body))) : Cell();
      case 5:
        return Cell(Vec2(mass_.mass[body] * now_.velocity(body)));
      case 6:
        return was_there ? Cell(kinetic_energy(before_, mass_, body)) : Cell();
      default:
        return kinetic_energy(now_, mass_, body);
    }
  }

 private:
  [[nodiscard]] Cell sum(int column) const {
    switch (column) {
      case 0:
        return QCoreApplication::translate("BodiesTable", "sum");
      case 1:
        return total_mass_;
      case 4:
        return momentum_before_;
      case 5:
        return momentum_now_;
      case 6:
        return kinetic_before_;
      case 7:
        return kinetic_now_;
      default:
        return {};
    }
  }

  std::shared_ptr<const std::vector<Body>> bodies_;
  MassProperties mass_;
  State now_, before_;
  std::vector<int> moving_;  // indices into bodies_
  double total_mass_ = 0.0;
  double kinetic_before_ = 0.0;
  double kinetic_now_ = 0.0;
  Vec2 momentum_before_ = Vec2::Zero();
  Vec2 momentum_now_ = Vec2::Zero();
};

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

BodiesTable::BodiesTable(QWidget* parent)
    : FigureTable(new BodiesModel({{"body", 58, true},
                                   {"m / kg", 62},
                                   {"v before / m/s", 92},
                                   {"v now / m/s", 104},
                                   {"p before / kg·m/s", 112},
                                   {"p now / kg·m/s", 112},
                                   {"K before / J", 72},
                                   {"K now / J", 66}},
                                  nullptr),
                  parent) {}

void BodiesTable::update_from(const Frame& frame, const std::vector<Body>& before) {
  static_cast<BodiesModel*>(model())->set(frame, before);
}

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
