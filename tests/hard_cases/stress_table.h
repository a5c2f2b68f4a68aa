#pragma once

#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "physics/scene/method.h"
#include "tests/hard_cases/stress.h"

// The rows of a stress suite as text.
namespace carom {

// "explicit-euler, located, lasting, 1/60 s".
[[nodiscard]] std::string method_text(const Method& method);
// "good", "fell short" or "reported".
[[nodiscard]] std::string_view name_of(StressVerdict verdict);

// Of all rows with a limit, those within it.
struct StressCount {
  int cases = 0;
  int bounded = 0;
  int within = 0;
};
[[nodiscard]] StressCount count_of(const std::vector<StressRow>& rows);
// "300 of 300 figures of 31 cases are within their limits."
[[nodiscard]] std::string count_text(const StressCount& count);

// CSV, RFC 4180, line by line: a header, then a line for each row, numbers with all their digits. The limit
// is empty for a figure that is only reported.
[[nodiscard]] std::vector<std::string> stress_csv(const std::vector<StressRow>& rows);

// One line of the printed table: a figure under one integrator at one step and at a quarter of it.
struct StressLine {
  std::string case_id;
  std::string figure;  // with its unit
  std::string method;
  std::string coarse;  // at the step
  std::string fine;    // at a quarter of it
  std::string change;  // fine over coarse
  std::string limit;   // that of the finer step in brackets, if it differs
  std::string verdict;
  std::string cpu_time;  // s, of both
  std::string peers;
};
// A heading, then the lines; `rows` in the order of StressSuite::rows().
[[nodiscard]] std::vector<StressLine> stress_lines(const std::vector<StressRow>& rows);

// The page figures.md, Markdown, line by line: a section for each case with the table of its rows, the
// source of its limits and the figures of peers. Without CPU times, so that the same program makes the same
// page again. `rows` in the order of StressSuite::rows() for `cases`.
[[nodiscard]] std::vector<std::string> stress_page(const std::vector<StressCase>& cases,
                                                   const std::vector<StressRow>& rows);

// Figure of another engine in the scene of a stress case, measured with its own program in the same set-up on
// one machine: Box2D 3.2 ("v3"; 4 sub-steps, single precision; "tuned" is stiffer: its contact stiffness
// raised, with 64 sub-steps at 480 Hz), Box2D 2.4.1 ("2.4"; 8 velocity and 3 position iterations) and
// Chipmunk 7.0.3 ("Cp"; 10 iterations), at 60 Hz unless the note says otherwise; sleeping off. The program
// carom_peers (tests/peers) measures those of 2.4 and Cp again.
struct StressPeer {
  std::string_view engine;
  double value = std::numeric_limits<double>::quiet_NaN();  // the figure's unit; infinite: it fell
  std::string_view note = {};                               // difference of the peer's set-up
};
struct StressPeers {
  std::string_view id;              // of the case
  std::string_view figure;          // its name there
  std::array<StressPeer, 4> peers;  // unused ones, at the end, have no engine
};
[[nodiscard]] std::span<const StressPeers> stress_peers();

// "v3 3.8*, 2.4 falls", the peers of one figure; a star marks a value smaller in size than `value`. Empty if
// there are none.
[[nodiscard]] std::string peers_text(std::string_view id, std::string_view figure, double value);

}  // namespace carom
