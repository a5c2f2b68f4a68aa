#include "tests/hard_cases/stress_table.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/files/csv.h"
#include "physics/scene/method.h"

namespace carom {
namespace {

// "1/240 s" if the step is one over a whole number.
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

// Ratio of the figure when the step is quartered: a method of order p leaves 1/4ᵖ of an error.
std::string change_text(double coarse, double fine) {
  if (std::isnan(coarse) || std::isnan(fine)) return "-";
  if (coarse == fine) return "same";
  if (coarse == 0.0) return "from 0";
  return fine == 0.0 ? "to 0" : fmt::format("× {:.2g}", fine / coarse);
}

std::string verdict_text(const StressRow& coarse, const StressRow& fine) {
  if (coarse.verdict == StressVerdict::kReportedOnly) return "reported";
  const bool at_step = coarse.verdict == StressVerdict::kWithin;
  const bool at_quarter = fine.verdict == StressVerdict::kWithin;
  if (at_step && at_quarter) return "good";
  return at_step ? "FELL SHORT at h/4" : at_quarter ? "FELL SHORT at h" : "FELL SHORT";
}

std::string sentence(std::string_view text) {
  std::string s = fmt::format("{}.", text);
  s[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(s[0])));
  return s;
}

// The source of a case's limits, and the peers' figures: a line for one figure, or for several in a row that
// share it.
void add_notes(const StressCase& of, const std::vector<StressRow>& rows, std::vector<std::string>& page) {
  std::string names;
  for (std::size_t f = 0; f < of.figures.size(); ++f) {
    const StressFigure& figure = of.figures[f];
    if (figure.limit_from.empty()) continue;
    names += fmt::format("{}*{}*", names.empty() ? "" : ", ", figure.name);
    if (f + 1 < of.figures.size() && of.figures[f + 1].limit_from == figure.limit_from) continue;
    page.push_back(fmt::format("- {}: {}", names, figure.limit_from));
    names.clear();
  }
  for (const StressFigure& figure : of.figures) {
    double largest = 0.0;
    for (const StressRow& r : rows) {
      if (r.id != of.id || r.figure.name != figure.name || r.refined) continue;
      // NaN stays NaN: every peer is better.
      if (!std::isnan(largest) && !(std::abs(r.value) <= largest)) largest = std::abs(r.value);
    }
    const std::string peers = peers_text(of.id, figure.name, largest);
    if (!peers.empty()) page.push_back(fmt::format("- peers, *{}*: {}", figure.name, peers));
  }
}

// A smaller difference between figures is rounding, in any unit here.
constexpr double kSame = 1e-12;
constexpr double kFalls = std::numeric_limits<double>::infinity();
constexpr double kStands = std::numeric_limits<double>::quiet_NaN();

constexpr auto kPeers = std::to_array<StressPeers>({
    {"stack-20", "sag of the top", {{{"v3", kStands, "stands"}, {"2.4", -180.0}, {"Cp", kFalls}}}},
    {"stack-20", "lean", {{{"2.4", 58.5, "at the top"}, {"Cp", kFalls}}}},
    {"stack-40", "sag of the top", {{{"v3", 540.0}, {"v3 tuned", 2.1}, {"2.4", kFalls}, {"Cp", kFalls}}}},
    {"stack-heavy-top",
     "sag of the top",
     {{{"v3", kFalls}, {"v3 tuned", 23.0}, {"2.4", kFalls}, {"Cp", kFalls}}}},
    {"mass-ratio", "sag of the top", {{{"2.4", kFalls}, {"Cp", kFalls}}}},
    {"pyramid-20", "sag of the top", {{{"v3", 29.0}, {"2.4", -257.0}, {"Cp", 40.0}}}},
    {"pyramid-20", "sideways drift of the top", {{{"v3", 2.3}, {"2.4", 5.6}, {"Cp", -11.0}}}},
    {"pyramid-20", "largest overlap", {{{"v3", 3.8}, {"2.4", kStands, "gaps of 14"}, {"Cp", 7.4}}}},
    // ½ of the squared rms speed, without rotation.
    {"pile",
     "kinetic energy per mass",
     {{{"v3", 3.2e-11, "after 10 s"}, {"2.4", 1.1e-4, "after 10 s"}, {"Cp", 8e-8, "after 10 s"}}}},
    {"pile",
     "largest overlap",
     {{{"v3", 39.0, "after 10 s"},
       {"v3 tuned", 4.1, "after 10 s"},
       {"2.4", 26.0, "after 10 s"},
       {"Cp", 100.0, "after 10 s"}}}},
    {"pile",
     "mean overlap",
     {{{"v3", 7.0, "after 10 s"},
       {"v3 tuned", 0.31, "after 10 s"},
       {"2.4", 7.0, "after 10 s"},
       {"Cp", 32.0, "after 10 s"}}}},
    {"incline-below",
     "creep in 60 s",
     {{{"v3", 3.9e-4, "10 s at 0.99"}, {"2.4", 1.1e-4, "10 s"}, {"Cp", 1.7e-3, "10 s"}}}},
    // From the distance in 10 s: 2.189 m, and 1.096 m at 1.005.
    {"incline-above", "error of the acceleration", {{{"v3", 2.3, "at 1.01"}, {"2.4", 1.7}, {"Cp", 3.2}}}},
    {"slide-to-roll", "error of the final speed", {{{"v3", -2e-3}, {"2.4", -1.5e-2}, {"Cp", 1.8e-15}}}},
    {"spinning-disc", "error of the final speed", {{{"2.4", 7.2e-3}, {"Cp", 1.3e-15}}}},
    {"bullet",
     "share of the bounces missed",
     {{{"v3", 0.98},
       {"2.4", kStands, "clamps to 2 m a step"},
       {"Cp", kStands, "leaves a wall of 0.1 m at 10 radii a step"}}}},
    {"cradle-5", "error of the last ball's speed", {{{"2.4", -0.557}, {"Cp", 0.0}}}},
    {"cradle-5", "relative change of the energy", {{{"v3", -0.44}, {"2.4", -4.9e-2}, {"Cp", 0.0}}}},
    {"overlapping-start", "largest speed gained", {{{"2.4", 0.0}, {"Cp", 0.0}}}},
    {"galperin",
     "impacts off 314",
     {{{"v3", -300.0, "1 kHz"}, {"2.4", -266.0, "1 kHz"}, {"Cp", 0.0, "1 kHz"}}}},
    {"gas",
     "relative change of the energy",
     {{{"v3", -6.3e-2, "10 s"}, {"2.4", -8.8e-7, "10 s"}, {"Cp", -5.5e-8, "10 s"}}}},
});

}  // namespace

