#include "tests/hard_cases/stress.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <set>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/scene/validate.h"
#include "tests/hard_cases/stress_table.h"
#include "tests/support/source_folder.h"

namespace carom {
namespace {

constexpr StressFigure kFigures[] = {
    {"twice the step", "s", 0.5, "theory: a limit with, a comma"},
    {"the step", "s", kNoLimit, "theory", [](const Method& m) { return m.step; }},
    {"a number", "1"},
    {"nothing", "1", 1.0, "theory"},
};
std::vector<double> measured(const StressSetting& s) {
  return {2.0 * s.method.step, s.method.step, s.longer ? 7.0 : 5.0, std::nan("")};
}
constexpr double kSteps[] = {0.5};
const StressCase kMade = {"made-up", "for this test", measured, kFigures, kEulerAndRk4, kSteps};

std::vector<StressRow> rows_of(const std::vector<StressCase>& cases, bool longer = false) {
  StressSuite suite(cases, longer);
  for (int i = suite.runs(); i > 0; --i) suite.run(i - 1);
  return suite.rows();
}

TEST(Stress, TheTableOfCasesIsWellFormed) {
  const std::vector<StressCase> cases = stress_cases();
  EXPECT_GE(cases.size(), 28U);
  std::set<std::string_view> ids;
  for (const StressCase& c : cases) {
    SCOPED_TRACE(c.id);
    EXPECT_TRUE(ids.insert(c.id).second);
    EXPECT_EQ(c.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string_view::npos);
    EXPECT_FALSE(c.about.empty());
    EXPECT_NE(c.measure, nullptr);
    EXPECT_FALSE(c.figures.empty());
    EXPECT_FALSE(c.integrators.empty());
    for (const double h : c.steps) EXPECT_TRUE(h / 4.0 >= kLeastStep && h <= kLargestStep) << h;
    std::set<std::string_view> names;
    for (const StressFigure& f : c.figures) {
      SCOPED_TRACE(f.name);
      EXPECT_TRUE(names.insert(f.name).second);
      EXPECT_FALSE(f.unit.empty());
      const bool bounded = std::isfinite(f.limit) || f.limit_for != nullptr;
      EXPECT_EQ(f.limit_from.starts_with("theory: ") || f.limit_from.starts_with("peer: "), bounded)
          << f.limit_from;
      if (!bounded) continue;
      for (const IntegratorId integrator : c.integrators) {
        const Method method{.integrator = integrator, .step = c.steps[0]};
        const double limit = f.limit_for != nullptr ? f.limit_for(method) : f.limit;
        EXPECT_TRUE(std::isfinite(limit) && limit >= 0.0) << limit;
      }
    }
  }
}

TEST(Stress, PeersStandBesideAFigureThatIsThere) {
  const std::vector<StressCase> cases = stress_cases();
  for (const StressPeers& p : stress_peers()) {
    const auto of = std::find_if(cases.begin(), cases.end(), [&](const StressCase& c) { return c.id == p.id; });
    ASSERT_NE(of, cases.end()) << p.id;
    EXPECT_TRUE(std::any_of(of->figures.begin(), of->figures.end(),
                            [&](const StressFigure& f) { return f.name == p.figure; }))
        << p.id << ": " << p.figure;
    for (const StressPeer& peer : p.peers)
      EXPECT_TRUE(peer.engine.empty() || !std::isnan(peer.value) || !peer.note.empty())
          << p.id << ": " << peer.engine << " says nothing";
  }
}

TEST(Stress, APeerThatIsBetterHasAStar) {
  EXPECT_EQ(peers_text("stack-40", "sag of the top", 3.0), "v3 540, v3 tuned 2.1*, 2.4 falls, Cp falls");
  EXPECT_EQ(peers_text("stack-40", "sag of the top", -1.0), "v3 540, v3 tuned 2.1, 2.4 falls, Cp falls");
  EXPECT_EQ(peers_text("cradle-5", "relative change of the energy", std::nan("")),
            "v3 -0.44*, 2.4 -0.049*, Cp 0*");
  EXPECT_EQ(peers_text("galperin", "impacts off 314", 0.0), "v3 -300 (1 kHz), 2.4 -266 (1 kHz), Cp 0 (1 kHz)");
  EXPECT_EQ(peers_text("spinning-disc", "error of the final speed", 2e-15), "2.4 0.0072, Cp 1.3e-15");
  EXPECT_EQ(peers_text("cradle-5", "largest speed of the others", 1.0), "");
}

TEST(Stress, CasesAreChosenByTheirIds) {
  EXPECT_EQ(stress_cases({}).size(), stress_cases().size());
  const std::vector<StressCase> two = stress_cases({"galperin", "arch", "galperin"});
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0].id, "galperin");
  EXPECT_EQ(two[1].id, "arch");
  try {
    (void)stress_cases({"arch", "bridge"});
    FAIL() << "no case is called bridge";
  } catch (const SceneError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("\"bridge\""), std::string::npos) << text;
    for (const StressCase& c : stress_cases()) EXPECT_NE(text.find(c.id), std::string::npos) << text;
  }
}

