#include "physics/world/notices.h"

#include <array>
#include <fmt/format.h>

#include "physics/world/step_limits.h"

namespace carom {
namespace {

using N = Notices;

const auto kEntries = std::to_array<NoticeEntry>({
    {"resting_since", &N::resting_since,
     "from t = {t:.6g} s bounces come faster than they can be told apart (Zeno): such a contact is held by "
     "inelastic "
     "impacts at each step's end"},
    {"collapsed_since", &N::collapsed_since,
     "collapse at t = {t:.6g} s: impacts follow one another faster than double precision can tell apart, and "
     "the "
     "bodies go on together"},
    {"impacts_capped_since", &N::impacts_capped_since,
     "at t = {t:.6g} s a step had more than {per_step} impacts, or {at_once} at one time ({corners} where "
     "corners "
     "meet): the rest of them was resolved at its end"},
    {"log_cut_since", &N::log_cut_since,
     "from t = {t:.6g} s a step has more impacts than the log keeps ({logged}); all of them are counted"},
    {"tolerance_missed_since", &N::tolerance_missed_since,
     "from t = {t:.6g} s the tolerance can't be kept, not with the shortest step"},
    {"search_cut_since", &N::search_cut_since,
     "from t = {t:.6g} s forces change too fast for the step: an impact may have been missed"},
    {"work_spent_since", &N::work_spent_since,
     "from t = {t:.6g} s the search for impacts takes more than a step may cost: what is left of them is "
     "resolved at "
     "each step's end"},
    {"energy_made_since", &N::energy_made_since,
     "from t = {t:.6g} s most of the kinetic energy is the method's own making: take shorter steps"},
    {"pairs_cut_since", &N::pairs_cut_since,
     "from t = {t:.6g} s more bodies lie within one another than are looked at in a step: some pairs were left "
     "alone"},
    {"gained_since", &N::gained_since,
     "from t = {t:.6g} s impacts gained energy, {n:.3g} J by now: Newton's law does so with friction off the "
     "centre",
     &N::gained, "gained"},
    {"cluster_unsolved_since", &N::cluster_unsolved_since,
     "at t = {t:.6g} s no impulses meet the law of simultaneous impacts: they were taken pair by pair"},
    {"restitution_lowered_since", &N::restitution_lowered_since,
     "at t = {t:.6g} s the restitution of simultaneous impacts was lowered, so that none gains energy"},
    {"contacts_left_since", &N::contacts_left_since,
     "from t = {t:.6g} s contact forces are not exact: they leave up to {n:.2g} m/s of what contacts forbid",
     &N::contacts_left, "contacts_left"},
    {"switches_missed_since", &N::switches_missed_since,
     "from t = {t:.6g} s springs or strings start and stop to act more often than is followed in a step"},
    {"links_missed_since", &N::joints_missed_since,
     "at t = {t:.6g} s a step was too long for the links, and what follows means nothing: take shorter steps"},
    {"state_left_since", &N::state_left_since,
     "the scene was changed after the run was saved: from t = {t:.6g} s it goes on from its bodies and its "
     "clock "
     "alone"},
});

}  // namespace

std::span<const NoticeEntry> notice_entries() { return kEntries; }

std::string Notices::text() const {
  std::string line;
  for (const NoticeEntry& entry : kEntries) {
    const double since = this->*entry.since;
    if (since < 0.0) continue;
    if (!line.empty()) line += "; ";
    line += fmt::format(fmt::runtime(entry.text), fmt::arg("t", since),
                        fmt::arg("n", entry.number != nullptr ? this->*entry.number : 0.0),
                        fmt::arg("per_step", kMostImpactsPerStep), fmt::arg("at_once", kMostImpactsAtOnce),
                        fmt::arg("corners", kMostCornersAtOnce), fmt::arg("logged", kMostLogged));
  }
  return line.empty() ? "ok" : line;
}

}  // namespace carom
