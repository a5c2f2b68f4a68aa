#include "physics/stress/stress_page.h"

#include <cctype>
#include <cmath>
#include <fmt/format.h>

#include "physics/stress/stress_peers.h"
#include "physics/stress/stress_table.h"

namespace carom {
namespace {

std::string sentence(std::string_view text) {
  std::string s = fmt::format("{}.", text);
  s[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(s[0])));
  return s;
}

// Where the limits of a case come from, and what peers show: a line for each, told of one figure or of several
// in a row that share it.
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
      // What is no number stays so: every peer is better.
      if (!std::isnan(largest) && !(std::abs(r.value) <= largest)) largest = std::abs(r.value);
    }
    const std::string peers = peers_text(of.id, figure.name, largest);
    if (!peers.empty()) page.push_back(fmt::format("- peers, *{}*: {}", figure.name, peers));
  }
}

}  // namespace

std::vector<std::string> stress_page(const std::vector<StressCase>& cases, const std::vector<StressRow>& rows) {
  std::vector<std::string> page = {
      "# The hard cases: figures",
      "",
      "What `carom stress` showed last; `carom stress --page F` writes this page anew. What the cases and the",
      "columns are is told under *The hard cases*.",
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
