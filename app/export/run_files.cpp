#include "app/export/run_files.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "physics/files/csv.h"
#include "physics/ledger/ledger_entries.h"

namespace carom {
namespace {

// A column of an impact's row after its time and its bodies.
struct ImpactColumn {
  const char* heading;
  double (*value)(const ImpactRecord&);
};
constexpr auto kImpactColumns = std::to_array<ImpactColumn>({
    {"point_x [m]", [](const ImpactRecord& i) { return i.point.x(); }},
    {"point_y [m]", [](const ImpactRecord& i) { return i.point.y(); }},
    {"normal_x [1]", [](const ImpactRecord& i) { return i.normal.x(); }},
    {"normal_y [1]", [](const ImpactRecord& i) { return i.normal.y(); }},
    {"normal_impulse [N s]", [](const ImpactRecord& i) { return i.normal_impulse; }},
    {"tangential_impulse [N s]", [](const ImpactRecord& i) { return i.tangential_impulse; }},
    {"closing_speed [m/s]", [](const ImpactRecord& i) { return i.closing_speed; }},
    {"lost_to_restitution [J]", [](const ImpactRecord& i) { return i.lost_to_restitution; }},
    {"lost_to_friction [J]", [](const ImpactRecord& i) { return i.lost_to_friction; }},
    {"lost_to_sticking [J]", [](const ImpactRecord& i) { return i.lost_to_sticking; }},
});

}  // namespace

std::vector<Quantity> run_columns(const std::vector<Body>& bodies) {
  std::vector<Quantity> columns;
  const auto add = [&](std::string_view name, std::vector<BodyIndex> of = {}) {
    columns.push_back({find_observable(name), std::move(of)});
  };
  for (const char* name : {"kinetic_energy", "rotational_energy", "potential_energy", "total_energy",
                           "momentum_x", "momentum_y", "angular_momentum", "numerical_drift", "impacts"}) {
    add(name);
  }
  const auto may_move = [](const Body& body) { return !body.fixed; };
  if (std::count_if(bodies.begin(), bodies.end(), may_move) <= kMostPaths) {
    for (BodyIndex i{0}; i < static_cast<int>(bodies.size()); ++i) {
      if (!may_move(bodies[i])) continue;
      for (const char* name : {"x", "y", "angle", "velocity_x", "velocity_y", "spin"}) {
        add(name, {i});
      }
    }
  }
  for (const EnergyEntry::Kind kind :
       {EnergyEntry::Kind::kLoss, EnergyEntry::Kind::kInput, EnergyEntry::Kind::kCorrection}) {
    for (const EnergyEntry& entry : kEnergyEntries) {
      if (entry.kind == kind) add(entry.key);
    }
  }
  for (const char* name :
       {"momentum_drift_x", "momentum_drift_y", "momentum_to_walls_x", "momentum_to_walls_y"}) {
    add(name);
  }
  add("angular_momentum_drift");
  for (const MomentumEntry& entry : kMomentumEntries) {
    if (entry.angular != &Ledger::initial_angular_momentum) add(entry.angular_key);
  }
  return columns;
}

std::string csv_header(const std::vector<Quantity>& columns, const std::vector<Body>& bodies, char separator) {
  const auto name_of = [&](const Observable& observable, const std::vector<BodyIndex>& of) {
    std::string name;
    for (const BodyIndex body : of) name += bodies[static_cast<std::size_t>(body)].name + " ";
    return name + std::string(observable.name);
  };
  CsvLine line(separator);
  line.add("time [s]");
  for (const Quantity& column : columns) {
    std::string heading = name_of(*column.observable, column.bodies);
    if (!column.less.empty()) {
      heading += fmt::format(" - ({})", column.less.formula.text());
      if (column.less.x != nullptr) heading += ", x = " + name_of(*column.less.x, column.less.x_bodies);
    }
    line.add(csv_heading(heading, column.observable->unit));
  }
  return line.text();
}

std::string csv_line(double time, std::span<const double> values, char separator) {
  CsvLine line(separator);
  line.add(time);
  for (const double value : values) line.add(value);
  return line.text();
}

std::string csv_line(const std::vector<Quantity>& columns, const Simulation& simulation) {
  ImpactTally tally;
  tally.begin(simulation);
  const Reading now = reading_of(simulation, tally);
  std::vector<double> values;
  for (const Quantity& column : columns) values.push_back(column.value(now));
  return csv_line(now.time, values);
}

std::string events_csv_header(char separator) {
  CsvLine line(separator);
  line.add("time [s]").add("body_a").add("body_b");
  for (const ImpactColumn& column : kImpactColumns) line.add(column.heading);
  return line.text();
}

std::string events_csv_line(const Simulation& s, const ImpactRecord& i, char separator) {
  CsvLine line(separator);
  line.add(i.time);
  for (const int body : {i.a, i.b}) line.add(s.bodies()[static_cast<std::size_t>(body)].name);
  for (const ImpactColumn& column : kImpactColumns) line.add(column.value(i));
  return line.text();
}

}  // namespace carom
