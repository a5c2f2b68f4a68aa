#include "physics/stress/stress_table.h"

#include <cmath>
#include <fmt/format.h>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/files/csv.h"
#include "physics/scene/method.h"
#include "physics/stress/stress_peers.h"

namespace carom {
namespace {

// 1/240 s, where it is one over a whole number.
std::string step_text(double step) {
  const double rate = std::round(1.0 / step);
  return std::abs(1.0 / step - rate) < 1e-9 * rate ? fmt::format("1/{:.0f} s", rate)
                                                   : fmt::format("{:.6g} s", step);
}

std::string figure(double value) {
  if (std::isnan(value)) return "-";
  return fmt::format("{:.3g}", value == 0.0 ? 0.0 : value);
}

std::string limit_text(double limit) { return std::isinf(limit) ? "-" : fmt::format("{:.3g}", limit); }

// How the figure changes with a quarter of the step: a method of order p leaves 1/4ᵖ of an error.
std::string change_text(double coarse, double fine) {
  if (std::isnan(coarse) || std::isnan(fine)) return "-";
  if (coarse == fine) return "same";
  if (coarse == 0.0) return "from 0";
  return fine == 0.0 ? "to 0" : fmt::format("× {:.2g}", fine / coarse);
}

std::string verdict_text(const StressRow& coarse, const StressRow& fine) {
  if (coarse.verdict == StressVerdict::kReportedOnly) return "told";
  const bool at_step = coarse.verdict == StressVerdict::kWithin;
  const bool at_quarter = fine.verdict == StressVerdict::kWithin;
  if (at_step && at_quarter) return "good";
  return at_step ? "FELL SHORT at h/4" : at_quarter ? "FELL SHORT at h" : "FELL SHORT";
}

}  // namespace

std::string method_text(const Method& m) {
  return fmt::format("{}, {}, {}, {}", choice_of(kIntegrators, m.integrator).name,
                     choice_of(kImpacts, m.impacts).name, choice_of(kContacts, m.contacts).name,
                     step_text(m.step));
}

std::string_view name_of(StressVerdict verdict) {
  switch (verdict) {
    case StressVerdict::kWithin:
      return "good";
    case StressVerdict::kBeyond:
      return "fell short";
    case StressVerdict::kReportedOnly:
      return "told";
  }
  return "";
}

StressCount count_of(const std::vector<StressRow>& rows) {
  StressCount count;
  std::string_view id;
  for (const StressRow& r : rows) {
    if (r.id != id) ++count.cases;
    id = r.id;
    if (r.verdict == StressVerdict::kReportedOnly) continue;
    ++count.bounded;
    if (r.verdict == StressVerdict::kWithin) ++count.within;
  }
  return count;
}

std::string count_text(const StressCount& count) {
  return fmt::format("{} of {} figures of {} case{} are within their limits.", count.within, count.bounded,
                     count.cases, count.cases == 1 ? "" : "s");
}

std::vector<std::string> stress_csv(const std::vector<StressRow>& rows) {
  std::vector<std::string> lines = {
      "case,method,figure,unit,limit,verdict,figure_name,limit_from,peers,cpu_time [s]"};
  for (const StressRow& r : rows) {
    CsvLine line;
    line.add(r.id).add(method_text(r.method)).add_field(csv_number(r.value)).add(r.figure.unit);
    line.add_field(std::isinf(r.limit) ? std::string() : csv_number(r.limit)).add(name_of(r.verdict));
    line.add(r.figure.name).add(r.figure.limit_from);
    line.add(peers_text(r.id, r.figure.name, r.value)).add(r.cpu_time);
    lines.push_back(line.text());
  }
  return lines;
}

std::vector<StressLine> stress_lines(const std::vector<StressRow>& rows) {
  std::vector<StressLine> lines = {{"case", "figure", "integrator, h", "at h", "at h/4", "change", "limit",
                                    "verdict", "CPU time [s]", "peers (* better than here)"}};
  for (std::size_t i = 0; i + 1 < rows.size(); i += 2) {
    const StressRow& coarse = rows[i];
    const StressRow& fine = rows[i + 1];
    StressLine line;
    line.case_id = coarse.id;
    line.figure = coarse.figure.unit == "1" ? std::string(coarse.figure.name)
                                            : fmt::format("{} [{}]", coarse.figure.name, coarse.figure.unit);
    line.method = fmt::format("{}, {}", choice_of(kIntegrators, coarse.method.integrator).name,
                              step_text(coarse.method.step));
    line.coarse = figure(coarse.value);
    line.fine = figure(fine.value);
    line.change = change_text(coarse.value, fine.value);
    line.limit = limit_text(coarse.limit);
    if (fine.limit != coarse.limit) line.limit += fmt::format(" ({})", limit_text(fine.limit));
    line.verdict = verdict_text(coarse, fine);
    line.cpu_time = fmt::format("{:.2f} {:.2f}", coarse.cpu_time, fine.cpu_time);
    line.peers = peers_text(coarse.id, coarse.figure.name, coarse.value);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace carom
