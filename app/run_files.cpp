#include "app/run_files.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <system_error>

#include "physics/scene/validate.h"

namespace carom {
namespace {

bool with_paths(const Simulation& s) {
  return std::count_if(s.bodies().begin(), s.bodies().end(), [](const Body& b) { return !b.fixed; }) <=
         kMostPaths;
}

// Never "-0", which a law leaves where nothing happened.
double plain(double value) { return value == 0.0 ? 0.0 : value; }

}  // namespace

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
  return out;
}

TextFile::TextFile(const std::string& name)
    : name_(name), out_(name + ".part", std::ios::binary | std::ios::trunc) {
  if (!out_)
    throw SceneError(
        fmt::format("{}: the file cannot be written; allowed: a place with the right to write", name));
}

TextFile::~TextFile() {
  if (finished_) return;
  out_.close();
  std::error_code ignored;
  std::filesystem::remove(name_ + ".part", ignored);
}

void TextFile::line(const std::string& text) { out_ << text << '\n'; }

void TextFile::finish() {
  out_.close();
  std::error_code error;
  if (out_) std::filesystem::rename(name_ + ".part", name_, error);
  if (!out_ || error)
    throw SceneError(fmt::format("{}: the file could not be written; allowed: a place with room", name_));
  finished_ = true;
}

std::string run_csv_header(const Simulation& s) {
  std::string line =
      "time [s],kinetic_energy [J],rotational_energy [J],potential_energy [J],total_energy [J],momentum_x [N "
      "s],"
      "momentum_y [N s],angular_momentum [kg m^2/s],numerical_drift [J],impacts [1]";
  for (const Body& b : s.bodies()) {
    if (b.fixed || !with_paths(s)) continue;
    for (const char* what :
         {"x [m]", "y [m]", "angle [rad]", "velocity_x [m/s]", "velocity_y [m/s]", "spin [rad/s]"}) {
      line += fmt::format(",{}", csv_field(fmt::format("{} {}", b.name, what)));
    }
  }
  return line +
         ",lost_to_restitution [J],lost_to_friction [J],lost_to_rolling [J],lost_to_sticking [J],"
         "lost_to_drag [J],lost_to_dampers [J],lost_to_links [J],put_in_by_drives [J],put_in_by_user [J],"
         "overlap_correction [J],momentum_drift_x [N s],momentum_drift_y [N s],momentum_to_walls_x [N "
         "s],momentum_to_walls_y [N s]";
}

std::string run_csv_line(const Simulation& s) {
  const Totals t = s.totals();
  const Ledger l = s.ledger();
  std::string line = fmt::format("{},{},{},{},{},{},{},{},{},{}", s.time(), t.kinetic(), t.rotational,
                                 t.potential, t.energy(), t.momentum.x(), t.momentum.y(), t.angular_momentum,
                                 l.numerical_drift(t.energy()), s.impact_count());
  const bool paths = with_paths(s);
  for (int i = 0; i < s.state().size(); ++i) {
    if (s.bodies()[i].fixed || !paths) continue;
    for (int row = 0; row < 3; ++row) line += fmt::format(",{}", s.state().q(row, i));
    for (int row = 0; row < 3; ++row) line += fmt::format(",{}", s.state().v(row, i));
  }
  const Vec2 drift = l.momentum_drift(t.momentum);
  for (const double value :
       {l.lost_to_restitution, l.lost_to_friction, l.lost_to_rolling, l.lost_to_sticking, l.lost_to_drag,
        l.lost_to_dampers, l.lost_to_links, l.put_in_by_drives, l.put_in_by_user, l.overlap_correction,
        drift.x(), drift.y(), l.momentum_to_walls.x(), l.momentum_to_walls.y()}) {
    line += fmt::format(",{}", plain(value));
  }
  return line;
}

std::string events_csv_header() {
  return "time [s],body_a,body_b,point_x [m],point_y [m],normal_x [1],normal_y [1],normal_impulse [N s],"
         "tangential_impulse [N s],closing_speed [m/s],lost_to_restitution [J],lost_to_friction [J],"
         "lost_to_sticking [J]";
}

std::string events_csv_line(const Simulation& s, const ImpactRecord& i) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}", i.time, csv_field(s.bodies()[i.a].name),
                     csv_field(s.bodies()[i.b].name), plain(i.point.x()), plain(i.point.y()),
                     plain(i.normal.x()), plain(i.normal.y()), plain(i.normal_impulse),
                     plain(i.tangential_impulse), plain(i.closing_speed), plain(i.lost_to_restitution),
                     plain(i.lost_to_friction), plain(i.lost_to_sticking));
}

}  // namespace carom
