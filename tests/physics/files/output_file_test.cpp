#include "physics/files/output_file.h"

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <gtest/gtest.h>
#include <random>
#include <sstream>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <thread>

#include "physics/scene/validate.h"
#include "tests/support/faults.h"
#include "tests/support/preset_files.h"

namespace carom {
namespace {

namespace fs = std::filesystem;
using test::content;

class OutputFiles : public test::PresetFiles {
 protected:
  OutputFiles() { fs::permissions(folder_, fs::perms::all); }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void put(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder_)) all.push_back(entry.path().filename().string());
    std::sort(all.begin(), all.end());
    return all;
  }
  [[nodiscard]] mode_t mode(const std::string& name) const {
    struct stat facts = {};
    return stat(path(name).c_str(), &facts) == 0 ? facts.st_mode & 07777 : 0;
  }
};

void save(const std::string& name, const std::string& text) {
  OutputFile file(name);
  file.write(text);
  file.commit();
}

// The message of the refusal.
template <class Act>
std::string refusal(const Act& act) {
  try {
    act();
  } catch (const SceneError& error) {
    return error.what();
  }
  return "not refused";
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "no \"" << part << "\" in " << text;
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
}

TEST_F(OutputFiles, TakeTheirPlaceWholeOrNotAtAll) {
  {
    OutputFile file(path("a"));
    file.line("new");
    EXPECT_FALSE(fs::exists(path("a")));
    file.commit();
  }
  EXPECT_EQ(content(path("a")), "new\n");
  {
    OutputFile file(path("a"));
    file.write(std::string(300'000, 'x'));
    // What has a name already is never taken for a preset.
    for (const std::string& name : names()) EXPECT_FALSE(name.ends_with(".json")) << name;
  }
  EXPECT_EQ(content(path("a")), "new\n");
  EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

// As a film has frames: more than a process may have open files.
TEST_F(OutputFiles, ManyAtOnceHoldFewDescriptors) {
  const auto open_files = [] {
    return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator());
  };
  const auto before = open_files();
  constexpr int kMany = 300;
  std::vector<std::unique_ptr<OutputFile>> files;
  for (int i = 0; i < kMany; ++i) {
    files.push_back(std::make_unique<OutputFile>(path(std::to_string(i))));
    files.back()->line("new");
    files.back()->finish();
  }
  EXPECT_EQ(open_files(), before);
  EXPECT_FALSE(fs::exists(path("0")));
  for (const auto& file : files) file->commit();
  files.clear();
  EXPECT_EQ(names().size(), static_cast<std::size_t>(kMany));
  EXPECT_EQ(content(path("299")), "new\n");
  EXPECT_EQ(open_files(), before);
}

TEST_F(OutputFiles, LeaveFilesWithLikeNamesAlone) {
  put("a.part", "mine");
  put("a~", "mine too");
  save(path("a"), "new");
  EXPECT_EQ(content(path("a.part")), "mine");
  EXPECT_EQ(content(path("a~")), "mine too");
  EXPECT_EQ(names().size(), 3U);
}

TEST_F(OutputFiles, KeepTheModeOfWhatTheyReplace) {
  for (const mode_t kept : {0600, 0640, 0664, 0777, 0200}) {
    put("a", "old");
    ASSERT_EQ(chmod(path("a").c_str(), kept), 0);
    save(path("a"), "new");
    EXPECT_EQ(mode("a"), kept);
    EXPECT_EQ(content(path("a")), "new");
    fs::remove(path("a"));
  }
  for (const mode_t mask : {022, 077, 002}) {
    const mode_t before = umask(mask);
    save(path("b"), "new");
    umask(before);
    EXPECT_EQ(mode("b"), 0666 & ~mask);
    fs::remove(path("b"));
  }
}

TEST_F(OutputFiles, FollowSymbolicLinks) {
  put("target", "old");
  fs::create_directory(path("sub"));
  fs::create_symlink("target", path("near"));
  fs::create_symlink("../near", path("sub/far"));
  save(path("sub/far"), "new");
  EXPECT_EQ(content(path("target")), "new");
  EXPECT_TRUE(fs::is_symlink(path("near")));
  EXPECT_TRUE(fs::is_symlink(path("sub/far")));
  fs::create_symlink("not-yet", path("dangling"));
  save(path("dangling"), "made");
  EXPECT_TRUE(fs::is_symlink(path("dangling")));
  EXPECT_EQ(content(path("not-yet")), "made");
  fs::create_symlink("circle", path("circle"));
  expect_part(refusal([&] { save(path("circle"), "x"); }), "its links lead nowhere");
  fs::create_symlink("no/such/folder", path("lost"));
  expect_part(refusal([&] { save(path("lost"), "x"); }), "is not there");
}

TEST_F(OutputFiles, SayWhatCannotBeWritten) {
  expect_part(refusal([&] { save(folder_, "x"); }), "this is a folder; allowed: ");
  for (const std::string& name : std::vector<std::string>{"", "x/", ".", "..", "x/.."})
    expect_part(refusal([&] { save(name.empty() ? name : path(name), "x"); }), "; allowed: ");
  expect_part(refusal([&] { save(path("no/such"), "x"); }), "no is not there; allowed: a folder that is there");
  put("a", "old");
  expect_part(refusal([&] { save(path("a/b"), "x"); }), "is not there");
  for (const mode_t marked : {0444, 0400, 0555, 0000}) {
    ASSERT_EQ(chmod(path("a").c_str(), marked), 0);
    expect_part(refusal([&] { save(path("a"), "x"); }), "a: the file is marked read-only; allowed: ");
    EXPECT_EQ(mode("a"), marked);
  }
  ASSERT_EQ(chmod(path("a").c_str(), 0644), 0);
  EXPECT_EQ(content(path("a")), "old");
  EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

TEST_F(OutputFiles, NeedTheRightToWrite) {
  if (geteuid() != 0) GTEST_SKIP() << "needs two users";
  put("a", "old");
  put("b", "old");
  ASSERT_EQ(chmod(path("a").c_str(), 0644), 0);  // root's
  ASSERT_EQ(chmod(path("b").c_str(), 0666), 0);
  const auto expect_refused = [&](const std::string& name, const std::string& part) {
    const int code = test::as_nobody(
        [&] { return refusal([&] { save(path(name), "x"); }).find(part) == std::string::npos ? 1 : 0; });
    EXPECT_EQ(code, 0) << name << ": " << part;
  };
  expect_refused("a", "(Permission denied)");
  ASSERT_EQ(chmod(folder_.c_str(), 0755), 0);
  expect_refused("b", "(Permission denied)");
  expect_refused("c", "(Permission denied)");
  ASSERT_EQ(chmod(folder_.c_str(), 01777), 0);  // anybody writes, but nobody replaces another's file
  expect_refused("b", "(Operation not permitted)");
  EXPECT_EQ(test::as_nobody([&] {
              save(path("c"), "x");
              return 0;
            }),
            0);
  EXPECT_EQ(content(path("a")) + content(path("b")) + content(path("c")), "oldoldx");
}

TEST_F(OutputFiles, GoThroughWhatIsSpecial) {
  const auto is_device = [](const std::string& name) {
    struct stat facts = {};
    return stat(name.c_str(), &facts) == 0 && S_ISCHR(facts.st_mode);
  };
  save("/dev/null", "x");
  EXPECT_TRUE(is_device("/dev/null"));
  expect_part(refusal([] { save("/dev/full", "x"); }),
              "/dev/full: the file could not be written (No space left");
  EXPECT_TRUE(is_device("/dev/full"));
  fs::create_symlink("/dev/full", path("full"));
  expect_part(refusal([&] { save(path("full"), "x"); }), "(No space left");
  if (mknod(path("node").c_str(), S_IFCHR | 0666, makedev(1, 3)) == 0) {
    save(path("node"), "x");
    EXPECT_TRUE(is_device(path("node")));
  }

  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  const std::string sent(200'000, 'y');  // more than a pipe holds
  std::string read;
  std::thread reader([&] { read = content(path("pipe")); });
  save(path("pipe"), sent);
  reader.join();
  EXPECT_EQ(read, sent);
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

// Stdout is written on, not opened anew from its start.
TEST_F(OutputFiles, GoOnWhereStdoutIs) {
  std::fflush(stdout);
  const int before = dup(STDOUT_FILENO);
  const int log = open(path("log").c_str(), O_CREAT | O_WRONLY, 0600);
  dup2(log, STDOUT_FILENO);
  ASSERT_EQ(write(STDOUT_FILENO, "first\n", 6), 6);
  save("/dev/stdout", "second\n");
  ASSERT_EQ(write(STDOUT_FILENO, "third\n", 6), 6);
  dup2(before, STDOUT_FILENO);
  close(before);
  close(log);
  EXPECT_EQ(content(path("log")), "first\nsecond\nthird\n");
}

TEST_F(OutputFiles, AFullDiskLeavesTheOldFile) {
  const test::SmallDisk disk(folder_ / "disk", 256 << 10);
  if (!disk.mounted()) GTEST_SKIP() << "no disk may be mounted here";
  put("disk/a", "old");
  disk.fill(16 << 10);
  for (const std::size_t size : {20'000, 100'000, 1'000'000}) {
    expect_part(refusal([&] { save(path("disk/a"), std::string(size, 'x')); }),
                "could not be written (No space left on device)");
    EXPECT_EQ(content(path("disk/a")), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(path("disk")), {}), 2);
  }
  save(path("disk/a"), "fits");
  EXPECT_EQ(content(path("disk/a")), "fits");
}

// What there is room for comes to its place, what failed is said in one line.
TEST_F(OutputFiles, OneThatFailsLeavesTheOthers) {
  const test::SmallDisk disk(folder_ / "disk", 64 << 10);
  if (!disk.mounted()) GTEST_SKIP() << "no disk may be mounted here";
  disk.fill();
  OutputSet outputs;
  EXPECT_EQ(outputs.open(""), nullptr);
  OutputFile* full = outputs.open(path("disk/a"));
  OutputFile* good = outputs.open(path("b"));
  full->write("x");
  good->write("y");
  expect_part(outputs.commit(), "disk/a: the file could not be written (No space left on device)");
  EXPECT_EQ(content(path("b")), "y");
}

TEST_F(OutputFiles, SayThatTheirFolderHasGone) {
  fs::create_directory(path("sub"));
  OutputFile file(path("sub/a"));
  file.write("x");
  fs::remove_all(path("sub"));
  expect_part(refusal([&] { file.commit(); }),
              "sub/a: the file could not be written (No such file or directory)");
  EXPECT_TRUE(names().empty());
}

TEST_F(OutputFiles, AReadOnlyDiskIsRefusedBeforeTheWork) {
  const test::SmallDisk disk(folder_ / "disk", 64 << 10);
  if (!disk.mounted()) GTEST_SKIP() << "no disk may be mounted here";
  put("disk/a", "old");
  disk.make_read_only();
  for (const char* name : {"disk/a", "disk/b"})
    expect_part(refusal([&] { OutputFile file(path(name)); }), "(Read-only file system)");
}

// An input by whatever name, and another output, whether it is there or not.
TEST_F(OutputFiles, NeverTakeThePlaceOfAnother) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  fs::create_directory("sub");
  put("in", "read");
  put("old", "old");
  fs::create_symlink("in", "link");
  fs::create_hard_link("in", "hard");
  fs::create_directory_symlink(".", "here");
  fs::create_symlink("new", "dangling");
  for (const std::string& name : {std::string("in"), path("in"), std::string("./in"), std::string("sub/../in"),
                                  std::string("link"), std::string("hard"), std::string("here/in")}) {
    for (const std::string& input : std::vector<std::string>{"in", "link", "./hard"}) {
      OutputSet outputs({input});
      expect_part(refusal([&] { (void)outputs.open(name); }),
                  name + ": this is the file that is read, " + input);
    }
  }
  EXPECT_EQ(content("in"), "read");
  const auto expect_one = [](const std::string& a, const std::string& b) {
    OutputSet outputs({"in"});
    (void)outputs.open(a);
    expect_part(refusal([&] { (void)outputs.open(b); }), b + ": the output " + a + " goes to this file too");
  };
  expect_one("new", "new");
  expect_one("new", "./new");
  expect_one("new", path("new"));
  expect_one("new", "here/new");
  expect_one("new", "dangling");
  expect_one("dangling", "sub/../new");
  expect_one("old", "here/old");
  EXPECT_FALSE(fs::exists("new"));
  OutputSet outputs({"in"});
  EXPECT_NE(outputs.open("/dev/null"), nullptr);
  EXPECT_NE(outputs.open("/dev/null"), nullptr);
  EXPECT_NE(outputs.open("new"), nullptr);
  EXPECT_NE(outputs.open("old"), nullptr);
  EXPECT_EQ(outputs.commit(), "");
  fs::current_path(before);
}

// A process that is killed in the midst of saving leaves the old file or the new one.
TEST_F(OutputFiles, AreWholeWhereverTheWriterIsKilled) {
  const std::string even(150'000, 'e');
  const std::string odd(190'000, 'o');
  put("a", even);
  std::mt19937 random(7);
  for (int k = 0; k < test::kills(40); ++k) {
    int ready[2];
    ASSERT_EQ(pipe(ready), 0);
    const pid_t child = fork();
    if (child == 0) {
      (void)!write(ready[1], "r", 1);
      for (int i = 0;; ++i) save(path("a"), i % 2 == 0 ? odd : even);
    }
    char byte = 0;
    ASSERT_EQ(read(ready[0], &byte, 1), 1);
    close(ready[0]);
    close(ready[1]);
    usleep(static_cast<useconds_t>(random() % 20'000));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    const std::string left = content(path("a"));
    ASSERT_TRUE(left == even || left == odd) << left.size() << " bytes";
    for (const std::string& name : names()) {
      if (name == "a") continue;
      EXPECT_TRUE(name.starts_with(".carom-") && name.ends_with(".part")) << name;
      fs::remove(path(name));
    }
  }
}

}  // namespace
}  // namespace carom
