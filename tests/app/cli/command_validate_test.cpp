#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/support/program.h"

namespace carom {
namespace {

constexpr const char* kGoodPreset = R"({"format": "carom-preset", "version": 1, "title": "t"})";

// Runs the program with its own presets.
ProgramResult run_with_presets(const Program& carom, const QString& arguments) {
  return carom.shell("CAROM_PRESETS=$PWD/presets \"$carom\" " + arguments);
}

TEST(Validate, SaysOfEachFileWhetherItIsGood) {
  const Program carom;
  carom.write("good.json", kGoodPreset);
  carom.write("bad.json", R"({"format": "carom-preset", "version": 1, "title": "t", "duration": 0})");
  const ProgramResult good = carom({"validate", "good.json", "head-on"});
  EXPECT_EQ(good.code, 0);
  EXPECT_EQ(good.out, "good.json: good\nhead-on: good\n");
  EXPECT_EQ(good.err, "");
  const ProgramResult mixed = carom({"validate", "bad.json", "no-such.json", "good.json"});
  EXPECT_EQ(mixed.code, 2);
  EXPECT_EQ(mixed.out, "good.json: good\n");
  EXPECT_EQ(mixed.err,
            "carom: bad.json: /duration: 0 is not allowed; allowed: a number from 1e-12 to 1000000000000 s\n"
            "carom: no-such.json: the file cannot be read; allowed: a preset file\n");
  expect_refused(carom({"validate"}), "FILE|NAME");
  expect_refused(carom({"validate", "--schema", "good.json"}), "--schema");
  expect_refused(carom({"validate", "--schema", "--keys"}), "--keys");
}

TEST(Validate, PrintsTheKeysOfAScene) {
  const ProgramResult result = Program()({"validate", "--keys"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("## bodies\n"), std::string::npos);
  EXPECT_NE(result.out.find("| mass | kg, > 0 |  | or a density |\n"), std::string::npos) << result.out;
}

TEST(Validate, PrintsTheSchema) {
  const ProgramResult result = Program()({"validate", "--schema"});
  EXPECT_EQ(result.code, 0);
  const auto schema = nlohmann::json::parse(result.out);
  EXPECT_EQ(schema["properties"]["duration"]["maximum"], 1e12);
}

TEST(PresetFolder, IrregularFilesAreSkippedAndReported) {
  const Program carom;
  QDir(carom.path(".")).mkpath("presets/topic/deeper");
  carom.write("presets/topic/one.json", kGoodPreset);
  carom.write("presets/topic/deeper/two.json", kGoodPreset);
  carom.write("presets/topic/bad.json", "{");
  carom.write("presets/topic/preset.schema.json", "{}");
  ASSERT_EQ(mkfifo(carom.path("presets/topic/pipe.json").toUtf8(), 0600), 0);
  ASSERT_EQ(symlink(".", carom.path("presets/topic/loop").toUtf8()), 0);
  ASSERT_EQ(symlink("gone", carom.path("presets/topic/gone.json").toUtf8()), 0);
  const ProgramResult list = run_with_presets(carom, "list");
  EXPECT_EQ(list.code, 0);
  EXPECT_NE(list.out.find("one  t\n"), std::string::npos) << list.out;
  EXPECT_NE(list.out.find("two  t\n"), std::string::npos) << list.out;
  for (const char* line : {"pipe.json: this is no regular file; left out\n",
                           "gone.json: this is no regular file; left out\n", "bad.json: line 1, column"}) {
    EXPECT_NE(list.err.find(line), std::string::npos) << list.err;
  }
  EXPECT_EQ(std::count(list.err.begin(), list.err.end(), '\n'), 3) << list.err;
  const ProgramResult run = run_with_presets(carom, "run two");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "");
}

TEST(PresetFolder, ThatCannotBeReadIsLeftOut) {
  if (geteuid() == 0) GTEST_SKIP() << "root reads every folder";
  const Program carom;
  QDir(carom.path(".")).mkpath("presets/a");
  QDir(carom.path(".")).mkpath("presets/shut");
  carom.write("presets/a/one.json", kGoodPreset);
  ASSERT_EQ(chmod(carom.path("presets/shut").toUtf8(), 0), 0);
  const ProgramResult list = run_with_presets(carom, "list");
  EXPECT_EQ(list.code, 0);
  EXPECT_NE(list.out.find("one  t\n"), std::string::npos);
  EXPECT_NE(list.err.find("shut: the folder cannot be read"), std::string::npos) << list.err;
}

TEST(Names, ReachTheTerminalEscapedAndJsonAsUtf8) {
  const Program carom;
  const char* preset =
      "{\"format\": \"carom-preset\", \"version\": 1, \"title\": \"\\u001b[31mred\", \"duration\": 0.01,"
      "\"bodies\": [{\"name\": \"a\\u001b[2J\\u202e\", \"shape\": {\"type\": \"disc\", \"radius\": 0.1}, "
      "\"position\": [0, 0]}],"
      "\"expect\": [{\"observable\": \"x\", \"bodies\": [\"a\\u001b[2J\\u202e\"], \"reduction\": \"final\", "
      "\"value\": 0, \"tolerance\": 1}]}";
  carom.write("names.json", preset);
  for (const QStringList& arguments :
       {QStringList{"run", "names.json"}, QStringList{"check", "names.json"},
        QStringList{"study", "names.json", "--repeats", "1", "--steps", "0.01", "--integrators", "rk4"}}) {
    const ProgramResult result = carom(arguments);
    EXPECT_EQ(result.code, 0) << arguments[0].toStdString() << result.err;
    EXPECT_EQ((result.out + result.err).find('\x1b'), std::string::npos) << result.out;
    EXPECT_EQ((result.out + result.err).find("\u202e"), std::string::npos) << result.out;
  }
  EXPECT_NE(carom({"run", "names.json"}).out.find("\\x1b[31mred"), std::string::npos);
  // A file whose name is not UTF-8.
  const ProgramResult json =
      carom.shell(R"(mv names.json $'\xff\x1b.json' && "$carom" run $'\xff\x1b.json' --json)");
  EXPECT_EQ(json.code, 0) << json.err;
  EXPECT_EQ(nlohmann::json::parse(json.out)["preset"], "\uFFFD\x1b");
  const ProgramResult missing = carom.shell(R"("$carom" run $'\xff\x1b[31m' --json)");
  expect_refused(missing, "\\xff\\x1b[31m: no such file or experiment");
}

TEST(Arguments, LongOnesAreNotEchoedWhole) {
  const Program carom;
  const QString word(60'000, 'x');
  for (const QStringList& arguments :
       {QStringList{"run", word}, QStringList{"run", "head-on", word},
        QStringList{"run", "head-on", "--" + word}, QStringList{"run", word + "/" + word + ".json"},
        QStringList{"run", "head-on", "--until", word}, QStringList{"run", "head-on", "--step", word},
        QStringList{"run", "head-on", "--integrator", word},
        QStringList{"run", "head-on", "--csv", "no/" + word}, QStringList{"study", word},
        QStringList{"study", "head-on", "--steps", word}, QStringList{"picture", "head-on", "-o", word},
        QStringList{"film", "head-on", "-o", "a", "--width", word}, QStringList{word, word}}) {
    const ProgramResult result = carom(arguments);
    EXPECT_EQ(result.code, 2);
    EXPECT_LT(result.err.size(), 1000U) << arguments[0].toStdString();
    EXPECT_NE(result.err, "");
  }
}

// Neither command blocks on a pipe.
TEST(Pipes, AreRefused) {
  const Program carom;
  ASSERT_EQ(mkfifo(carom.path("pipe.json").toUtf8(), 0600), 0);
  for (const QStringList& arguments :
       {QStringList{"run", "pipe.json"}, QStringList{"validate", "pipe.json"},
        QStringList{"check", "./pipe.json"}, QStringList{"picture", "pipe.json", "-o", "a.png"},
        QStringList{"pipe.json"}})
    expect_refused(carom(arguments), "pipe.json: this is a pipe; allowed: a preset file");
  expect_refused(carom({"run", "/dev/zero"}), "/dev/zero: this is a device; allowed: a preset file");
}

}  // namespace
}  // namespace carom
