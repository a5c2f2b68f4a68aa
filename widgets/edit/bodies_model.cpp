#include "widgets/edit/bodies_model.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/math/vectors.h"
#include "widgets/base/number_text.h"
#include "widgets/base/plain_text.h"
#include "widgets/base/rounding.h"
#include "widgets/edit/driven.h"
#include "widgets/edit/name_field.h"
#include "widgets/edit/quantity.h"

namespace carom {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("BodiesModel", text); }

QString name_of(const Body& body) { return QString::fromStdString(body.name); }

// In the order of BodiesModel::Column.
struct ColumnText {
  const char* heading;  // UTF-8
  int weight;           // of its width
  const char* name;     // when read aloud
  const char* unit;
  FieldPlace place{};        // of its values in a body
  const char* follows = "";  // what is changed instead; empty: it is typed
};
const std::vector<ColumnText>& columns() {
  static constexpr const char* kOfVelocity = "It follows from the velocity: change vx or vy.";
  static constexpr const char* kRelative = "The velocity less that of the centre of mass: change vx or vy.";
  static constexpr const char* kOfMomentum = "p = m v: change m or v.";
  static const std::vector<ColumnText> all = {
      {"body", 76, "name", ""},
      {"m / kg", 64, "mass", "kg", {"mass"}},
      {"x / m", 68, "x", "m", {"position", 0}},
      {"y / m", 68, "y", "m", {"position", 1}},
      {"vx\n/ m/s", 70, "velocity x", "m/s", {"velocity", 0}},
      {"vy\n/ m/s", 70, "velocity y", "m/s", {"velocity", 1}},
      {"speed\n/ m/s", 70, "speed", "m/s", {}, kOfVelocity},
      {"direction\n/ °", 70, "direction", "°", {}, kOfVelocity},
      {"vx from centre\n/ m/s", 80, "velocity x relative to the centre of mass", "m/s", {}, kRelative},
      {"vy from centre\n/ m/s", 80, "velocity y relative to the centre of mass", "m/s", {}, kRelative},
      {"spin\n/ rad/s", 76, "spin", "rad/s", {"spin"}},
      {"e", 52, "restitution", ""},
      {"p\n/ kg m/s", 76, "momentum", "kg m/s", {}, kOfMomentum},
      {"px\n/ kg m/s", 76, "momentum x", "kg m/s", {}, kOfMomentum},
      {"py\n/ kg m/s", 76, "momentum y", "kg m/s", {}, kOfMomentum},
      {"L\n/ kg m²/s",
       76,
       "angular momentum",
       "kg m²/s",
       {},
       "L = m (x vy − y vx) + I ω, about the origin: change one of these."},
      {"K / J", 62, "kinetic energy", "J", {}, "K = ½ m v² + ½ I ω²: change m, v or the spin."},
      {"r / m", 62, "radius", "m", {}, "The size of a body is changed in the inspector."},
      {"I\n/ kg m²",
       70,
       "inertia",
       "kg m²",
       {},
       "I follows from mass and shape; another one is set in the inspector."}};
  return all;
}
const ColumnText& column_text(int column) { return columns()[static_cast<std::size_t>(column)]; }

std::vector<FigureModel::Column> figure_columns() {
  std::vector<FigureModel::Column> figures;
  for (const ColumnText& column : columns())
    figures.push_back({column.heading, column.weight, &column == &columns().front()});
  return figures;
}

// °; nothing at rest.
FigureModel::Cell direction_cell(const Vec2& velocity) {
  if (velocity.isZero(0.0)) return {};
  return std::atan2(velocity.y(), velocity.x()) * 180.0 / std::numbers::pi;
}

QString kind_word(const Body& body) { return body.drive ? tr("driven") : tr("fixed"); }

TypedCell typed_name(const std::vector<Body>& bodies, const Body& body, const QString& text) {
  const QString name = text.trimmed();
  if (name == name_of(body)) return {};
  if (const QString fault = name_fault(name, "A body"); !fault.isEmpty()) return {{}, fault};
  const bool taken =
      std::any_of(bodies.begin(), bodies.end(), [&](const Body& other) { return name_of(other) == name; });
  if (taken) return {{}, tr("Another body is called %1.").arg(name)};
  return {renaming(body, name), {}};
}

