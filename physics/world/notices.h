#pragma once

#include <span>
#include <string>
#include <string_view>

namespace carom {

// What a run has to say about itself beside its numbers: each is an expected numerical outcome, never an error.
// Times in s, at which it first happened; negative: never.
struct Notices {
  // Bounces came to follow one another faster than the method resolves (Zeno); from there the pair is held by
  // inelastic impacts at the end of each step.
  double resting_since = -1.0;
  // Impacts without anything that presses came to follow one another faster than doubles can tell apart.
  double collapsed_since = -1.0;
  // The limit kMostImpactsPerStep was reached; the rest of that step was resolved at its end.
  double impacts_capped_since = -1.0;
  // A step had more impacts than the log keeps; they all happened, and are counted.
  double log_cut_since = -1.0;
  // The adaptive integrator could not keep its tolerance with the shortest step.
  double tolerance_missed_since = -1.0;
  // A path bent too fast for its step: the search for contacts on it was given up, one may have been missed.
  double search_cut_since = -1.0;
  // Newton's law let impacts gain energy, in J all together.
  double gained_since = -1.0;
  double gained = 0.0;
  // No impulses would have met the law of simultaneous impacts; they were taken pair by pair.
  double cluster_unsolved_since = -1.0;
  // The restitution of simultaneous impacts was lowered, so that friction would not make them gain energy.
  double restitution_lowered_since = -1.0;
  // A step led so far off that joints could not be restored after it, or turned joints by many radians.
  double joints_missed_since = -1.0;
  // The scene was changed after the run was saved: it goes on from its bodies and its clock alone.
  double state_left_since = -1.0;
  // Springs or strings switched more often than is followed in a step.
  double switches_missed_since = -1.0;
  // The search for impacts cost more than a step may (StepWork): what was left of them was resolved at its end.
  double work_spent_since = -1.0;
  // The method itself has made three quarters of the kinetic energy.
  double energy_made_since = -1.0;
  // More bodies lay within one another than BroadPhase::most_pairs() allows: the other pairs were left alone.
  double pairs_cut_since = -1.0;

  // Contact forces were left with a residual beyond rounding, at the most `contacts_left` m/s.
  double contacts_left_since = -1.0;
  double contacts_left = 0.0;

  // One line for people; "ok" if there is nothing to tell.
  [[nodiscard]] std::string text() const;
};

struct NoticeEntry {
  std::string_view key;    // in a saved state
  double Notices::*since;  // s
  std::string_view text;   // {t}: the time; {n}: the number below
  double Notices::*number = nullptr;
  std::string_view number_key = {};
};

// In the order in which they are told.
[[nodiscard]] std::span<const NoticeEntry> notice_entries();

}  // namespace carom
