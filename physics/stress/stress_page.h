#pragma once

#include <string>
#include <vector>

#include "physics/stress/stress.h"

namespace carom {

// The help's page of figures, Markdown, line by line: a section for each case with the table of its rows, where
// its limits come from and what peers show. Without CPU times: the same program makes the same page again.
// `rows` as StressSuite::rows() gives them for `cases`.
[[nodiscard]] std::vector<std::string> stress_page(const std::vector<StressCase>& cases,
                                                   const std::vector<StressRow>& rows);

}  // namespace carom
