#include "tests/hard_cases/stress.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "physics/scene/method.h"
#include "physics/scene/validate.h"
#include "tests/hard_cases/stress_scenes.h"

namespace carom {
namespace {

// s of this thread alone, without the suite's other threads.
double cpu_time() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

std::vector<StressCase> stress_cases() {
  std::vector<StressCase> cases;
  for (const auto& theme : {stress::stacks(), stress::piles(), stress::friction(), stress::impacts(),
                            stress::rods(), stress::integrators()}) {
    cases.insert(cases.end(), theme.begin(), theme.end());
  }
  return cases;
}

std::vector<StressCase> stress_cases(const std::vector<std::string>& ids) {
  std::vector<StressCase> all = stress_cases();
  if (ids.empty()) return all;
  std::vector<StressCase> chosen;
  const auto named = [](const std::string& id) { return [&id](const StressCase& c) { return c.id == id; }; };
  for (const std::string& id : ids) {
    const auto found = std::find_if(all.begin(), all.end(), named(id));
    if (found == all.end()) {
      std::vector<std::string_view> known;
      for (const StressCase& c : all) known.push_back(c.id);
      throw SceneError(fmt::format("\"{}\": no such case; allowed: {}", shortened(id), fmt::join(known, ", ")));
    }
    if (std::find_if(chosen.begin(), chosen.end(), named(id)) == chosen.end()) chosen.push_back(*found);
  }
  return chosen;
}

StressVerdict verdict_of(double value, double limit) {
  if (std::isinf(limit)) return StressVerdict::kReportedOnly;
  return std::abs(value) <= limit ? StressVerdict::kWithin : StressVerdict::kBeyond;
}

StressSuite::StressSuite(std::vector<StressCase> cases, bool longer)
    : cases_(std::move(cases)), longer_(longer) {
  for (std::size_t c = 0; c < cases_.size(); ++c) {
    for (const double step : cases_[c].steps) {
      for (const IntegratorId integrator : cases_[c].integrators) {
        for (const bool refined : {false, true}) {
          Method method{.integrator = integrator,
                        .impacts = ImpactsId::kLocated,
                        .contacts = ContactsId::kLasting,
                        .step = refined ? step / 4.0 : step};
          runs_.push_back({c, method, refined, {}, 0.0});
        }
      }
    }
  }
}

void StressSuite::run(int index) {
  Run& r = runs_[static_cast<std::size_t>(index)];
  const double start = cpu_time();
  r.values = cases_[r.of].measure({r.method, longer_});
  r.cpu_time = cpu_time() - start;
}

std::vector<StressRow> StressSuite::rows() const {
  std::vector<StressRow> rows;
  for (std::size_t c = 0; c < cases_.size(); ++c) {
    for (std::size_t f = 0; f < cases_[c].figures.size(); ++f) {
      const StressFigure& figure = cases_[c].figures[f];
      for (const Run& r : runs_) {
        if (r.of != c) continue;
        const double limit = figure.limit_for != nullptr ? figure.limit_for(r.method) : figure.limit;
        rows.push_back({cases_[c].id, r.method, r.refined, figure, r.values[f], limit,
                        verdict_of(r.values[f], limit), r.cpu_time});
      }
    }
  }
  return rows;
}

}  // namespace carom
