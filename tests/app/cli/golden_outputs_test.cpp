#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>

#include "tests/support/golden.h"
#include "tests/support/preset_files.h"
#include "tests/support/program.h"

// Hashes of the commands' output for every preset under its own method, in golden_outputs.txt. After an
// intended change of the output:
//   CAROM_WRITE_GOLDEN=1 build/release/bin/carom_app_tests --gtest_filter='*GoldenOutputs*'
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

class GoldenOutputs : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(GoldenOutputs, KeepTheirBytes) {
  // A study of every preset takes minutes: these have every kind of row.
  const std::set<std::string> studied = {"head-on",        "drag-projectile", "bouncing-ball",
                                         "newtons-cradle", "spring-box",      "overlapping-start"};
  const Program carom;
  const std::string name = GetParam().stem().string();
  const QString preset = QString::fromStdString(GetParam().string());
  std::map<std::string, std::string> now;
  const ProgramResult run = carom({"run", preset, "--json", "--csv", "run.csv", "--events", "events.csv"});
  EXPECT_EQ(run.code, 0) << run.err;
  now[name + " run --json"] = hash_of(QByteArray::fromStdString(run.out));
  now[name + " run --csv"] = hash_of(carom.read("run.csv"));
  now[name + " run --events"] = hash_of(carom.read("events.csv"));
  carom({"check", preset, "--csv", "check.csv"});
  now[name + " check --csv"] = hash_of(carom.read("check.csv"));
  if (studied.contains(name)) {
    const ProgramResult study = carom({"study", preset, "--repeats", "1", "--until", "0.5", "--steps",
                                       "0.02,0.01,0.005", "--tolerances", "1e-6,1e-8", "--csv", "study.csv"});
    EXPECT_EQ(study.code, 0) << study.err;
    now[name + " study --csv"] = hash_of(without_times(carom.read("study.csv")));
  }
  test::expect_golden(CAROM_GOLDEN_FILE, name, now);
}

INSTANTIATE_TEST_SUITE_P(Presets, GoldenOutputs, testing::ValuesIn(test::preset_files()),
                         test::preset_test_name);

}  // namespace
}  // namespace carom
