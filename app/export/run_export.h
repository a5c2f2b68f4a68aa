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

// Selects the rows of a run: within its first `steps` steps those from `from` to `to` (s), at the steps' ends
// and before and after impacts; without columns, a row with all data of each impact.
struct DataExport {
  RunSetup setup;
  std::vector<std::shared_ptr<const KeyFrame>> key_frames = {};  // states to start from
  ReferenceId reference = ReferenceId::kNone;                    // for the errors
  std::int64_t steps = 0;
  std::vector<Quantity> columns;
  double from = 0.0;
  double to = 0.0;
};

// The run at `time` (s), which may lie within a step; none if `progress` (see below) returns false.
[[nodiscard]] std::optional<Simulation> run_at(const RunSetup& setup,
                                               const std::vector<std::shared_ptr<const KeyFrame>>& key_frames,
                                               double time, const std::function<bool(double)>& progress);

// Writes a CSV file: RFC 4180, units in brackets in the header, every number with all its digits. The run is
// replayed from its start or from the last key frame before `from`, so that old data are as exact as recent
// data. `progress` receives the completed share, 0 to 1; if it returns false nothing is written, and the
// function returns false. Throws SceneError if the file cannot be written.
[[nodiscard]] bool export_data(const DataExport& what, const std::string& file,
                               const std::function<bool(double)>& progress);

// The same for the clipboard, with tabs between the fields, for spreadsheets. Limited to kMostCopied rows.
inline constexpr std::size_t kMostCopied = 100'000;
enum class Copied { kAll, kTooMany, kCancelled };
[[nodiscard]] Copied copy_data(const DataExport& what, std::string& text,
                               const std::function<bool(double)>& progress);

}  // namespace carom
