#include <QRegularExpression>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>

#include "tests/support/effort.h"
#include "tests/support/golden.h"
#include "tests/support/preset_files.h"
#include "tests/support/program.h"
#include "tests/support/source_folder.h"

// Hashes of the commands' output for every preset under its own method, in golden_outputs.txt. After an
// intended change of the output:
//   CAROM_WRITE_GOLDEN=1 build/release/bin/carom_app_tests --gtest_filter='*GoldenOutputs*'
// Where mathematical functions round differently, the outputs but for their numbers are compared; these are the
// physics' matter (tests/physics/run/golden_test.cpp).
namespace carom {
namespace {

// Without the columns of measured times.
QByteArray without_times(const QByteArray& csv) {
  QByteArray out;
  QList<bool> timed;
  for (const QByteArray& line : csv.split('\n')) {
    const QList<QByteArray> cells = line.split(',');
    if (timed.isEmpty()) {
      for (const QByteArray& cell : cells) timed.append(cell.contains("wall time"));
    }
    for (qsizetype i = 0; i < cells.size(); ++i) {
      if (i >= timed.size() || !timed[i]) out += cells[i] + ',';
    }
    out += '\n';
  }
  return out;
}

std::string hash_of(const QByteArray& bytes) {
  test::Hash hash;
  hash.add({bytes.constData(), static_cast<std::size_t>(bytes.size())});
  return hash.text();
}

// Without numbers and notices: whether a run comes near a limit may hang on rounding.
std::string loose_hash_of(const QByteArray& bytes) {
  static const QRegularExpression number(R"((?<![A-Za-z_])-?\d+(\.\d+)?(e[-+]?\d+)?)");
  static const QRegularExpression status(R"("status": "[^"]*")");
  return hash_of(QString::fromUtf8(bytes).replace(number, "#").replace(status, "").toUtf8());
}

class GoldenOutputs : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(GoldenOutputs, KeepTheirBytes) {
  // A study of every preset takes minutes: these have every kind of row.
  const std::set<std::string> studied = {"head-on",        "drag-projectile", "bouncing-ball",
                                         "newtons-cradle", "spring-box",      "overlapping-start"};
  const Program carom;
  const std::string name = GetParam().stem().string();
  const QString preset = QString::fromStdString(GetParam().string());
  std::map<std::string, QByteArray> outputs;
  const ProgramResult run = carom({"run", preset, "--json", "--csv", "run.csv", "--events", "events.csv"});
  EXPECT_EQ(run.code, 0) << run.err;
  outputs[name + " run --json"] = QByteArray::fromStdString(run.out);
  outputs[name + " run --csv"] = carom.read("run.csv");
  outputs[name + " run --events"] = carom.read("events.csv");
  // The physics' tests measure the same (Presets.MeetTheirExpectations): the quick ones do it once.
  if (test::by_effort(false, true, true)) {
    const ProgramResult check = carom({"check", preset, "--csv", "check.csv"});
    EXPECT_EQ(check.code, 0) << check.out << check.err;
    outputs[name + " check --csv"] = carom.read("check.csv");
  }
  if (studied.contains(name)) {
    const ProgramResult study = carom({"study", preset, "--repeats", "1", "--until", "0.5", "--steps",
                                       "0.02,0.01,0.005", "--tolerances", "1e-6,1e-8", "--csv", "study.csv"});
    EXPECT_EQ(study.code, 0) << study.err;
    outputs[name + " study --csv"] = without_times(carom.read("study.csv"));
  }
  std::map<std::string, std::string> hashes;
  for (const auto& [output, bytes] : outputs) hashes[output] = hash_of(bytes);
  const auto loose_of = [&](const std::string& output) { return loose_hash_of(outputs.at(output)); };
  const auto compare_loosely = [&](const std::string& output, const std::string& loose) {
    // How many impacts there are may hang on rounding.
    if (!output.ends_with("--events")) {
      EXPECT_EQ(loose, loose_of(output)) << output;
    }
  };
  test::expect_golden(test::source("tests/app/cli/golden_outputs.txt"), name, hashes, loose_of,
                      compare_loosely);
}

INSTANTIATE_TEST_SUITE_P(Presets, GoldenOutputs, testing::ValuesIn(test::preset_files()),
                         test::preset_test_name);

}  // namespace
}  // namespace carom
