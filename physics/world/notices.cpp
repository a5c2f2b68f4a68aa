#include <array>
#include <fmt/format.h>

#include "physics/world/simulation.h"

namespace carom {

std::string Notices::text() const {
  struct Entry {
    double since;
    std::string what;
  };
  const std::string gain = fmt::format(
      "from t = {{:.6g}} s impacts gained energy, {:.3g} J by now: Newton's law does so with friction off the "
      "centre",
      gained);
  const std::string left = fmt::format(
      "from t = {{:.6g}} s contact forces are not exact: they leave up to {:.2g} m/s of what contacts forbid",
      contacts_left);
  const std::array entries = {
      Entry{
          resting_since,
          "from t = {:.6g} s bounces come faster than they can be told apart (Zeno): such a contact is held by "
          "inelastic impacts at each step's end"},
      Entry{collapsed_since,
            "collapse at t = {:.6g} s: impacts follow one another faster than double precision can "
            "tell "
            "apart, and the bodies go on together"},
      Entry{impacts_capped_since, "at t = {:.6g} s a step had more than " +
                                      std::to_string(Simulation::kMostImpactsPerStep) + " impacts, or " +
                                      std::to_string(Simulation::kMostImpactsAtOnce) + " at one time (" +
                                      std::to_string(Simulation::kMostCornersAtOnce) +
                                      " where corners meet): the rest of them was resolved at its end"},
      Entry{log_cut_since, "from t = {:.6g} s a step has more impacts than the log keeps (" +
                               std::to_string(Simulation::kMostLogged) + "); all of them are counted"},
      Entry{tolerance_missed_since,
            "from t = {:.6g} s the tolerance can't be kept, not with the shortest step"},
      Entry{search_cut_since,
            "from t = {:.6g} s forces change too fast for the step: an impact may have been missed"},
      Entry{work_spent_since,
            "from t = {:.6g} s the search for impacts takes more than a step may cost: what is left of them is "
            "resolved at each step's end"},
      Entry{energy_made_since,
            "from t = {:.6g} s most of the kinetic energy is the method's own making: take shorter "
            "steps"},
      Entry{
          pairs_cut_since,
          "from t = {:.6g} s more bodies lie within one another than are looked at in a step: some pairs were "
          "left alone"},
      Entry{gained_since, gain},
      Entry{cluster_unsolved_since,
            "at t = {:.6g} s no impulses meet the law of simultaneous impacts: they were taken pair by pair"},
      Entry{restitution_lowered_since,
            "at t = {:.6g} s the restitution of simultaneous impacts was lowered, so that none gains energy"},
      Entry{contacts_left_since, left},
      Entry{switches_missed_since,
            "from t = {:.6g} s springs or strings start and stop to act more often than is followed in a step"},
      Entry{links_missed_since,
            "at t = {:.6g} s a step was too long for the links, and what follows means nothing: take shorter "
            "steps"},
      Entry{
          state_left_since,
          "the scene was changed after the run was saved: from t = {:.6g} s it goes on from its bodies and its "
          "clock alone"},
  };
  std::string line;
  for (const Entry& entry : entries) {
    if (entry.since < 0.0) continue;
    if (!line.empty()) line += "; ";
    line += fmt::format(fmt::runtime(entry.what), entry.since);
  }
  return line.empty() ? "ok" : line;
}

}  // namespace carom
