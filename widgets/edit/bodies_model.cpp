#include "widgets/edit/bodies_model.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

#include "widgets/base/number_text.h"
#include "widgets/base/plain_text.h"
#include "widgets/base/rounding.h"
#include "widgets/edit/name_field.h"
#include "widgets/edit/quantity.h"

namespace carom {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("BodiesModel", text); }

QString name_of(const Body& body) { return QString::fromStdString(body.name); }

// Of the columns: what they are called when read aloud, and where their values stand in a body.
struct Spoken {
  const char* name = "";
  const char* unit = "";
  FieldPlace place;
};
const std::array<Spoken, 9>& spoken_columns() {
  static const std::array<Spoken, 9> columns = {{{"name", "", {}},
                                                 {"mass", "kg", {"mass"}},
                                                 {"x", "m", {"position", 0}},
                                                 {"y", "m", {"position", 1}},
                                                 {"velocity x", "m/s", {"velocity", 0}},
                                                 {"velocity y", "m/s", {"velocity", 1}},
                                                 {"spin", "rad/s", {"spin"}},
                                                 {"momentum", "kg m/s", {}},
                                                 {"kinetic energy", "J", {}}}};
  return columns;
}
const Spoken& spoken_column(int column) { return spoken_columns()[static_cast<std::size_t>(column)]; }

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

}  // namespace

TypedCell typed_cell(const std::vector<Body>& bodies, int row, int column, const QString& text) {
  const Body& body = bodies[static_cast<std::size_t>(row)];
  if (column == BodiesModel::kBody) return typed_name(bodies, body, text);
  const std::optional<Inspected> value = inspected_value(body, spoken_column(column).place);
  if (!value) return {};
  const TypedValues typed = typed_values(text, value->name, value->range, value->values, value->formula_names);
  if (!typed.fault.isEmpty()) return {{}, typed.fault};
  if (typed.values == value->values) return {};
  return {{value->edits(typed.values), value->undo_name(value->values, typed.values)}, {}};
}

BodiesModel::BodiesModel(QObject* parent)
    : FigureModel({{"body", 76, true},
                   {"m / kg", 64},
                   {"x / m", 68},
                   {"y / m", 68},
                   {"vx / m/s", 70},
                   {"vy / m/s", 70},
                   {"spin / rad/s", 76},
                   {"p / kg·m/s", 104},
                   {"K / J", 62}},
                  parent) {}

void BodiesModel::show(const std::shared_ptr<const Scene>& scene, const std::shared_ptr<const Frame>& frame) {
  if (scene == scene_ && (scene != nullptr || frame == frame_)) return;
  scene_ = scene;
  frame_ = scene == nullptr ? frame : nullptr;
  if (scene == nullptr && frame == nullptr) return rows_changed(rowCount());  // what is shown stays
  const auto bodies =
      scene != nullptr ? std::make_shared<const std::vector<Body>>(all_bodies(*scene)) : frame->bodies;
  if (bodies != bodies_) mass_ = mass_properties(*bodies);
  if (scene == nullptr || bodies->size() != bodies_->size()) faults_.clear();
  bodies_ = bodies;
  state_ = scene != nullptr ? initial_state(*bodies) : frame->state;
  count();
}

void BodiesModel::count() {
  total_mass_ = energy_ = 0.0;
  momentum_ = centre_ = Vec2::Zero();
  double of_momenta = 0.0;  // the sizes of what is summed
  Vec2 of_places = Vec2::Zero();
  for (int i = 0; i < state_.size(); ++i) {
    if (has_infinite_mass((*bodies_)[static_cast<std::size_t>(i)])) continue;
    total_mass_ += mass_.mass[i];
    momentum_ += mass_.mass[i] * state_.velocity(i);
    centre_ += mass_.mass[i] * state_.position(i);
    energy_ += kinetic_energy(i);
    of_momenta += mass_.mass[i] * state_.velocity(i).norm();
    of_places += mass_.mass[i] * state_.position(i).cwiseAbs();
  }
  for (const int axis : {0, 1}) {
    momentum_[axis] = without_rounding(momentum_[axis], of_momenta);
    centre_[axis] = without_rounding(centre_[axis], of_places[axis]);
  }
  if (total_mass_ > 0.0) centre_ /= total_mass_;
  shown_ = all_ ? bodies_->size() : std::min(bodies_->size(), kFirst);
  rows_changed(bodies_->empty() ? 0 : shown_bodies() + 1);
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
    for (int column = kMass; column <= kSpin; ++column)
      watched_[{name, column}] = index(row, column).data().toString();
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
  if (column == kMomentum) return tr("p = m v: change m or v.");
  if (column == kEnergy) return tr("K = ½ m v² + ½ I ω²: change m, v or the spin.");
  if (is_sum(row)) return tr("This is of all bodies together: change one of them.");
  const Body& body = (*bodies_)[static_cast<std::size_t>(row)];
  const bool of_all = column == kBody || column == kX || column == kY;
  if (!of_all && has_infinite_mass(body))
    return tr("%1 is %2: only its name, x and y are edited here.").arg(name_of(body), kind_word(body));
  return can_edit() ? QString() : tr("Pause to edit.");
}

QString BodiesModel::full_text(int row, int column) const {
  const Cell content = cell(row, column);
  const auto* value = std::get_if<double>(&content);
  return value == nullptr ? std::get<QString>(content) : full_figure(*value);
}

double BodiesModel::kinetic_energy(int body) const {
  const double spin = state_.v(2, body);
  return 0.5 * mass_.mass[body] * state_.velocity(body).squaredNorm() + 0.5 * mass_.inertia[body] * spin * spin;
}

FigureModel::Cell BodiesModel::cell(int row, int column) const {
  if (is_sum(row)) return sum(column);
  const Body& body = (*bodies_)[static_cast<std::size_t>(row)];
  const bool stays = has_infinite_mass(body);
  // Of a driven body the place that is its own, without the drive's part.
  const Vec2 place = stays ? body.position : state_.position(row);
  switch (column) {
    case kBody:
      return name_of(body);
    case kX:
      return place.x();
    case kY:
      return place.y();
    case kMass:
      return stays ? Cell(kind_word(body)) : Cell(mass_.mass[row]);
    default:
      break;
  }
  if (stays) return {};
  switch (column) {
    case kVelocityX:
      return state_.v(0, row);
    case kVelocityY:
      return state_.v(1, row);
    case kSpin:
      return state_.v(2, row);
    case kMomentum:
      return Cell(Vec2(mass_.mass[row] * state_.velocity(row)));
    default:
      return kinetic_energy(row);
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
    case kMomentum:
      return momentum_;
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
  if (column == kMomentum || column == kEnergy) return why_not(row, column);
  if (!is_sum(row)) return is_idle(row, column) ? why_not(row, column) : QString();
  if (column == kBody) return tr("All bodies that move: their mass, their centre of mass, p and K");
  return column == kMass ? tr("mass of all") : tr("of the centre of mass");
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
  const Spoken& column = spoken_column(index.column());
  const QString whose =
      is_sum(index.row()) ? tr("all") : name_of(bodies()[static_cast<std::size_t>(index.row())]);
  const QString shown = data(index).toString();
  const QString text = tr("%1 of %2: %3").arg(tr(column.name), whose, shown.isEmpty() ? tr("none") : shown);
  const bool number = !shown.isEmpty() && index.column() != kBody && !is_idle(index.row(), index.column());
  return number ? text + ' ' + column.unit : text;
}

}  // namespace carom
