#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "physics/scene/method.h"
#include "physics/stress/stress.h"

// What the rows of a stress suite look like in words.
namespace carom {

// "explicit-euler, located, lasting, 1/60 s".
[[nodiscard]] std::string method_text(const Method& method);
// "good", "fell short" or "told".
[[nodiscard]] std::string_view name_of(StressVerdict verdict);

// Of all rows that have a limit, those within it.
struct StressCount {
  int cases = 0;
  int bounded = 0;
  int within = 0;
};
[[nodiscard]] StressCount count_of(const std::vector<StressRow>& rows);
// "300 of 300 figures of 31 cases are within their limits."
[[nodiscard]] std::string count_text(const StressCount& count);

// CSV, RFC 4180, line by line: a header, then a line for each row, numbers with all their digits. An empty
// limit is that of a figure which is only told.
[[nodiscard]] std::vector<std::string> stress_csv(const std::vector<StressRow>& rows);

// One line of the printed table: a figure under one integrator at one step and at a quarter of it.
struct StressLine {
  std::string case_id;
  std::string figure;  // with its unit
  std::string method;
  std::string coarse;  // at the step
  std::string fine;    // at a quarter of it
  std::string change;  // fine over coarse
  std::string limit;   // of the finer one in brackets, if it differs
  std::string verdict;
  std::string cpu_time;  // s, of both
  std::string peers;
};
// A heading, then the lines; `rows` as StressSuite::rows() gives them.
[[nodiscard]] std::vector<StressLine> stress_lines(const std::vector<StressRow>& rows);

// The help's page of figures, Markdown, line by line: a section for each case with the table of its rows, where
// its limits come from and what peers show. Without CPU times: the same program makes the same page again.
// `rows` as StressSuite::rows() gives them for `cases`.
[[nodiscard]] std::vector<std::string> stress_page(const std::vector<StressCase>& cases,
                                                   const std::vector<StressRow>& rows);

}  // namespace carom
