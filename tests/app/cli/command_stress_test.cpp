#include <algorithm>
#include <sstream>
#include <vector>

#include "physics/stress/stress.h"
#include "tests/support/program.h"
#include "tests/support/source_folder.h"

namespace carom {
namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(StressCommand, CasesThatAreNamedRun) {
  const Program carom;
  const ProgramResult result =
      carom({"stress", "galperin", "cradle-5", "--csv", "out.csv", "--page", "out.md"});
  EXPECT_EQ(result.code, 0) << result.out << result.err;
  EXPECT_EQ(result.err, "");  // no progress in a pipe
  EXPECT_TRUE(holds(result.out, "20 of 20 figures of 2 cases are within their limits.")) << result.out;
  const std::vector<std::string> table = lines_of(result.out);
  ASSERT_EQ(table.size(), 13U);  // heading, 5 figures under 2 integrators, blank, sentence
  EXPECT_TRUE(holds(table[0], "at h/4") && holds(table[0], "verdict")) << table[0];
  EXPECT_TRUE(table[1].starts_with("galperin ")) << table[1];
  // Columns are aligned.
  EXPECT_EQ(table[1].find("good"), table[0].find("verdict"));
  const std::vector<std::string> page = lines_of(carom.read("out.md").toStdString());
  EXPECT_EQ(std::count(page.begin(), page.end(), "20 of 20 figures of 2 cases are within their limits."), 1);
  const std::vector<std::string> csv = lines_of(carom.read("out.csv").toStdString());
  ASSERT_EQ(csv.size(), 21U);
  EXPECT_TRUE(csv[0].starts_with("case,method,figure,unit,limit,verdict,")) << csv[0];
  EXPECT_TRUE(csv[1].starts_with("galperin,\"explicit-euler, located, lasting, 1/60 s\",0,1,0,good,"))
      << csv[1];
}

// The command generates the help page of figures, which must have every case and every figure.
TEST(StressCommand, TheHelpsPageHasAllFiguresAndNoneFellShort) {
  QFile file(test::source("app/help/stress-figures.md"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const std::string page = file.readAll().toStdString();
  for (const StressCase& c : stress_cases()) {
    EXPECT_TRUE(holds(page, "\n## " + std::string(c.id) + "\n")) << c.id;
    for (const StressFigure& f : c.figures)
      EXPECT_TRUE(holds(page, "\n| " + std::string(f.name) + " ")) << c.id << ": " << f.name;
  }
  EXPECT_FALSE(holds(page, "FELL SHORT"));
}

TEST(StressCommand, BadInputIsRefused) {
  const Program carom;
  expect_refused(carom({"stress", "LIST"}), "\"LIST\": no such case; allowed: stack-20, ");
  expect_refused(carom({"stress", "galperin", "no-such"}), "\"no-such\": no such case; allowed: ");
  expect_refused(carom({"stress", "galperin", "--csv", "no/such/out.csv"}), "no/such/out.csv");
  expect_refused(carom({"stress", "galperin", "--page", "no/such/out.md"}), "no/such/out.md");
  expect_refused(carom({"stress", "--bogus"}), "--bogus");
}

}  // namespace
}  // namespace carom
