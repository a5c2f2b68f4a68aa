#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "physics/compare/reference_run.h"
#include "physics/observe/quantity.h"
#include "physics/record/replay.h"

namespace carom {

// What is to be written of a run: of so many of its steps the rows from `from` to `to` (s), at the steps' ends
// and before and after impacts; without columns all about each impact.
struct DataExport {
  RunLog log;
  std::vector<std::shared_ptr<const KeyFrame>> key_frames = {};  // moments to begin at
  ReferenceId reference = ReferenceId::kNone;                    // that errors are against
  std::int64_t steps = 0;
  std::vector<Quantity> columns;
  double from = 0.0;
  double to = 0.0;
};

// The first run after so many of its steps, at `time` (s); none if `progress`, told as below, answers false.
[[nodiscard]] std::optional<Simulation> run_at(const RunLog& log,
                                               const std::vector<std::shared_ptr<const KeyFrame>>& key_frames,
                                               double time, std::int64_t steps,
                                               const std::function<bool(double)>& progress);

// Writes a CSV file: RFC 4180, units in brackets in the header, every number with all its digits. The run is
// gone through once more, from its start or from the last key frame before `from`, so that a long past is as
// exact as the present. `progress` is told the share that is done, 0 to 1; where it answers false nothing is
// written, and the answer is false. Throws SceneError if the file cannot be written.
[[nodiscard]] bool export_data(const DataExport& what, const std::string& file,
                               const std::function<bool(double)>& progress);

// The same for the clipboard, with tabs between the fields, as spreadsheets take it. More than kMostCopied rows
// are no matter of a clipboard.
inline constexpr std::size_t kMostCopied = 100'000;
enum class Copied { kAll, kTooMany, kCancelled };
[[nodiscard]] Copied copy_data(const DataExport& what, std::string& text,
                               const std::function<bool(double)>& progress);

}  // namespace carom