bool is_velocity(int column) {
  return column == BodiesModel::kVelocityX || column == BodiesModel::kVelocityY ||
         column == BodiesModel::kSpeed || column == BodiesModel::kDirection;
}

// The number of a cell that can be edited.
std::optional<Inspected> inspected_cell(const Scene& scene, const Body& body, int column) {
  if (column == BodiesModel::kRestitution) return inspected_restitution(scene, body);
  return inspected_value(body, column_text(column).place);
}

}  // namespace

TypedCell typed_cell(const Scene& scene, const std::vector<Body>& bodies, int row, int column,
                     const QString& text) {
  const Body& body = bodies[static_cast<std::size_t>(row)];
  if (column == BodiesModel::kBody) return typed_name(bodies, body, text);
  const std::optional<Inspected> value = inspected_cell(scene, body, column);
  if (!value) return {};
  const TypedValues typed = typed_values(text, value->name, value->range, value->values, value->formula_names);
  if (!typed.fault.isEmpty()) return {{}, typed.fault};
  if (typed.values == value->values) return {};
  return {{value->edits(typed.values), value->undo_name(value->values, typed.values)}, {}};
}

QString value_of_cell(const Scene& scene, const std::vector<Body>& bodies, int row, int column,
                      const QString& text) {
  const auto value = inspected_cell(scene, bodies[static_cast<std::size_t>(row)], column);
  return value ? value_of_typed(text, value->range, value->values, value->formula_names) : QString();
}

const std::vector<ColumnChoice>& column_choices() {
  using Column = BodiesModel::Column;
  static const std::vector<ColumnChoice> all = {
      {"speed", "Speed", {Column::kSpeed}},
      {"direction", "Direction", {Column::kDirection}},
      {"relative", "v relative to the centre of mass", {Column::kRelativeX, Column::kRelativeY}},
      {"p", "p", {Column::kMomentum}},
      {"px", "px", {Column::kMomentumX}, true},
      {"py", "py", {Column::kMomentumY}, true},
      {"L", "L", {Column::kAngularMomentum}},
      {"K", "K", {Column::kEnergy}, true},
      {"r", "Radius", {Column::kRadius}},
      {"I", "I", {Column::kInertia}}};
  return all;
}

BodiesModel::BodiesModel(QObject* parent) : FigureModel(figure_columns(), parent) {}

bool BodiesModel::follows(int column) { return *column_text(column).follows != '\0'; }

void BodiesModel::show(const std::shared_ptr<const Scene>& scene, const std::shared_ptr<const Frame>& frame) {
  if (scene == scene_ && (scene != nullptr || frame == frame_)) return;
  scene_ = scene;
  frame_ = scene == nullptr ? frame : nullptr;
  if (scene != nullptr) surfaces_ = scene;
  if (scene == nullptr && frame == nullptr) return rows_changed(rowCount());  // what is shown stays
  auto bodies = scene == nullptr ? frame->bodies : nullptr;
  if (scene == nullptr) {
    state_ = frame->state;
  } else {
    const double time = frame == nullptr ? 0.0 : frame->time;
    std::vector<Body> seen = all_bodies(*scene);
    state_.resize(static_cast<int>(seen.size()));
    for (BodyIndex i{0}; i < state_.size(); ++i) {
      Body& body = seen[static_cast<std::size_t>(i)];
      state_.set_motion(i, initial_motion(body, time));
      if (frame != nullptr) body = moved_by_drive(std::move(body), time);
    }
    bodies = std::make_shared<const std::vector<Body>>(std::move(seen));
  }
  if (bodies != bodies_) mass_ = mass_properties(*bodies);
  if (scene == nullptr || bodies->size() != bodies_->size()) faults_.clear();
  bodies_ = bodies;
  count();
}

