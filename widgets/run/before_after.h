#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "physics/dynamics/state.h"
#include "physics/model/mass.h"
#include "physics/record/frame.h"
#include "physics/record/impact_theory.h"
#include "physics/record/interval_theory.h"
#include "physics/record/run_interval.h"
#include "widgets/base/figure_table.h"

namespace carom {

// Two moments of a run to be compared. Bodies after those of `before` were added later.
struct BeforeAfter {
  std::shared_ptr<const std::vector<Body>> bodies;  // of `after`
  State before;
  State after;
  std::vector<BodyIndex> shown;             // the bodies that move freely among those that took part
  std::optional<ImpactTheory> theory;       // where both are those of an impact
  std::optional<IntervalTheory> over_time;  // where they are the ends of an interval
};
[[nodiscard]] BeforeAfter before_and_after(const JumpMoment& moment);
[[nodiscard]] BeforeAfter before_and_after(const RunInterval& interval);
// From the start, with these bodies, to a moment.
[[nodiscard]] BeforeAfter since_start(const std::vector<Body>& start, const Frame& frame);

// Mass, velocity, spin, momentum, angular momentum about the origin and kinetic energy of each body before and
// after, and the sums. Of an impact the closed law's velocities stand beside those of the run, of an interval
// those of free flight; there closed laws of the sums stand under them. The error is the difference, relative
// to the fastest body; that of a spin is one of the speed at the radius of gyration, that of a sum is relative
// to the sum of the sizes. Spins and angular momenta are left out where all of them are zero.
class BeforeAfterModel : public FigureModel {
 public:
  explicit BeforeAfterModel(QObject* parent);
  void set(BeforeAfter compared);
  void clear();

  [[nodiscard]] bool is_sum(int row) const override;
  [[nodiscard]] Cell cell(int row, int column) const override;
  [[nodiscard]] QString tip(int row, int column) const override;

 private:
  enum class Quantity {
    kBody,
    kMass,
    kVelocityBefore,
    kVelocityTheory,
    kVelocityAfter,
    kVelocityError,
    kSpinBefore,
    kSpinTheory,
    kSpinAfter,
    kSpinError,
    kMomentumBefore,
    kMomentumAfter,
    kAngularBefore,
    kAngularAfter,
    kKineticBefore,
    kKineticAfter
  };
  struct Sums {
    Vec2 momentum = Vec2::Zero();  // N s
    double angular = 0.0;          // kg m²/s
    double kinetic = 0.0;          // J
  };

  void choose_columns();
  [[nodiscard]] Quantity quantity(int column) const { return quantities_[static_cast<std::size_t>(column)]; }
  [[nodiscard]] int sum_row() const { return static_cast<int>(compared_.shown.size()); }
  [[nodiscard]] const Eigen::Matrix3Xd& law() const;       // as in State; where there is a theory
  [[nodiscard]] QString why_no_law(BodyIndex body) const;  // likewise; empty: there is one
  // Of a quantity of which a sum may have a law.
  [[nodiscard]] std::optional<NoIntervalLaw> why_no_sum(Quantity quantity) const;
  [[nodiscard]] Sums of(const State& state, BodyIndex body) const;
  [[nodiscard]] Sums sum(const State& state) const;
  // Of the larger one before and after of each body; the momentum's is its x.
  [[nodiscard]] Sums sum_of_sizes() const;
  [[nodiscard]] double gyration(BodyIndex body) const;  // m, radius
  [[nodiscard]] Vec2 without_noise(const Vec2& velocity) const;
  [[nodiscard]] double without_noise(double spin, BodyIndex body) const;
  [[nodiscard]] double fastest() const;  // m/s
  [[nodiscard]] Cell of_state(Quantity quantity, const Sums& before, const Sums& after, bool was_there) const;
  [[nodiscard]] Cell of_law(Quantity quantity, BodyIndex body) const;
  [[nodiscard]] Cell sum_cell(Quantity quantity) const;
  [[nodiscard]] Cell theory_cell(Quantity quantity, bool value) const;
  [[nodiscard]] QString law_tip(Quantity quantity, BodyIndex body) const;
  [[nodiscard]] QString theory_tip(Quantity quantity, bool value) const;

  BeforeAfter compared_;
  MassProperties mass_;
  std::vector<Quantity> quantities_;  // by column
};

class BeforeAfterTable : public FigureTable {
  Q_OBJECT

 public:
  explicit BeforeAfterTable(QWidget* parent = nullptr);
  void show_pair(BeforeAfter compared);
  void show_nothing();
};

}  // namespace carom
