#include <algorithm>

#include "tests/support/faults.h"
#include "tests/support/program.h"
#include "tests/support/source_folder.h"

namespace carom {
namespace {

// Every command that writes files into the folder $d, and whether it also prints results.
struct Writer {
  const char* command;
  bool prints = true;
};
constexpr Writer kWriters[] = {
    {"run a.json --csv $d/old.csv"},
    {"run a.json --events $d/old.csv"},
    {"run a.json --save $d/old.json"},
    {"run a.json --json --csv $d/old.csv --events $d/new.csv --save $d/old.json"},
    {"run a.json --until 20 --step 1e-4 --csv $d/old.csv"},
    {"check a.json --csv $d/old.csv"},
    {"check a.json bouncing-ball --csv $d/new.csv"},
    {"study a.json --until 1 --repeats 1 --integrators rk4 --steps 0.01,0.005 --csv $d/old.csv"},
    {"study a.json --until 1 --repeats 1 --integrators rk4 --steps 0.01,0.005 --plot $d/old.svg"},
    {"study a.json --until 1 --repeats 1 --integrators rk4 --steps 0.01,0.005 --csv $d/old.csv --plot "
     "$d/old.pdf"},
    {"picture a.json -o $d/old.png", false},
    {"picture a.json -o $d/old.svg", false},
    {"picture a.json -o $d/old.pdf", false},
    {"picture a.json --window -o $d/old.png", false},
    {"film a.json --to 0.2 --width 200 --height 200 -o $d/new-film", false},
    {"film a.json --to 0.2 --width 200 --height 200 --replace -o $d/film", false},
};

class OutputFaults : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(QFile::copy(test::preset_file("first-collisions/head-on.json").c_str(), carom_.path("a.json")));
  }
  // Creates older files with all names that commands write, in a folder.
  void put_old_files(const QString& folder) const {
    const ProgramResult made =
        carom_.shell("d=" + folder +
                     "; mkdir -p $d/film && for x in csv json png svg pdf; do echo old > $d/old.$x; done;"
                     "for k in 1 2 3 4 5 6; do echo old > $d/film/frame-000$k.png; done");
    ASSERT_EQ(made.code, 0) << made.err;
  }
  // Names, sizes and sums of all files of a folder.
  [[nodiscard]] std::string contents(const QString& folder) const {
    return carom_
        .shell("cd " + folder + "; find . -not -name fill -type f -exec cksum {} + | sort; ls -RA -I fill")
        .out;
  }
  // The failure is one line; results are still printed, and the folder is unchanged.
  void expect_failure(const Writer& writer, const QString& folder, const QString& before_it,
                      const std::string& part) const {
    SCOPED_TRACE(writer.command);
    const std::string before = contents(folder);
    const ProgramResult result = carom_.shell("d=" + folder + "; " + before_it + " $carom " + writer.command);
    EXPECT_EQ(result.code, 2);
    EXPECT_TRUE(result.err.starts_with("carom: ")) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
    EXPECT_EQ(!result.out.empty(), writer.prints) << result.out;
    EXPECT_EQ(contents(folder), before);
  }
  Program carom_;
};

TEST_F(OutputFaults, OnAFullDiskTheResultsArePrintedAndOldFilesStay) {
  const test::SmallDisk disk(carom_.path("disk").toStdString(), 1 << 20);
  if (!disk.mounted()) GTEST_SKIP() << "no disk may be mounted here";
  put_old_files("disk");
  disk.fill();
  for (const Writer& writer : kWriters)
    expect_failure(writer, "disk", "", "could not be written (No space left on device)");
}

// A file size limit simulates a full disk without mounting one.
TEST_F(OutputFaults, WhereFilesMayNotGrowTheResultsArePrintedAndOldFilesStay) {
  put_old_files("there");
  for (const Writer& writer : kWriters)
    expect_failure(writer, "there", "ulimit -f 0;", "could not be written (File too large)");
}

// Room for some frames only: all frames of the older film stay.
TEST_F(OutputFaults, AFilmThatDoesNotFitLeavesTheOldOne) {
  const test::SmallDisk disk(carom_.path("disk").toStdString(), 64 << 10);
  if (!disk.mounted()) GTEST_SKIP() << "no disk may be mounted here";
  put_old_files("disk");
  disk.fill(12 << 10);
  expect_failure({"film a.json --to 0.8 --width 200 --height 200 --replace -o $d/film", false}, "disk", "",
                 "could not be written (No space left on device)");
}

TEST_F(OutputFaults, AReadOnlyDiskIsRefusedBeforeTheRun) {
  const test::SmallDisk disk(carom_.path("disk").toStdString(), 1 << 20);
  if (!disk.mounted()) GTEST_SKIP() << "no disk may be mounted here";
  put_old_files("disk");
  disk.make_read_only();
  for (const Writer& writer : kWriters)
    expect_failure({writer.command, false}, "disk", "", "(Read-only file system)");
}

TEST_F(OutputFaults, AFolderWithoutTheRightToWriteIsRefusedBeforeTheRun) {
  const ProgramResult where = carom_.shell("mkdir there && chmod 755 . there && readlink -f $carom");
  put_old_files("there");
  const QString user = geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups" : "";
  if (carom_.shell(user + " $carom --version").code != 0)
    GTEST_SKIP() << "another user cannot start " << where.out << " here";
  ASSERT_EQ(carom_.shell(geteuid() != 0 ? "chmod -R a-w there" : "true").code, 0);
  for (const Writer& writer : kWriters)
    expect_failure({writer.command, false}, "there", user, writer.command[0] == 'f' ? "" : "; allowed: ");
}

