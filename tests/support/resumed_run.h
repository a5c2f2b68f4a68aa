#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/validate.h"
#include "physics/world/run_state.h"
#include "physics/world/simulation.h"

// Compares a run with one that was saved, read again and continued.
namespace carom::test {

// Through a file's text, exact to the last bit.
inline Preset saved_and_read(const Preset& document, const Simulation& simulation) {
  return parse_preset(write_preset(saved_preset(document, simulation)), "saved");
}

// All that a run reports and all that it continues from: two runs with the same text are equal.
inline std::string all_of(const Preset& document, const Simulation& s) {
  std::string text = s.notices().text() + "\n";
  const auto bytes = [&](const auto& matrix) {
    text.append(reinterpret_cast<const char*>(matrix.data()), sizeof(double) * matrix.size());
  };
  bytes(s.state().q);
  bytes(s.state().v);
  bytes(s.state().quadratures);
  const Ledger ledger = s.ledger();
  text.append(reinterpret_cast<const char*>(&ledger), sizeof(ledger));
  try {
    text += write_preset(saved_preset(document, s));
  } catch (const SceneError& error) {
    text += error.what();  // it has blown up
  }
  return text;
}

inline std::string events_of(const Simulation& s) {
  std::string text;
  for (const ImpactRecord& i : s.last_impacts()) {
    const double numbers[] = {i.time,
                              static_cast<double>(i.a),
                              static_cast<double>(i.b),
                              i.point.x(),
                              i.point.y(),
                              i.normal.x(),
                              i.normal.y(),
                              i.normal_impulse,
                              i.tangential_impulse,
                              i.closing_speed,
                              i.lost_to_restitution,
                              i.lost_to_friction,
                              i.lost_to_sticking};
    text.append(reinterpret_cast<const char*>(numbers), sizeof(numbers));
  }
  return text;
}

// The first place where two texts differ, with both texts there.
inline std::string parting(const std::string& a, const std::string& b) {
  if (a == b) return {};
  std::size_t at = 0;
  while (at < a.size() && at < b.size() && a[at] == b[at]) ++at;
  const std::size_t from = at > 60 ? at - 60 : 0;
  const auto printable = [&](const std::string& text) {
    std::string part = text.substr(from, 160);
    for (char& c : part) {
      if (c < 0x20 || c > 0x7e) c = '.';
    }
    return part;
  };
  return "at " + std::to_string(at) + ": '" + printable(a) + "' and '" + printable(b) + "'";
}

}  // namespace carom::test
