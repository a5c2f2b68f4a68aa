#pragma once

#include <string>

#include "physics/study/study_table.h"

namespace carom {

// Sentences about a study, for the terminal and the picture alike, without a full stop.

// The compared time, and how long the run was meant to be.
[[nodiscard]] std::string compared_text(const StudyFacts& facts);
// The reference, its own error, and what the file states.
[[nodiscard]] std::string reference_text(const StudyFacts& facts);
// How neighbours part, and up to when a comparison means anything.
[[nodiscard]] std::string horizon_text(const StudyFacts& facts);

// The whole study as a table for each method, then the orders.
[[nodiscard]] std::string study_text(const StudyTable& table);

}  // namespace carom