// The folder of one output is removed while the events wait in a pipe that nobody reads.
TEST_F(OutputFaults, AFolderThatGoesInMidRunIsSaidBesideTheResults) {
  // It has more impacts than a pipe holds, so that the run cannot end before the folder is removed.
  const ProgramResult result = carom_.shell(
      "mkdir sub; mkfifo pipe; $carom run gas --csv sub/x.csv --events pipe & exec 3< pipe; rm -r "
      "sub;"
      "cat <&3 > events.csv; wait $!");
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(
      result.err,
      "carom: sub/x.csv: the file could not be written (No such file or directory); allowed: a place with room "
      "and the right to write\n");
  EXPECT_NE(result.out.find("\nstatus: "), std::string::npos);
  EXPECT_TRUE(carom_.read("events.csv").startsWith("time [s],body_a"));
}

TEST_F(OutputFaults, StdoutThatTakesNothingIsNoticedByEveryCommand) {
  for (const char* command : {"list", "run a.json", "run a.json --json", "check a.json", "--help", "run --help",
                              "film --help", "--version", "study a.json --until 1 --repeats 1",
                              "film a.json --to 0.1 --width 200 --height 200 -o f --replace", ""}) {
    SCOPED_TRACE(command);
    const QString line = "$carom " + QString(command);
    for (const char* stdout_of : {" > /dev/full", " >&-"}) {
      const ProgramResult result = carom_.shell(line + stdout_of);
      EXPECT_EQ(result.code, 2);
      EXPECT_TRUE(result.err.starts_with("carom: stdout: not everything could be written")) << result.err;
      EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    }
    // The reader is gone before anything is written: no message, but no success.
    const ProgramResult unread =
        carom_.shell("{ while [ ! -e gone ]; do :; done; " + line +
                     "; echo $? > code; } | { exec 0<&-; touch gone; }; rm gone; cat code");
    EXPECT_EQ(unread.out, "2\n");
    EXPECT_EQ(unread.err, "");
  }
}

// Both faults at once: one line, and the writable files are written.
TEST_F(OutputFaults, FilesAreWrittenThoughStdoutIsFull) {
  for (const char* stdout_of : {"> /dev/full", ">&-"}) {
    const ProgramResult result =
        carom_.shell("rm -f x.csv s.json; $carom run a.json --csv x.csv --save s.json " + QString(stdout_of));
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(carom_.read("x.csv").count('\n'), 202) << stdout_of;
    EXPECT_EQ(carom_({"run", "s.json"}).code, 0);
  }
  const ProgramResult both = carom_.shell("$carom run a.json --csv /dev/full > /dev/full");
  EXPECT_EQ(both.code, 2);
  EXPECT_EQ(std::count(both.err.begin(), both.err.end(), '\n'), 1) << both.err;
  EXPECT_EQ(carom_.shell("$carom run a.json --csv no/x 2> /dev/full").code, 2);
}

// Only the replaced frames and those left of a longer film by Carom are changed.
TEST_F(OutputFaults, AFilmLeavesStrangersPicturesAlone) {
  const QString film = "$carom film a.json --width 200 --height 200 -o f ";
  ASSERT_EQ(carom_.shell(film + "--to 0.4").code, 0);
  ASSERT_EQ(
      carom_
          .shell(
              "cd f; echo mine | tee frame-0008.png > frame-9999.png; echo mine > photo.png; echo t > target;"
              "rm frame-0002.png; ln -s target frame-0002.png; chmod 600 frame-0001.png")
          .code,
      0);
  const ProgramResult shorter = carom_.shell(film + "--to 0.16 --replace");
  EXPECT_EQ(shorter.code, 0) << shorter.err;
  EXPECT_EQ(shorter.err, "");
  EXPECT_NE(shorter.out.find("5 frames of a longer film that was there before are removed"), std::string::npos)
      << shorter.out;
  EXPECT_NE(shorter.out.find("2 frames not made by Carom, from frame-0008.png on"), std::string::npos)
      << shorter.out;
  EXPECT_EQ(carom_
                .shell("cd f; ls -A; cat frame-0008.png frame-9999.png photo.png; readlink frame-0002.png;"
                       "head -c 4 target | tail -c 3; echo; stat -c %a frame-0001.png")
                .out,
            "frame-0001.png\nframe-0002.png\nframe-0003.png\nframe-0004.png\nframe-0005.png\nframe-0008.png\n"
            "frame-9999.png\nphoto.png\ntarget\nmine\nmine\nmine\ntarget\nPNG\n600\n");

  // Neither its own preset nor a read-only file is replaced; then no frame is changed.
  const QByteArray preset = carom_.read("a.json");
  for (const char* taken :
       {"rm f/frame-0003.png; ln a.json f/frame-0003.png", "ln -sf ../a.json f/frame-0003.png",
        "rm f/frame-0003.png; echo > f/frame-0003.png; chmod 444 f/frame-0003.png"}) {
    ASSERT_EQ(carom_.shell(taken).code, 0);
    const std::string before = contents("f");
    const ProgramResult refused = carom_.shell(film + "--to 0.16 --replace --dark");
    expect_refused(refused, "f/frame-0003.png: ");
    EXPECT_EQ(contents("f"), before);
  }
  EXPECT_EQ(carom_.read("a.json"), preset);
}

}  // namespace
}  // namespace carom
