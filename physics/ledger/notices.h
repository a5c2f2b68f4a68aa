#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "physics/model/index.h"

namespace carom {

struct NoticeEntry;

// Whom a notice is about: two bodies, or none.
struct NoticeBodies {
  BodyIndex a;
  BodyIndex b;
};

// Notices of a run, each an expected numerical outcome, never an error. Times in s of the first occurrence;
// negative: never.
struct Notices {
  // Bounces followed each other faster than the method resolves (Zeno); from then on inelastic impacts at
  // each step's end support the pair.
  double resting_since = -1.0;
  // Impacts that nothing presses followed each other faster than doubles can distinguish.
  double collapsed_since = -1.0;
  // The limit kMostImpactsPerStep was reached; the rest of that step was resolved at its end.
  double impacts_capped_since = -1.0;
  // The log is truncated; the impacts themselves were applied and counted.
  double log_cut_since = -1.0;
  // The adaptive integrator could not keep its tolerance with the shortest step.
  double tolerance_missed_since = -1.0;
  // A path curved too much for its step: the search for contacts on it was given up and may have missed one.
  double search_cut_since = -1.0;
  // Newton's law let impacts gain energy: `gained` J in total.
  double gained_since = -1.0;
  double gained = 0.0;
  // No impulses satisfied the law of simultaneous impacts; they were resolved pair by pair.
  double cluster_unsolved_since = -1.0;
  // The restitution of simultaneous impacts was lowered, so that they gain no energy from friction.
  double restitution_lowered_since = -1.0;
  // Contacts that closed at one time were resolved one after the other, for surfaces that stick or return slip.
  double order_decided_since = -1.0;
  // A step moved bodies so far that joints could not be restored after it, or turned joints by many radians.
  double joints_missed_since = -1.0;
  // Surfaces have static friction or rolling resistance, and the method has no contacts that last.
  double laws_of_rest_unused_since = -1.0;
  // The scene was changed after the run was saved: it continues from its bodies and its clock alone.
  double state_left_since = -1.0;
  // Springs or strings switched more often than a step follows.
  double switches_missed_since = -1.0;
  // The search for impacts used up the step's budget (StepWork); the rest was resolved at the step's end.
  double work_spent_since = -1.0;
  // The method itself has made three quarters of the kinetic energy.
  double energy_made_since = -1.0;
  // More pairs of bodies were near each other than BroadPhase::most_pairs(): the rest were ignored.
  double pairs_cut_since = -1.0;

  // Contact forces were left with a residual beyond rounding, at most `contacts_left` m/s.
  double contacts_left_since = -1.0;
  double contacts_left = 0.0;

  // Whom the first occurrence of each is about, in the order of notice_entries().
  static constexpr std::size_t kKinds = 18;
  std::array<NoticeBodies, kKinds> bodies{};

  // Keeps the time (s) and the bodies of the first occurrence.
  void note(double Notices::*since, double time, const NoticeBodies& of = {});

  // How people call a body; without it lines name none.
  using BodyName = std::function<std::string(BodyIndex)>;
  // One line with what happened and what the run does about it; "ok" without notices.
  [[nodiscard]] std::string text(const BodyName& name = {}) const;
  // The same in a few words each; empty without notices.
  [[nodiscard]] std::string brief(const BodyName& name = {}) const;

 private:
  [[nodiscard]] std::string line(std::string_view NoticeEntry::*text, const BodyName& name) const;
};

struct NoticeEntry {
  std::string_view key;    // in a saved state
  double Notices::*since;  // s
  std::string_view brief;  // {t}: the time; {n}: the number below
  std::string_view text;   // likewise
  double Notices::*number = nullptr;
  std::string_view number_key = {};
};

// In the order in which they are reported.
[[nodiscard]] std::span<const NoticeEntry> notice_entries();

}  // namespace carom
