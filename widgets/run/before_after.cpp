#include "widgets/run/before_after.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "physics/math/vectors.h"
#include "widgets/base/rounding.h"
#include "widgets/run/law_text.h"

namespace carom {
namespace {

QString translated(const char* text) { return QCoreApplication::translate("BeforeAfterTable", text); }

FigureModel::Cell error_cell(double error) {
  const QString rounding = text_of_rounding(error, 1.0);
  return rounding.isEmpty() ? FigureModel::Cell(error) : rounding;
}

std::vector<BodyIndex> all_of(const State& state) {
  std::vector<BodyIndex> all;
  for (BodyIndex i{0}; i < state.size(); ++i) all.push_back(i);
  return all;
}

std::vector<BodyIndex> free_bodies(const std::vector<BodyIndex>& all, const std::vector<Body>& bodies) {
  std::vector<BodyIndex> free;
  std::copy_if(all.begin(), all.end(), std::back_inserter(free),
               [&](BodyIndex i) { return !has_infinite_mass(bodies[static_cast<std::size_t>(i)]); });
  return free;
}

}  // namespace

BeforeAfter before_and_after(const JumpMoment& moment) {
  std::shared_ptr<const std::vector<Body>> bodies{moment.compiled, &moment.compiled->scene.bodies};
  std::vector<BodyIndex> shown = free_bodies(moment.bodies(), *bodies);
  return {.bodies = std::move(bodies),
          .before = moment.before(),
          .after = moment.after(),
          .shown = std::move(shown),
          .theory = theory_of(moment),
          .over_time = std::nullopt};
}

BeforeAfter before_and_after(const RunInterval& interval) {
  std::shared_ptr<const std::vector<Body>> bodies{interval.compiled, &interval.compiled->scene.bodies};
  std::vector<BodyIndex> shown = free_bodies(all_of(interval.after), *bodies);
  return {.bodies = std::move(bodies),
          .before = interval.before,
          .after = interval.after,
          .shown = std::move(shown),
          .theory = std::nullopt,
          .over_time = theory_of(interval)};
}

BeforeAfter since_start(const std::vector<Body>& start, const Frame& frame) {
  return {.bodies = frame.bodies,
          .before = initial_state(start),
          .after = frame.state,
          .shown = free_bodies(all_of(frame.state), *frame.bodies),
          .theory = std::nullopt,
          .over_time = std::nullopt};
}

BeforeAfterModel::BeforeAfterModel(QObject* parent) : FigureModel({}, parent) { choose_columns(); }

void BeforeAfterModel::set(BeforeAfter compared) {
  compared_ = std::move(compared);
  mass_ = mass_properties(*compared_.bodies);
  choose_columns();
  constexpr int kOfTheory = 2;  // rows
  rows_changed(sum_row() + 1 + (compared_.over_time ? kOfTheory : 0));
}

void BeforeAfterModel::clear() {
  compared_ = {};
  rows_changed(0);
}

void BeforeAfterModel::choose_columns() {
  struct Zero {
    bool spins = true;
    bool angular = true;
  };
  struct Choice {
    Quantity quantity;
    Column column;
    bool of_law = false;
    bool Zero::*left_out = nullptr;
  };
  static const std::vector<Choice> kChoices = {
      {Quantity::kBody, {"body", 58, true}},
      {Quantity::kMass, {"m\n/ kg", 60}},
      {Quantity::kVelocityBefore, {"v before\n/ m/s", 98}},
      {Quantity::kVelocityTheory, {"after:\ntheory", 98}, true},
      {Quantity::kVelocityAfter, {"v after\n/ m/s", 98}},
      {Quantity::kVelocityError, {"error", 58, false, 2}, true},
      {Quantity::kSpinBefore, {"ω before\n/ rad/s", 66}, false, &Zero::spins},
      {Quantity::kSpinTheory, {"after:\ntheory", 66}, true, &Zero::spins},
      {Quantity::kSpinAfter, {"ω after\n/ rad/s", 66}, false, &Zero::spins},
      {Quantity::kSpinError, {"error", 58, false, 2}, true, &Zero::spins},
      {Quantity::kMomentumBefore, {"p before\n/ kg m/s", 102}},
      {Quantity::kMomentumAfter, {"p after\n/ kg m/s", 102}},
      {Quantity::kAngularBefore, {"L before\n/ kg m²/s", 74}, false, &Zero::angular},
      {Quantity::kAngularAfter, {"L after\n/ kg m²/s", 74}, false, &Zero::angular},
      {Quantity::kKineticBefore, {"K before\n/ J", 62}},
      {Quantity::kKineticAfter, {"K after\n/ J", 62}},
  };
  Zero zero;
  const double scale = fastest();
  const double angular = sum_of_sizes().angular;
  for (const BodyIndex body : compared_.shown) {
    for (const State* state : {&compared_.before, &compared_.after}) {
      if (body >= state->size()) continue;
      zero.spins = zero.spins && without_rounding(gyration(body) * state->v.col(body)[2], scale) == 0.0;
      zero.angular = zero.angular && without_rounding(of(*state, body).angular, angular) == 0.0;
    }
  }
  const bool has_theory = compared_.theory || compared_.over_time;
  std::vector<Quantity> quantities;
  std::vector<Column> columns;
  for (const Choice& choice : kChoices) {
    if ((choice.of_law && !has_theory) || (choice.left_out != nullptr && zero.*choice.left_out)) continue;
    quantities.push_back(choice.quantity);
    columns.push_back(choice.column);
  }
  if (quantities == quantities_) return;
  quantities_ = std::move(quantities);
  set_columns(std::move(columns));
}

bool BeforeAfterModel::is_sum(int row) const { return row == sum_row(); }

const Eigen::Matrix3Xd& BeforeAfterModel::law() const {
  return compared_.theory ? compared_.theory->v : compared_.over_time->v;
}

QString BeforeAfterModel::why_no_law(BodyIndex body) const {
  if (compared_.theory) return text_of(compared_.theory->why_not);
  return text_of(compared_.over_time->no_velocity[static_cast<std::size_t>(body)]);
}

BeforeAfterModel::Sums BeforeAfterModel::of(const State& state, BodyIndex body) const {
  const Vec2 v = state.velocity(body);
  const double spin = state.v.col(body)[2];
  const Vec2 p = mass_.mass[body] * v;
  return {p, cross(state.position(body), p) + mass_.inertia[body] * spin,
          0.5 * p.dot(v) + 0.5 * mass_.inertia[body] * spin * spin};
}

BeforeAfterModel::Sums BeforeAfterModel::sum(const State& state) const {
  Sums all;
  for (const BodyIndex body : compared_.shown) {
    if (body >= state.size()) continue;
    const Sums one = of(state, body);
    all.momentum += one.momentum;
    all.angular += one.angular;
    all.kinetic += one.kinetic;
  }
  return all;
}

BeforeAfterModel::Sums BeforeAfterModel::sum_of_sizes() const {
  Sums all;
  for (const BodyIndex body : compared_.shown) {
    const Sums before = body < compared_.before.size() ? of(compared_.before, body) : Sums();
    const Sums after = of(compared_.after, body);
    all.momentum.x() += std::max(before.momentum.norm(), after.momentum.norm());
    all.angular += std::max(std::abs(before.angular), std::abs(after.angular));
    all.kinetic += std::max(before.kinetic, after.kinetic);
  }
  return all;
}

double BeforeAfterModel::gyration(BodyIndex body) const {
  return std::sqrt(mass_.inertia[body] / mass_.mass[body]);
}

double BeforeAfterModel::fastest() const {
  double most = 0.0;
  for (const BodyIndex body : compared_.shown) {
    for (const State* state : {&compared_.before, &compared_.after}) {
      if (body >= state->size()) continue;  // it came in later
      most = std::max({most, state->velocity(body).norm(), gyration(body) * std::abs(state->v.col(body)[2])});
    }
  }
  return most;
}

FigureModel::Cell BeforeAfterModel::cell(int row, int column) const {
  if (row > sum_row()) return theory_cell(quantity(column), row - sum_row() == 1);
  if (is_sum(row)) return sum_cell(quantity(column));
  const BodyIndex body = compared_.shown[static_cast<std::size_t>(row)];
  const bool was_there = body < compared_.before.size();
  switch (quantity(column)) {
    case Quantity::kBody:
      return QString::fromStdString((*compared_.bodies)[static_cast<std::size_t>(body)].name);
    case Quantity::kMass:
      return mass_.mass[body];
    case Quantity::kVelocityBefore:
      return was_there ? Cell(without_noise(compared_.before.velocity(body))) : Cell();
    case Quantity::kVelocityAfter:
      return Cell(without_noise(compared_.after.velocity(body)));
    case Quantity::kSpinBefore:
      return was_there ? Cell(without_noise(compared_.before.v.col(body)[2], body)) : Cell();
    case Quantity::kSpinAfter:
      return without_noise(compared_.after.v.col(body)[2], body);
    case Quantity::kVelocityTheory:
    case Quantity::kVelocityError:
    case Quantity::kSpinTheory:
    case Quantity::kSpinError:
      return of_law(quantity(column), body);
    default:
      return of_state(quantity(column), was_there ? of(compared_.before, body) : Sums(),
                      of(compared_.after, body), was_there);
  }
}

// What is nothing but for rounding beside the fastest motion is shown as nothing.
Vec2 BeforeAfterModel::without_noise(const Vec2& velocity) const {
  const double scale = fastest();
  return {without_rounding(velocity.x(), scale), without_rounding(velocity.y(), scale)};
}

double BeforeAfterModel::without_noise(double spin, BodyIndex body) const {
  return without_rounding(gyration(body) * spin, fastest()) == 0.0 ? 0.0 : spin;
}

FigureModel::Cell BeforeAfterModel::of_law(Quantity quantity, BodyIndex body) const {
  if (!why_no_law(body).isEmpty()) return QStringLiteral("—");
  const Eigen::Matrix3Xd& theory = law();
  const Vec2 off = theory.col(body).head<2>() - compared_.after.velocity(body);
  const double off_spin = gyration(body) * std::abs(theory.col(body)[2] - compared_.after.v.col(body)[2]);
  const double scale = fastest();
  const auto share = [scale](double part) { return scale > 0.0 ? part / scale : 0.0; };
  switch (quantity) {
    case Quantity::kVelocityTheory:
      return Cell(without_noise(Vec2(theory.col(body).head<2>())));
    case Quantity::kVelocityError:
      return error_cell(share(off.norm()));
    case Quantity::kSpinTheory:
      return without_noise(theory.col(body)[2], body);
    default:
      return error_cell(share(off_spin));
  }
}

FigureModel::Cell BeforeAfterModel::of_state(Quantity quantity, const Sums& before, const Sums& after,
                                             bool was_there) const {
  const Sums sizes = sum_of_sizes();
  const auto momentum = [&sizes](const Sums& of) {
    const double scale = sizes.momentum.x();
    return Vec2(without_rounding(of.momentum.x(), scale), without_rounding(of.momentum.y(), scale));
  };
  switch (quantity) {
    case Quantity::kMomentumBefore:
      return was_there ? Cell(momentum(before)) : Cell();
    case Quantity::kMomentumAfter:
      return Cell(momentum(after));
    case Quantity::kAngularBefore:
      return was_there ? Cell(without_rounding(before.angular, sizes.angular)) : Cell();
    case Quantity::kAngularAfter:
      return without_rounding(after.angular, sizes.angular);
    case Quantity::kKineticBefore:
      return was_there ? Cell(before.kinetic) : Cell();
    case Quantity::kKineticAfter:
      return after.kinetic;
    default:
      return {};
  }
}

FigureModel::Cell BeforeAfterModel::sum_cell(Quantity quantity) const {
  if (quantity == Quantity::kBody) return translated("sum");
  if (quantity != Quantity::kMass) {
    return of_state(quantity, sum(compared_.before), sum(compared_.after), true);
  }
  double mass = 0.0;
  for (const BodyIndex body : compared_.shown) mass += mass_.mass[body];
  return mass;
}

// The rows under the sum: what closed laws say of it, and how far the run is off.
FigureModel::Cell BeforeAfterModel::theory_cell(Quantity quantity, bool value) const {
  if (quantity == Quantity::kBody) return value ? translated("theory") : translated("error");
  const auto why = why_no_sum(quantity);
  if (!why) return {};
  if (*why != NoIntervalLaw::kNone) return QStringLiteral("—");
  const IntervalTheory& theory = *compared_.over_time;
  const Sums run = sum(compared_.after);
  const Sums sizes = sum_of_sizes();
  const auto share = [](double part, double scale) { return scale > 0.0 ? part / scale : 0.0; };
  switch (quantity) {
    case Quantity::kMomentumAfter:
      if (value) return theory.momentum;
      return error_cell(share((theory.momentum - run.momentum).norm(), sizes.momentum.x()));
    case Quantity::kAngularAfter:
      if (value) return theory.angular;
      return error_cell(share(std::abs(theory.angular - run.angular), sizes.angular));
    default:
      if (value) return theory.kinetic;
      return error_cell(share(std::abs(theory.kinetic - run.kinetic), sizes.kinetic));
  }
}

std::optional<NoIntervalLaw> BeforeAfterModel::why_no_sum(Quantity quantity) const {
  switch (quantity) {
    case Quantity::kMomentumAfter:
      return compared_.over_time->no_momentum;
    case Quantity::kAngularAfter:
      return compared_.over_time->no_angular;
    case Quantity::kKineticAfter:
      return compared_.over_time->no_kinetic;
    default:
      return std::nullopt;
  }
}

QString BeforeAfterModel::tip(int row, int column) const {
  if (row > sum_row()) return theory_tip(quantity(column), row - sum_row() == 1);
  switch (quantity(column)) {
    case Quantity::kVelocityTheory:
    case Quantity::kSpinTheory:
    case Quantity::kVelocityError:
    case Quantity::kSpinError:
      return is_sum(row) ? QString()
                         : law_tip(quantity(column), compared_.shown[static_cast<std::size_t>(row)]);
    case Quantity::kAngularBefore:
    case Quantity::kAngularAfter:
      return translated("About the origin");
    default:
      return {};
  }
}

QString BeforeAfterModel::law_tip(Quantity quantity, BodyIndex body) const {
  if (QString why = why_no_law(body); !why.isEmpty()) return why;
  switch (quantity) {
    case Quantity::kVelocityError:
      return compared_.theory ? translated("Theory and run differ by this share of the impact's largest speed")
                              : translated("Theory and run differ by this share of the largest speed");
    case Quantity::kSpinError:
      return translated("Theory and run differ by this share of the largest speed, at the radius of gyration");
    default:
      return compared_.theory ? translated("By the closed law of the impact, from the velocities before it")
                              : translated("By free flight, from the velocity at A");
  }
}

QString BeforeAfterModel::theory_tip(Quantity quantity, bool value) const {
  const auto why = why_no_sum(quantity);
  if (!why) return {};
  if (*why != NoIntervalLaw::kNone) return text_of(*why);
  return value ? translated(
                     "By closed laws, from the state at A: only gravity acts from outside, if anything does")
               : translated("Theory and run differ by this share of the bodies' values, all taken as positive");
}

BeforeAfterTable::BeforeAfterTable(QWidget* parent)
    : FigureTable(new BeforeAfterModel(nullptr), tr("Before and after"), parent) {}

void BeforeAfterTable::show_pair(BeforeAfter compared) {
  static_cast<BeforeAfterModel*>(model())->set(std::move(compared));
}

void BeforeAfterTable::show_nothing() { static_cast<BeforeAfterModel*>(model())->clear(); }

}  // namespace carom
