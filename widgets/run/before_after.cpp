#include "widgets/run/before_after.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "physics/math/vectors.h"
#include "widgets/base/number_text.h"

namespace carom {
namespace {

QString translated(const char* text) { return QCoreApplication::translate("BeforeAfterTable", text); }

// Why a cell of the theory has no value.
const char* text_of(NoTheory why) {
  switch (why) {
    case NoTheory::kNone:
      return "";
    case NoTheory::kJoints:
      return QT_TRANSLATE_NOOP("BeforeAfterTable",
                               "A joint passes the impulse on to other bodies: no closed law for two bodies");
    case NoTheory::kMaterials:
      return QT_TRANSLATE_NOOP("BeforeAfterTable",
                               "A body has several materials: which of them touched is not recorded");
    case NoTheory::kSlipStops:
      return QT_TRANSLATE_NOOP("BeforeAfterTable",
                               "Friction stops the slip of this off-centre impact on the way: no closed law");
    case NoTheory::kFrictionAtOnce:
      return QT_TRANSLATE_NOOP("BeforeAfterTable", "Several contacts at once with friction: no closed law");
    case NoTheory::kRestitution:
      return QT_TRANSLATE_NOOP("BeforeAfterTable",
                               "Contacts at once with different or lowered restitution: no closed law");
  }
  return "";
}

FigureModel::Cell error_cell(double error) {
  constexpr double kRounding = 1e-12;
  if (error < kRounding) return QStringLiteral("< 1e") + kMinus + QStringLiteral("12");
  return error;
}

std::vector<int> free_bodies(const std::vector<int>& all, const std::vector<Body>& bodies) {
  std::vector<int> free;
  std::copy_if(all.begin(), all.end(), std::back_inserter(free),
               [&](int i) { return !has_infinite_mass(bodies[static_cast<std::size_t>(i)]); });
  return free;
}

}  // namespace

BeforeAfter before_and_after(const JumpMoment& moment) {
  std::shared_ptr<const std::vector<Body>> bodies{moment.compiled, &moment.compiled->scene.bodies};
  std::vector<int> shown = free_bodies(moment.bodies(), *bodies);
  return {.bodies = std::move(bodies),
          .before = moment.before(),
          .after = moment.after(),
          .shown = std::move(shown),
          .theory = theory_of(moment)};
}

BeforeAfter since_start(const std::vector<Body>& start, const Frame& frame) {
  std::vector<int> all(static_cast<std::size_t>(frame.state.size()));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  return {.bodies = frame.bodies,
          .before = initial_state(start),
          .after = frame.state,
          .shown = free_bodies(all, *frame.bodies),
          .theory = std::nullopt};
}

BeforeAfterModel::BeforeAfterModel(QObject* parent) : FigureModel({}, parent) { choose_columns(); }

void BeforeAfterModel::set(BeforeAfter compared) {
  compared_ = std::move(compared);
  mass_ = mass_properties(*compared_.bodies);
  choose_columns();
  rows_changed(static_cast<int>(compared_.shown.size()) + 1);
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
      {Quantity::kBody, {"body", 66, true}},
      {Quantity::kMass, {"m / kg", 70}},
      {Quantity::kVelocityBefore, {"v before / m/s", 104}},
      {Quantity::kVelocityTheory, {"after: theory", 104}, true},
      {Quantity::kVelocityAfter, {"v after / m/s", 104}},
      {Quantity::kVelocityError, {"error", 74, false, 2}, true},
      {Quantity::kSpinBefore, {"ω before / rad/s", 108}, false, &Zero::spins},
      {Quantity::kSpinTheory, {"after: theory", 86}, true, &Zero::spins},
      {Quantity::kSpinAfter, {"ω after / rad/s", 100}, false, &Zero::spins},
      {Quantity::kSpinError, {"error", 74, false, 2}, true, &Zero::spins},
      {Quantity::kMomentumBefore, {"p before / kg·m/s", 124}},
      {Quantity::kMomentumAfter, {"p after / kg·m/s", 116}},
      {Quantity::kAngularBefore, {"L before / kg·m²/s", 130}, false, &Zero::angular},
      {Quantity::kAngularAfter, {"L after / kg·m²/s", 122}, false, &Zero::angular},
      {Quantity::kKineticBefore, {"K before / J", 78}},
      {Quantity::kKineticAfter, {"K after / J", 70}},
  };
  Zero zero;
  for (const int body : compared_.shown) {
    for (const State* state : {&compared_.before, &compared_.after}) {
      if (body >= state->size()) continue;
      zero.spins = zero.spins && state->v(2, body) == 0.0;
      zero.angular = zero.angular && of(*state, body).angular == 0.0;
    }
  }
  std::vector<Quantity> quantities;
  std::vector<Column> columns;
  for (const Choice& choice : kChoices) {
    if ((choice.of_law && !compared_.theory) || (choice.left_out != nullptr && zero.*choice.left_out)) continue;
    quantities.push_back(choice.quantity);
    columns.push_back(choice.column);
  }
  if (quantities == quantities_) return;
  quantities_ = std::move(quantities);
  set_columns(std::move(columns));
}

