#include <fmt/format.h>
#include <stdexcept>

#include "physics/preset/preset.h"
#include "tests/fuzz/running.h"
#include "tests/fuzz/targets.h"

namespace carom::fuzz {
namespace {

// Another method, or one more body like an existing one, near it.
void edit(Simulation& run, const Preset& preset, Draws& draws) {
  const int what = draws.below(8);
  if (what < 2) {
    run.set_method(draw_method(preset, draws));
  } else if (what == 2 && !run.bodies().empty() && run.bodies().size() < 24) {
    Body body = run.bodies()[static_cast<std::size_t>(draws.below(static_cast<int>(run.bodies().size())))];
    body.name = fmt::format("{}+{}", body.name, run.bodies().size());
    body.position += Vec2(draws.between(-1, 1), draws.between(-1, 1));
    if (!has_infinite_mass(body)) body.velocity = {draws.between(-10, 10), draws.between(-10, 10)};
    run.apply({Add<Body>{body}});
  }
}

}  // namespace

// The same edits of the same scene give the same bytes, also through a copy on the way.
void try_edits(std::string_view bytes) {
  const std::optional<Preset> scene = small_scene(bytes);
  if (!scene) return;
  Simulation first(setup_of(*scene));
  Simulation second(setup_of(*scene));
  Draws of_first(bytes);
  Draws of_second(bytes);
  for (int k = 0; k < kMostSteps && first.time() < kMostTime && !first.lost(); ++k) {
    edit(first, *scene, of_first);
    edit(second, *scene, of_second);
    checked_step(first);
    if (k == kMostSteps / 4) second = Simulation(second);
    checked_step(second);
    if (first.state().q != second.state().q || first.state().v != second.state().v)
      throw std::logic_error("the same edits gave another run");
  }
}

}  // namespace carom::fuzz
