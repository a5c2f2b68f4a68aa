#include "tests/fuzz/running.h"

#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/facts.h"

namespace carom::fuzz {
namespace {

// Fowler, Noll and Vo's hash, 64 bits, FNV-1a.
std::uint64_t hash(std::string_view bytes) {
  std::uint64_t h = 0xCBF29CE484222325U;
  for (const char c : bytes) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  return h;
}

template <class Table>
auto pick(const Table& table, Draws& draws) {
  return table[static_cast<std::size_t>(draws.below(static_cast<int>(table.size())))].id;
}

}  // namespace

Draws::Draws(std::string_view bytes) : random_(hash(bytes)) {}

std::optional<Preset> small_scene(std::string_view bytes) {
  constexpr double kSlowFrom = 20.0;
  try {
    Preset preset = parse_preset(bytes, "input");
    double bodies = static_cast<double>(preset.scene.bodies.size());
    for (const GridGenerator& g : preset.scene.generators) bodies += static_cast<double>(g.columns) * g.rows;
    if (bodies > kSlowFrom) return std::nullopt;
    return preset;
  } catch (const SceneError&) {
    return std::nullopt;
  }
}

Method draw_method(const Preset& preset, Draws& draws) {
  Method m = preset.method;
  m.integrator = pick(kIntegrators, draws);
  m.impacts = pick(kImpacts, draws);
  m.contacts = pick(kContacts, draws);
  if (why_not(preset.scene, m.integrator)) m.integrator = IntegratorId::kRk4;
  return m;
}

void checked_step(Simulation& run) {
  const double before = run.time();
  run.step();
  const State& s = run.state();
  if (!s.q.allFinite() || !s.v.allFinite() || !s.quadratures.allFinite())
    throw std::logic_error("the state is not finite");
  if (run.lost() ? run.time() != before : !(run.time() > before))
    throw std::logic_error("time and the state of being lost don't fit");
  const std::string status = run.status();
  if (status.empty() || status.find('\n') != std::string::npos)
    throw std::logic_error(fmt::format("the status is not one line: {}", status));
  for (const ImpactRecord& i : run.last_impacts()) {
    if (!std::isfinite(i.time) || !std::isfinite(i.normal_impulse) || !i.point.allFinite())
      throw std::logic_error("an impact is not finite");
  }
}

}  // namespace carom::fuzz
