#include "app/export/run_files.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "physics/world/ledger_entries.h"

namespace carom {
namespace {

// Never "-0", which a law leaves where nothing happened.
double plain(double value) { return value == 0.0 ? 0.0 : value; }

}  // namespace

std::string csv_field(const std::string& text, char separator) {
  const char special[] = {separator, '"', '\n', '\r', '\0'};
  if (text.find_first_of(special) == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
  return out;
}

std::vector<Quantity> run_columns(const std::vector<Body>& bodies) {
  std::vector<Quantity> columns;
  const auto add = [&](std::string_view name, std::vector<int> of = {}) {
    columns.push_back({find_observable(name), std::move(of)});
  };
  for (const char* name : {"kinetic_energy", "rotational_energy", "potential_energy", "total_energy",
                           "momentum_x", "momentum_y", "angular_momentum", "numerical_drift", "impacts"}) {
    add(name);
  }
  const auto may_move = [](const Body& body) { return !body.fixed; };
  if (std::count_if(bodies.begin(), bodies.end(), may_move) <= kMostPaths) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!may_move(bodies[i])) continue;
      for (const char* name : {"x", "y", "angle", "velocity_x", "velocity_y", "spin"}) {
        add(name, {static_cast<int>(i)});
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
  return columns;
}

std::string csv_header(const std::vector<Quantity>& columns, const std::vector<Body>& bodies, char separator) {
  const auto name_of = [&](const Observable& observable, const std::vector<int>& of) {
    std::string name;
    for (const int body : of) name += bodies[static_cast<std::size_t>(body)].name + " ";
    return name + std::string(observable.name);
  };
  std::string line = "time [s]";
  for (const Quantity& column : columns) {
    std::string heading = name_of(*column.observable, column.bodies);
    if (!column.less.empty()) {
      heading += fmt::format(" - ({})", column.less.formula.text());
      if (column.less.x != nullptr) heading += ", x = " + name_of(*column.less.x, column.less.x_bodies);
    }
    std::string unit(column.observable->unit);
    for (std::size_t at; (at = unit.find("²")) != std::string::npos;)
      unit = fmt::format("{}^2{}", unit.substr(0, at), unit.substr(at + 2));
    line += separator;
    line += csv_field(fmt::format("{} [{}]", heading, unit), separator);
  }
  return line;
}

std::string csv_line(double time, std::span<const double> values, char separator) {
  std::string line = fmt::format("{}", time);
  for (const double value : values) {
    line += separator;
    if (!std::isnan(value)) line += fmt::format("{}", plain(value));
  }
  return line;
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
  std::string header =
      "time [s],body_a,body_b,point_x [m],point_y [m],normal_x [1],normal_y [1],normal_impulse [N s],"
      "tangential_impulse [N s],closing_speed [m/s],lost_to_restitution [J],lost_to_friction [J],"
      "lost_to_sticking [J]";
  std::replace(header.begin(), header.end(), ',', separator);
  return header;
}

std::string events_csv_line(const Simulation& s, const ImpactRecord& i, char separator) {
  std::string line = fmt::format("{}", i.time);
  for (const int body : {i.a, i.b}) {
    line += separator;
    line += csv_field(s.bodies()[static_cast<std::size_t>(body)].name, separator);
  }
  for (const double value :
       {i.point.x(), i.point.y(), i.normal.x(), i.normal.y(), i.normal_impulse, i.tangential_impulse,
        i.closing_speed, i.lost_to_restitution, i.lost_to_friction, i.lost_to_sticking}) {
    line += separator;
    line += fmt::format("{}", plain(value));
  }
  return line;
}

}  // namespace carom