void BodiesModel::count() {
  find_scales();
  total_mass_ = energy_ = angular_momentum_ = 0.0;
  momentum_ = centre_ = Vec2::Zero();
  double of_momenta = 0.0;  // the sizes of what is summed
  double of_turning = 0.0;
  Vec2 of_places = Vec2::Zero();
  for (int i = 0; i < state_.size(); ++i) {
    if (has_infinite_mass((*bodies_)[static_cast<std::size_t>(i)])) continue;
    total_mass_ += mass_.mass[i];
    momentum_ += mass_.mass[i] * state_.velocity(i);
    centre_ += mass_.mass[i] * state_.position(i);
    energy_ += kinetic_energy(i);
    angular_momentum_ += angular_momentum(i);
    of_turning += std::abs(angular_momentum(i));
    of_momenta += mass_.mass[i] * std::max(state_.velocity(i).norm(), size_);
    of_places += mass_.mass[i] * state_.position(i).cwiseAbs();
  }
  for (const int axis : {0, 1}) {
    momentum_[axis] = without_rounding(momentum_[axis], of_momenta);
    centre_[axis] = without_rounding(centre_[axis], of_places[axis]);
  }
  angular_momentum_ = without_rounding(angular_momentum_, std::max(of_turning, length_ * of_momenta));
  if (total_mass_ > 0.0) centre_ /= total_mass_;
  shown_ = all_ ? bodies_->size() : std::min(bodies_->size(), kFirst);
  rows_changed(bodies_->empty() ? 0 : shown_bodies() + 1);
}

// Bodies that move in a second by rounding of the largest one's size are at rest.
void BodiesModel::find_scales() {
  length_ = size_ = fastest_ = heaviest_ = 0.0;
  double mass = 0.0;  // the largest
  for (int i = 0; i < state_.size(); ++i) {
    const Body& body = (*bodies_)[static_cast<std::size_t>(i)];
    if (has_infinite_mass(body)) continue;
    length_ = std::max({length_, state_.position(i).cwiseAbs().maxCoeff(), turning_radius(body)});
    fastest_ = std::max({fastest_, state_.velocity(i).norm(), rim_speed(i)});
    heaviest_ = std::max(heaviest_, mass_.mass[i] * state_.velocity(i).norm());
    size_ = std::max(size_, bounding_radius(body.shape));
    mass = std::max(mass, mass_.mass[i]);
  }
  fastest_ = std::max(fastest_, size_);
  heaviest_ = std::max(heaviest_, mass * size_);
}

double BodiesModel::rim_speed(int body) const {
  return std::abs(state_.v(2, body)) * turning_radius((*bodies_)[static_cast<std::size_t>(body)]);
}

double BodiesModel::moved(int body, double velocity) const {
  if (const auto& drive = (*bodies_)[static_cast<std::size_t>(body)].drive) {
    const double fastest =
        drive->velocity.norm() + std::abs(drive->angular_frequency) * drive->amplitude.norm();
    return without_rounding(velocity, fastest);
  }
  const bool rounding = without_rounding(velocity, fastest_) == 0.0 &&
                        without_rounding(mass_.mass[body] * velocity, heaviest_) == 0.0;
  return rounding ? 0.0 : velocity;
}

// A point-like body keeps its spin, whatever it is.
bool BodiesModel::turns(int body) const {
  const double rim = rim_speed(body);
  return without_rounding(rim, fastest_) != 0.0 ||
         turning_radius((*bodies_)[static_cast<std::size_t>(body)]) == 0.0;
}

void BodiesModel::show_all() {
  all_ = true;
  count();
}

void BodiesModel::mark(const std::vector<std::string>& names) {
  std::unordered_set<std::string> marked(names.begin(), names.end());
  if (marked == marked_) return;
  marked_ = std::move(marked);
  rows_changed(rowCount());
}

void BodiesModel::set_faults(Faults faults) {
  if (faults == faults_) return;
  faults_ = std::move(faults);
  rows_changed(rowCount());
}

