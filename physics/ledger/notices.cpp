#include "physics/ledger/notices.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "physics/ledger/step_limits.h"

namespace carom {
namespace {

using N = Notices;

const auto kEntries = std::to_array<NoticeEntry>({
    {"resting_since", &N::resting_since, "rests from t = {t:.4g} s: the bounces were too small to follow",
     "from t = {t:.6g} s bounces follow faster than the method resolves (Zeno): inelastic impacts at each "
     "step's end support such a contact"},
    {"collapsed_since", &N::collapsed_since,
     "bodies stay together from t = {t:.4g} s: the bounces were too small to follow",
     "inelastic collapse at t = {t:.6g} s: impacts follow faster than double precision resolves, and the "
     "bodies "
     "stay together"},
    {"impacts_capped_since", &N::impacts_capped_since,
     "many impacts at once at t = {t:.4g} s: some were taken at the end of the step",
     "at t = {t:.6g} s a step had more than {per_step} impacts, or {at_once} at one time ({corners} between "
     "corners): the others were resolved at the step's end"},
    {"log_cut_since", &N::log_cut_since, "too many impacts to list from t = {t:.4g} s",
     "from t = {t:.6g} s a step has more impacts than the log holds ({logged}); all of them are applied and "
     "counted"},
    {"tolerance_missed_since", &N::tolerance_missed_since, "the tolerance is missed from t = {t:.4g} s",
     "from t = {t:.6g} s the tolerance is missed even with the shortest step"},
    {"search_cut_since", &N::search_cut_since, "impacts may be missed from t = {t:.4g} s: take shorter steps",
     "from t = {t:.6g} s forces change too fast for the step: impacts may be missed"},
    {"work_spent_since", &N::work_spent_since,
     "many impacts from t = {t:.4g} s: some are taken at the end of the step",
     "from t = {t:.6g} s the search for impacts exceeds the budget of a step: the remaining impacts are "
     "resolved "
     "at each step's end"},
    {"energy_made_since", &N::energy_made_since,
     "energy comes from the method's error from t = {t:.4g} s: take shorter steps",
     "from t = {t:.6g} s most of the kinetic energy comes from the method's error: take shorter steps"},
    {"pairs_cut_since", &N::pairs_cut_since, "too many overlaps from t = {t:.4g} s: some are ignored",
     "from t = {t:.6g} s more pairs of bodies overlap than a step considers: the others are ignored"},
    {"gained_since", &N::gained_since, "impacts gained {n:.3g} J by Newton's law with friction",
     "from t = {t:.6g} s impacts gained energy, {n:.3g} J so far: Newton's law allows this in eccentric "
     "impacts "
     "with friction",
     &N::gained, "gained"},
    {"cluster_unsolved_since", &N::cluster_unsolved_since,
     "simultaneous impacts at t = {t:.4g} s were taken one by one",
     "at t = {t:.6g} s no impulses satisfy the law of simultaneous impacts: they were resolved pair by pair"},
    {"restitution_lowered_since", &N::restitution_lowered_since,
     "e was lowered at t = {t:.4g} s, so that no impact gains energy",
     "at t = {t:.6g} s the restitution of simultaneous impacts was lowered so that none gains energy"},
    {"order_decided_since", &N::order_decided_since,
     "impacts at t = {t:.4g} s were taken in the order of the bodies",
     "at t = {t:.6g} s a body met several others at once: as surfaces stick or return slip, the impacts were "
     "resolved one after the other, in the order of the bodies"},
    {"contacts_left_since", &N::contacts_left_since, "contact forces are approximate from t = {t:.4g} s",
     "from t = {t:.6g} s contact forces are approximate: their residual is up to {n:.2g} m/s",
     &N::contacts_left, "contacts_left"},
    {"switches_missed_since", &N::switches_missed_since,
     "springs or strings switch too often from t = {t:.4g} s: take shorter steps",
     "from t = {t:.6g} s springs or strings switch more often than a step follows"},
    {"links_missed_since", &N::joints_missed_since,
     "the step was too long for the links at t = {t:.4g} s: take shorter steps",
     "at t = {t:.6g} s a step was too long for the links, and later results are meaningless: take shorter "
     "steps"},
    {"laws_of_rest_unused_since", &N::laws_of_rest_unused_since,
     "static friction and rolling have no effect: choose contacts that last",
     "from t = {t:.6g} s static friction and rolling resistance have no effect under impulses only: choose "
     "contacts that last"},
    {"state_left_since", &N::state_left_since, "the scene was changed after this run was saved",
     "the scene was changed after the run was saved: from t = {t:.6g} s it continues from its bodies and its "
     "clock alone"},
});

static_assert(kEntries.size() == Notices::kKinds);

// "" or " (A and B)".
std::string named(const NoticeBodies& of, const Notices::BodyName& name) {
  return name && of.a >= 0 ? fmt::format(" ({} and {})", name(of.a), name(of.b)) : std::string();
}

}  // namespace

std::span<const NoticeEntry> notice_entries() { return kEntries; }

void Notices::note(double Notices::*since, double time, const NoticeBodies& of) {
  if (this->*since >= 0.0) return;
  this->*since = time;
  const auto entry = std::find_if(kEntries.begin(), kEntries.end(),
                                  [&](const NoticeEntry& each) { return each.since == since; });
  const auto [a, b] = std::minmax(of.a, of.b);
  bodies[static_cast<std::size_t>(entry - kEntries.begin())] = {a, b};
}

std::string Notices::line(std::string_view NoticeEntry::*text, const BodyName& name) const {
  std::string line;
  for (std::size_t i = 0; i < kEntries.size(); ++i) {
    const NoticeEntry& entry = kEntries[i];
    const double since = this->*entry.since;
    if (since < 0.0) continue;
    if (!line.empty()) line += "; ";
    line += fmt::format(fmt::runtime(entry.*text), fmt::arg("t", since),
                        fmt::arg("n", entry.number != nullptr ? this->*entry.number : 0.0),
                        fmt::arg("per_step", kMostImpactsPerStep), fmt::arg("at_once", kMostImpactsAtOnce),
                        fmt::arg("corners", kMostCornersAtOnce), fmt::arg("logged", kMostLogged));
    line += named(bodies[i], name);
  }
  return line;
}

std::string Notices::text(const BodyName& name) const {
  std::string line = this->line(&NoticeEntry::text, name);
  return line.empty() ? "ok" : line;
}

std::string Notices::brief(const BodyName& name) const { return line(&NoticeEntry::brief, name); }

}  // namespace carom