TEST(Stress, AFigureBeyondItsLimitFallsShort) {
  EXPECT_EQ(verdict_of(1.0, 1.0), StressVerdict::kWithin);
  EXPECT_EQ(verdict_of(-1.0, 1.0), StressVerdict::kWithin);
  EXPECT_EQ(verdict_of(-1.1, 1.0), StressVerdict::kBeyond);
  EXPECT_EQ(verdict_of(1e-300, 0.0), StressVerdict::kBeyond);
  EXPECT_EQ(verdict_of(std::nan(""), 1.0), StressVerdict::kBeyond);
  EXPECT_EQ(verdict_of(std::nan(""), kNoLimit), StressVerdict::kReportedOnly);
  EXPECT_EQ(verdict_of(std::numeric_limits<double>::infinity(), 1.0), StressVerdict::kBeyond);
}

TEST(Stress, EachCaseRunsUnderItsMethodsAtAStepAndAQuarter) {
  const std::vector<StressRow> rows = rows_of({kMade});
  ASSERT_EQ(rows.size(), 16U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const StressRow& r = rows[i];
    SCOPED_TRACE(fmt::format("row {}", i));
    EXPECT_EQ(r.id, "made-up");
    EXPECT_EQ(r.figure.name, kFigures[i / 4].name);
    EXPECT_EQ(r.method.integrator, i % 4 < 2 ? IntegratorId::kExplicitEuler : IntegratorId::kRk4);
    EXPECT_EQ(r.method.impacts, ImpactsId::kLocated);
    EXPECT_EQ(r.method.contacts, ContactsId::kLasting);
    EXPECT_EQ(r.refined, i % 2 == 1);
    EXPECT_EQ(r.method.step, i % 2 == 1 ? 0.125 : 0.5);
  }
  EXPECT_EQ(rows[0].verdict, StressVerdict::kBeyond);  // 1 s of 0.5 s
  EXPECT_EQ(rows[1].verdict, StressVerdict::kWithin);  // 0.25 s
  EXPECT_EQ(rows[5].limit, 0.125);
  EXPECT_EQ(rows[5].verdict, StressVerdict::kWithin);
  EXPECT_EQ(rows[8].verdict, StressVerdict::kReportedOnly);
  EXPECT_EQ(rows[8].value, 5.0);
  EXPECT_EQ(rows[12].verdict, StressVerdict::kBeyond);  // no number
  EXPECT_EQ(rows_of({kMade}, true)[8].value, 7.0);
}

TEST(Stress, CsvHasItsColumnsAndAllDigits) {
  const std::vector<std::string> lines = stress_csv(rows_of({kMade}));
  ASSERT_EQ(lines.size(), 17U);
  EXPECT_TRUE(lines[0].starts_with("case,method,figure,unit,limit,verdict,")) << lines[0];
  EXPECT_TRUE(
      lines[1].starts_with("made-up,\"explicit-euler, located, lasting, 1/2 s\",1,s,0.5,fell short,"
                           "twice the step,\"theory: a limit with, a comma\",,"))
      << lines[1];
  EXPECT_TRUE(lines[4].starts_with("made-up,\"rk4, located, lasting, 1/8 s\",0.25,s,0.5,good,")) << lines[4];
  EXPECT_TRUE(
      lines[9].starts_with("made-up,\"explicit-euler, located, lasting, 1/2 s\",5,1,,reported,a number,,,"))
      << lines[9];
  EXPECT_TRUE(lines[13].find(",nan,1,1,fell short,nothing,") != std::string::npos) << lines[13];
}