void BodiesModel::watch_changes(bool watch) {
  watched_.clear();
  for (int row = 0; watch && row < shown_bodies(); ++row) {
    const std::string& name = (*bodies_)[static_cast<std::size_t>(row)].name;
    for (int column = kMass; column < columnCount(); ++column)
      if (!follows(column)) watched_[{name, column}] = index(row, column).data().toString();
  }
  rows_changed(rowCount());
}

bool BodiesModel::is_changed(int row, int column) const {
  if (watched_.empty() || is_sum(row)) return false;
  const auto before = watched_.find({(*bodies_)[static_cast<std::size_t>(row)].name, column});
  return before != watched_.end() && before->second != index(row, column).data().toString();
}

bool BodiesModel::is_marked(int row) const {
  return !is_sum(row) && marked_.contains((*bodies_)[static_cast<std::size_t>(row)].name);
}

const QString* BodiesModel::fault(int row, int column) const {
  const auto found = faults_.find({row, column});
  return found == faults_.end() ? nullptr : &found->second;
}

QString BodiesModel::why_not(int row, int column) const {
  if (follows(column)) return tr(column_text(column).follows);
  if (is_sum(row)) return tr("This is of all bodies together: change one of them.");
  const Body& body = (*bodies_)[static_cast<std::size_t>(row)];
  const bool of_all = column == kBody || column == kX || column == kY || column == kRestitution;
  if (!of_all && has_infinite_mass(body))
    return tr("%1 is %2: only its name, x, y and e are edited here.").arg(name_of(body), kind_word(body));
  return can_edit() ? QString() : tr("Nothing can be edited at this moment.");
}

QString BodiesModel::full_text(int row, int column) const {
  const Cell content = cell(row, column);
  const auto* value = std::get_if<double>(&content);
  return value == nullptr ? std::get<QString>(content) : full_figure(*value);
}

double BodiesModel::kinetic_energy(int body) const {
  const double speed = moved(body, state_.velocity(body).norm());
  const double spin = turns(body) ? state_.v(2, body) : 0.0;
  return 0.5 * mass_.mass[body] * speed * speed + 0.5 * mass_.inertia[body] * spin * spin;
}

// About the origin.
double BodiesModel::angular_momentum(int body) const {
  const Vec2 velocity = state_.velocity(body);
  const double spin = turns(body) ? state_.v(2, body) : 0.0;
  return mass_.mass[body] *
             cross(state_.position(body), {moved(body, velocity.x()), moved(body, velocity.y())}) +
         mass_.inertia[body] * spin;
}

FigureModel::Cell BodiesModel::cell(int row, int column) const {
  if (is_sum(row)) return sum(column);
  const Body& body = (*bodies_)[static_cast<std::size_t>(row)];
  const bool stays = has_infinite_mass(body);
  const Vec2 place = state_.position(row);
  switch (column) {
    case kBody:
      return name_of(body);
    case kX:
      return stays ? place.x() : without_rounding(place.x(), length_);
    case kY:
      return stays ? place.y() : without_rounding(place.y(), length_);
    case kMass:
      return stays ? Cell(kind_word(body)) : Cell(mass_.mass[row]);
    case kRestitution:
      return surfaces_ == nullptr ? Cell() : Cell(material_named(*surfaces_, body.material).restitution);
    case kRadius: {
      const auto* disc = std::get_if<Disc>(&body.shape);
      return disc == nullptr ? Cell() : Cell(disc->radius);
    }
    default:
      return stays && !(body.drive && is_velocity(column)) ? Cell() : motion(row, column);
  }
}