bool BeforeAfterModel::is_sum(int row) const { return row == static_cast<int>(compared_.shown.size()); }

bool BeforeAfterModel::has_law() const {
  return compared_.theory && compared_.theory->why_not == NoTheory::kNone;
}

BeforeAfterModel::Sums BeforeAfterModel::of(const State& state, int body) const {
  const Vec2 v = state.velocity(body);
  const double spin = state.v(2, body);
  const Vec2 p = mass_.mass[body] * v;
  return {p, cross(state.position(body), p) + mass_.inertia[body] * spin,
          0.5 * p.dot(v) + 0.5 * mass_.inertia[body] * spin * spin};
}

BeforeAfterModel::Sums BeforeAfterModel::sum(const State& state) const {
  Sums all;
  for (const int body : compared_.shown) {
    if (body >= state.size()) continue;
    const Sums one = of(state, body);
    all.momentum += one.momentum;
    all.angular += one.angular;
    all.kinetic += one.kinetic;
  }
  return all;
}

double BeforeAfterModel::gyration(int body) const { return std::sqrt(mass_.inertia[body] / mass_.mass[body]); }

double BeforeAfterModel::fastest() const {
  double most = 0.0;
  for (const int body : compared_.shown) {
    for (const State* state : {&compared_.before, &compared_.after})
      most = std::max({most, state->velocity(body).norm(), gyration(body) * std::abs(state->v(2, body))});
  }
  return most;
}

FigureModel::Cell BeforeAfterModel::cell(int row, int column) const {
  if (is_sum(row)) return sum_cell(quantity(column));
  const int body = compared_.shown[static_cast<std::size_t>(row)];
  const bool was_there = body < compared_.before.size();
  switch (quantity(column)) {
    case Quantity::kBody:
      return QString::fromStdString((*compared_.bodies)[static_cast<std::size_t>(body)].name);
    case Quantity::kMass:
      return mass_.mass[body];
    case Quantity::kVelocityBefore:
      return was_there ? Cell(compared_.before.velocity(body)) : Cell();
    case Quantity::kVelocityAfter:
      return Cell(compared_.after.velocity(body));
    case Quantity::kSpinBefore:
      return was_there ? Cell(compared_.before.v(2, body)) : Cell();
    case Quantity::kSpinAfter:
      return compared_.after.v(2, body);
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

FigureModel::Cell BeforeAfterModel::of_law(Quantity quantity, int body) const {
  if (!has_law()) return QStringLiteral("—");
  const Eigen::Matrix3Xd& theory = compared_.theory->v;
  const Vec2 off = theory.col(body).head<2>() - compared_.after.velocity(body);
  const double off_spin = gyration(body) * std::abs(theory(2, body) - compared_.after.v(2, body));
  const double scale = fastest();
  const auto share = [scale](double part) { return scale > 0.0 ? part / scale : 0.0; };
  switch (quantity) {
    case Quantity::kVelocityTheory:
      return Cell(Vec2(theory.col(body).head<2>()));
    case Quantity::kVelocityError:
      return error_cell(share(off.norm()));
    case Quantity::kSpinTheory:
      return theory(2, body);
    default:
      return error_cell(share(off_spin));
  }
}

FigureModel::Cell BeforeAfterModel::of_state(Quantity quantity, const Sums& before, const Sums& after,
                                             bool was_there) const {
  switch (quantity) {
    case Quantity::kMomentumBefore:
      return was_there ? Cell(before.momentum) : Cell();
    case Quantity::kMomentumAfter:
      return Cell(after.momentum);
    case Quantity::kAngularBefore:
      return was_there ? Cell(before.angular) : Cell();
    case Quantity::kAngularAfter:
      return after.angular;
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
  if (quantity != Quantity::kMass) return of_state(quantity, sum(compared_.before), sum(compared_.after), true);
  double mass = 0.0;
  for (const int body : compared_.shown) mass += mass_.mass[body];
  return mass;
}

QString BeforeAfterModel::tip(int row, int column) const {
  if (is_sum(row)) return {};
  switch (quantity(column)) {
    case Quantity::kVelocityTheory:
    case Quantity::kSpinTheory:
      return has_law() ? translated("By the closed law of the impact, from the velocities before it")
                       : translated(text_of(compared_.theory->why_not));
    case Quantity::kVelocityError:
      return has_law() ? translated("Theory and run differ by this share of the impact's largest speed")
                       : translated(text_of(compared_.theory->why_not));
    case Quantity::kSpinError:
      return has_law() ? translated(
                             "Theory and run differ by this share of the impact's largest speed, at the radius "
                             "of gyration")
                       : translated(text_of(compared_.theory->why_not));
    case Quantity::kAngularBefore:
    case Quantity::kAngularAfter:
      return translated("About the origin");
    default:
      return {};
  }
}

BeforeAfterTable::BeforeAfterTable(QWidget* parent) : FigureTable(new BeforeAfterModel(nullptr), parent) {}

void BeforeAfterTable::show_pair(BeforeAfter compared) {
  static_cast<BeforeAfterModel*>(model())->set(std::move(compared));
}

void BeforeAfterTable::show_nothing() { static_cast<BeforeAfterModel*>(model())->clear(); }

}  // namespace carom