TEST(Stress, LinesShowTheChangeByAQuarterOfTheStep) {
  const std::vector<StressLine> lines = stress_lines(rows_of({kMade}));
  ASSERT_EQ(lines.size(), 9U);
  EXPECT_EQ(lines[0].case_id, "case");
  EXPECT_EQ(lines[1].figure, "twice the step [s]");
  EXPECT_EQ(lines[1].method, "explicit-euler, 1/2 s");
  EXPECT_EQ(lines[1].coarse, "1");
  EXPECT_EQ(lines[1].fine, "0.25");
  EXPECT_EQ(lines[1].change, "× 0.25");
  EXPECT_EQ(lines[1].verdict, "FELL SHORT at h");
  EXPECT_EQ(lines[3].limit, "0.5 (0.125)");
  EXPECT_EQ(lines[3].verdict, "good");
  EXPECT_EQ(lines[5].change, "same");
  EXPECT_EQ(lines[5].limit, "-");
  EXPECT_EQ(lines[5].verdict, "reported");
  EXPECT_EQ(lines[7].coarse, "-");
  EXPECT_EQ(lines[7].verdict, "FELL SHORT");
}

TEST(Stress, ThePageHasASectionForEachCase) {
  const std::vector<StressCase> cases = {kMade, stress_cases({"galperin"})[0]};
  const std::vector<std::string> page = stress_page(cases, rows_of(cases));
  const auto holds = [&](const std::string& line) {
    return std::find(page.begin(), page.end(), line) != page.end();
  };
  EXPECT_EQ(page[0], "# The hard cases: figures");
  EXPECT_TRUE(holds("14 of 20 figures of 2 cases are within their limits."));
  EXPECT_TRUE(holds("## made-up") && holds("For this test.") && holds("## galperin"));
  EXPECT_TRUE(
      holds("| twice the step [s] | explicit-euler, 1/2 s | 1 | 0.25 | × 0.25 | 0.5 | FELL SHORT at h |"));
  EXPECT_TRUE(holds("| impacts off 314 | rk4, 1/60 s | 0 | 0 | same | 0 | good |"));
  EXPECT_TRUE(holds("- *twice the step*: theory: a limit with, a comma"));
  EXPECT_TRUE(holds("- peers, *impacts off 314*: v3 -300 (1 kHz), 2.4 -266 (1 kHz), Cp 0 (1 kHz)"));
}

// The program writes the page of figures, which must have every case and every figure.
TEST(Stress, ThePageThatIsKeptHasAllFiguresAndNoneFellShort) {
  std::ifstream file(test::source("tests/hard_cases/figures.md"));
  const std::string page(std::istreambuf_iterator<char>(file), {});
  const auto holds = [&](const std::string& part) { return page.find(part) != std::string::npos; };
  for (const StressCase& c : stress_cases()) {
    EXPECT_TRUE(holds("\n## " + std::string(c.id) + "\n")) << c.id;
    for (const StressFigure& f : c.figures)
      EXPECT_TRUE(holds("\n| " + std::string(f.name) + " ")) << c.id << ": " << f.name;
  }
  EXPECT_FALSE(holds("FELL SHORT"));
}

// Cheap cases that nothing but integrators and impacts decides.
TEST(Stress, CheapCasesAreWithinTheirLimits) {
  for (const StressRow& r :
       rows_of(stress_cases({"spring-z", "stiff-drag", "cradle-20", "galperin", "bullet"}))) {
    EXPECT_NE(r.verdict, StressVerdict::kBeyond) << r.id << ", " << method_text(r.method) << ": "
                                                 << r.figure.name << " " << r.value << ", limit " << r.limit;
  }
}

}  // namespace
}  // namespace carom