// Of a body that moves; of a driven one its velocity alone.
FigureModel::Cell BodiesModel::motion(int body, int column) const {
  const Vec2 velocity = state_.velocity(body);
  const auto from_centre = [&](int axis) {
    const double centre = momentum_[axis] / total_mass_;
    return without_rounding(velocity[axis] - centre, std::abs(velocity[axis]) + std::abs(centre));
  };
  switch (column) {
    case kVelocityX:
      return moved(body, velocity.x());
    case kVelocityY:
      return moved(body, velocity.y());
    case kSpeed:
      return moved(body, velocity.norm());
    case kDirection:
      return direction_cell({moved(body, velocity.x()), moved(body, velocity.y())});
    case kRelativeX:
      return from_centre(0);
    case kRelativeY:
      return from_centre(1);
    case kSpin:
      return turns(body) ? state_.v(2, body) : 0.0;
    case kMomentum:
      return mass_.mass[body] * moved(body, velocity.norm());
    case kMomentumX:
      return mass_.mass[body] * moved(body, velocity.x());
    case kMomentumY:
      return mass_.mass[body] * moved(body, velocity.y());
    case kAngularMomentum:
      return angular_momentum(body);
    case kInertia:
      return mass_.inertia[body];
    default:
      return kinetic_energy(body);
  }
}

FigureModel::Cell BodiesModel::sum(int column) const {
  if (column == kBody) return tr("all");
  if (total_mass_ == 0.0) return {};
  switch (column) {
    case kMass:
      return total_mass_;
    case kX:
      return centre_.x();
    case kY:
      return centre_.y();
    case kVelocityX:
      return momentum_.x() / total_mass_;
    case kVelocityY:
      return momentum_.y() / total_mass_;
    case kSpeed:
      return momentum_.norm() / total_mass_;
    case kDirection:
      return direction_cell(momentum_);
    case kMomentum:
      return momentum_.norm();
    case kMomentumX:
      return momentum_.x();
    case kMomentumY:
      return momentum_.y();
    case kAngularMomentum:
      return angular_momentum_;
    case kEnergy:
      return energy_;
    default:
      return {};
  }
}

bool BodiesModel::is_idle(int row, int column) const {
  return column == kMass && !is_sum(row) && has_infinite_mass((*bodies_)[static_cast<std::size_t>(row)]);
}

QString BodiesModel::tip(int row, int column) const {
  if (const QString* why = fault(row, column)) return *why;
  if (follows(column)) return why_not(row, column);
  if (!is_sum(row)) {
    if (column == kRestitution) return surface_tip(row);
    return is_idle(row, column) ? why_not(row, column) : QString();
  }
  if (column == kBody) return tr("All bodies that move: their mass, their centre of mass, p, L and K");
  return column == kMass ? tr("mass of all") : tr("of the centre of mass");
}

// Whose surface it is, since it changes for all of them.
QString BodiesModel::surface_tip(int row) const {
  const std::string& material = (*bodies_)[static_cast<std::size_t>(row)].material;
  const auto users = std::count_if(bodies_->begin(), bodies_->end(),
                                   [&](const Body& body) { return body.material == material; });
  const QString name = QString::fromStdString(material);
  return users == 1 ? tr("e of %1").arg(name)
                    : tr("e of %1, the surface of %2 bodies: it changes for all of them").arg(name).arg(users);
}

Qt::ItemFlags BodiesModel::flags(const QModelIndex& index) const {
  const bool editable = why_not(index.row(), index.column()).isEmpty();
  return FigureModel::flags(index) | (editable ? Qt::ItemIsEditable : Qt::NoItemFlags);
}

QVariant BodiesModel::data(const QModelIndex& index, int role) const {
  return role == Qt::AccessibleTextRole && knows(index.row()) ? spoken(index) : FigureModel::data(index, role);
}

// "mass of light: 1.000 kg".
QString BodiesModel::spoken(const QModelIndex& index) const {
  const ColumnText& column = column_text(index.column());
  const QString whose =
      is_sum(index.row()) ? tr("all") : name_of(bodies()[static_cast<std::size_t>(index.row())]);
  const QString shown = data(index).toString();
  const QString text = tr("%1 of %2: %3").arg(tr(column.name), whose, shown.isEmpty() ? tr("none") : shown);
  const bool number = !shown.isEmpty() && index.column() != kBody && !is_idle(index.row(), index.column());
  return number ? text + ' ' + column.unit : text;
}

}  // namespace carom