std::span<const StressPeers> stress_peers() { return kPeers; }

std::string peers_text(std::string_view id, std::string_view figure, double value) {
  std::string text;
  const auto of = std::find_if(kPeers.begin(), kPeers.end(),
                               [&](const StressPeers& p) { return p.id == id && p.figure == figure; });
  if (of == kPeers.end()) return text;
  for (const StressPeer& p : of->peers) {
    if (p.engine.empty()) break;
    if (!text.empty()) text += ", ";
    text += p.engine;
    if (std::isinf(p.value)) text += " falls";
    if (std::isfinite(p.value)) text += fmt::format(" {:.3g}", p.value);
    if (std::isfinite(p.value) && !(std::abs(value) - std::abs(p.value) <= kSame)) text += '*';
    if (!p.note.empty())
      text += std::isnan(p.value) ? fmt::format(" {}", p.note) : fmt::format(" ({})", p.note);
  }
  return text;
}

std::string method_text(const Method& m) {
  return fmt::format("{}, {}, {}, {}", choice_of(kIntegrators, m.integrator).name,
                     choice_of(kImpacts, m.impacts).name, choice_of(kContacts, m.contacts).name,
                     step_text(m.step));
}

std::string_view name_of(StressVerdict verdict) {
  if (verdict == StressVerdict::kReportedOnly) return "reported";
  return verdict == StressVerdict::kWithin ? "good" : "fell short";
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

std::vector<std::string> stress_page(const std::vector<StressCase>& cases, const std::vector<StressRow>& rows) {
  std::vector<std::string> page = {
      "# The hard cases: figures",
      "",
      "What `carom_stress` showed last; `carom_stress --page F` writes this page anew. What the cases and the",
      "columns mean is explained in README.md.",
      "",
      count_text(count_of(rows)),
  };
  const std::vector<StressLine> lines = stress_lines(rows);
  for (const StressCase& c : cases) {
    page.insert(page.end(), {"", fmt::format("## {}", c.id), "", sentence(c.about), "",
                             "| figure | integrator, h | at h | at h/4 | change | limit | verdict |",
                             "|---|---|---:|---:|---:|---:|---|"});
    for (const StressLine& l : lines) {
      if (l.case_id != c.id) continue;
      page.push_back(fmt::format("| {} | {} | {} | {} | {} | {} | {} |", l.figure, l.method, l.coarse, l.fine,
                                 l.change, l.limit, l.verdict));
    }
    page.emplace_back();
    add_notes(c, rows, page);
  }
  return page;
}

}  // namespace carom
