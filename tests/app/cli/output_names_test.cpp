#include <QFileInfo>
#include <sys/stat.h>

#include "tests/support/program.h"
#include "tests/support/source_folder.h"

namespace carom {
namespace {

// Which files a command may write, whatever their names.
class OutputNames : public testing::Test {
 protected:
  void SetUp() override { copy("a.json"); }
  void copy(const QString& name) const {
    QFile::remove(carom_.path(name));
    ASSERT_TRUE(QFile::copy(test::preset_file("first-collisions/head-on.json").c_str(), carom_.path(name)));
  }
  // The run would never end: all names are refused before it.
  void expect_refused_before_the_run(const QString& line, const std::string& part) const {
    SCOPED_TRACE(line.toStdString());
    expect_refused(carom_.shell("timeout 60 " + line), part);
  }
  Program carom_;
};

constexpr const char* kRead = "this is the file that is read";
constexpr const char* kTwice = "goes to this file too";

TEST_F(OutputNames, NoOutputTakesThePlaceOfThePreset) {
  const QByteArray preset = carom_.read("a.json");
  // Pictures have their own rules for names.
  ASSERT_EQ(
      carom_.shell("mkdir s; for x in json png; do cp -n a.json a.$x; ln -s a.$x l.$x; ln a.$x h.$x; done")
          .code,
      0);
  const QString here = QFileInfo(carom_.path("a.json")).path() + "/";
  struct Names {
    QString read, written;
  };
  const std::vector<Names> all = {{"./a", "a"},           {"./a", "./a"},      {"s/../a", "a"},
                                  {here + "a", "s/../a"}, {"./a", here + "a"}, {"./a", "l"},
                                  {"./l", "a"},           {"./a", "h"},        {"./h", "l"}};
  for (const Names& names : all) {
    const auto expect = [&](const QString& command, const QString& suffix, const QString& option) {
      expect_refused_before_the_run(
          "$carom " + command.arg(names.read + suffix) + " " + option + " " + names.written + suffix, kRead);
    };
    for (const char* option : {"--csv", "--events", "--save"}) expect("run %1 --until 1e9", ".json", option);
    expect("check %1", ".json", "--csv");
    expect("study %1", ".json", "--csv");
    expect("study %1", ".png", "--plot");
    expect("picture %1 --at 1e9", ".png", "-o");
    expect("picture %1 --at 1e9 --window", ".png", "-o");
  }
  EXPECT_EQ(carom_.read("a.json"), preset);
  EXPECT_EQ(carom_.read("a.png"), preset);
  EXPECT_EQ(carom_.files().filter(".part"), QStringList());
}

TEST_F(OutputNames, APresetThatIsFoundByItsNameIsReadToo) {
  ASSERT_EQ(carom_.shell("mkdir -p lib/mine && cp a.json lib/mine/own.json").code, 0);
  for (const char* command : {"run own --until 1e9", "check own", "check", "study own"})
    expect_refused_before_the_run(
        "env CAROM_PRESETS=$PWD/lib $carom " + QString(command) + " --csv lib/mine/own.json", kRead);
  EXPECT_EQ(carom_.read("lib/mine/own.json"), carom_.read("a.json"));
}

TEST_F(OutputNames, NoOutputTakesThePlaceOfAnother) {
  ASSERT_EQ(carom_.shell("ln -s new l; echo old > old; ln -s old k; ln -s x.png p").code, 0);
  for (const char* options :
       {"--csv x --events x", "--csv x --save ./x", "--events x --save $PWD/x", "--csv new --events l",
        "--csv l --save new", "--csv old --events k", "--csv k --save ./old"})
    expect_refused_before_the_run("$carom run a.json --until 1e9 " + QString(options), kTwice);
  expect_refused_before_the_run("$carom study a.json --csv x.png --plot ./x.png", kTwice);
  expect_refused_before_the_run("$carom study a.json --csv p --plot x.png", kTwice);
  expect_refused_before_the_run("$carom run a.json --until 1e9 --csv old >> old", "stdout goes to this file");
  EXPECT_EQ(carom_.read("old"), "old\n");
  EXPECT_EQ(carom_.files(), (QStringList{"a.json", "k", "old"})) << carom_.files().join(' ').toStdString();
}

TEST_F(OutputNames, PlacesThatCannotBeWrittenAreSeenBeforeTheRun) {
  ASSERT_EQ(
      carom_.shell("mkdir folder; echo old > marked; chmod 444 marked; cp marked marked.png; ln -s marked m")
          .code,
      0);
  for (const char* option : {"--csv", "--events", "--save"}) {
    const QString run = "$carom run a.json --until 1e9 " + QString(option) + " ";
    expect_refused_before_the_run(run + "no/such/file", "the folder no/such is not there");
    expect_refused_before_the_run(run + "folder", "this is a folder");
    expect_refused_before_the_run(run + "marked", "the file is marked read-only");
    expect_refused_before_the_run(run + "m", "the file is marked read-only");
  }
  expect_refused_before_the_run("$carom picture a.json --at 1e9 -o marked.png", "the file is marked read-only");
  expect_refused_before_the_run("$carom study a.json --plot marked.png", "the file is marked read-only");
  expect_refused_before_the_run("$carom study a.json --csv marked", "the file is marked read-only");
  expect_refused_before_the_run("$carom check --csv marked", "the file is marked read-only");
  expect_refused_before_the_run("$carom film a.json --to 3e3 -o marked", "this is not a folder");
  EXPECT_EQ(carom_.read("marked"), "old\n");
  EXPECT_EQ(carom_.files().filter(".part"), QStringList());
}

TEST_F(OutputNames, AnOutputHasAName) {
  for (const char* command :
       {"run a.json --csv", "run a.json --events", "run a.json --save", "check --csv", "study a.json --csv",
        "study a.json --plot", "picture a.json -o", "film a.json -o"})
    expect_refused_before_the_run("$carom " + QString(command) + " ''", "the name of a file is needed");
}

TEST_F(OutputNames, ModesLinksAndFilesOfLikeNamesStay) {
  const ProgramResult done = carom_.shell(
      "echo mine > x.part; echo old > x; chmod 640 x; echo old > t; ln -s t l; umask 027;"
      "$carom run a.json --csv x --events l --save new.json >/dev/null && stat -c %a x new.json && readlink l");
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(done.out, "640\n640\nt\n");
  EXPECT_EQ(carom_.read("x.part"), "mine\n");
  EXPECT_TRUE(carom_.read("x").startsWith("time [s],"));
  EXPECT_TRUE(carom_.read("t").startsWith("time [s],body_a"));
}

TEST_F(OutputNames, StreamsAndDevicesAreWrittenThrough) {
  const ProgramResult both = carom_.shell("$carom run a.json --csv /dev/stdout");
  EXPECT_EQ(both.code, 0) << both.err;
  EXPECT_TRUE(both.out.starts_with("time [s],"));
  EXPECT_NE(both.out.find("\nstatus: ok\n"), std::string::npos);
  EXPECT_EQ(carom_.shell("$carom run a.json --csv /dev/stdout > both && cat both").out, both.out);
  EXPECT_EQ(carom_.shell("{ $carom run a.json --csv /dev/fd/3 3>&1 >/dev/null; } | head -c 8").out, "time [s]");
  EXPECT_EQ(
      carom_.shell("$carom run a.json --csv /dev/null --events /dev/null > /dev/null && stat -c %F /dev/null")
          .out,
      "character special file\n");
  const ProgramResult full =
      carom_.shell("$carom run a.json --csv /dev/full; e=$?; stat -c %F /dev/full; exit $e");
  EXPECT_EQ(full.code, 2);
  EXPECT_NE(full.out.find("\nstatus: ok\ncharacter special file\n"), std::string::npos) << full.out;
  EXPECT_NE(full.err.find("/dev/full: the file could not be written (No space left on device)"),
            std::string::npos);
}

}  // namespace
}  // namespace carom
