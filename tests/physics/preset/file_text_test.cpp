
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "physics/preset/preset_file.h"
#include "tests/support/preset_files.h"
#include "tests/support/source_folder.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

class FileText : public test::PresetFiles {
 protected:
  static std::string refusal(const fs::path& file) {
    try {
      (void)read_preset(file);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "read";
  }
};

// None of them is waited for.
TEST_F(FileText, OnlyRegularFilesAreRead) {
  const fs::path pipe = folder_ / "pipe.json";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(refusal(pipe), pipe.string() + ": this is a pipe; allowed: a preset file");
  fs::create_symlink(pipe, folder_ / "link.json");
  EXPECT_NE(refusal(folder_ / "link.json").find("this is a pipe"), std::string::npos);
  EXPECT_EQ(refusal("/dev/zero"), "/dev/zero: this is a device; allowed: a preset file");
  EXPECT_NE(refusal("/dev/tty").find("/dev/tty: this is a device"), std::string::npos);
  EXPECT_NE(refusal(folder_).find("this is a folder"), std::string::npos);
  EXPECT_NE(refusal(folder_ / "none.json").find("cannot be read"), std::string::npos);
  fs::create_symlink("loop.json", folder_ / "loop.json");
  EXPECT_NE(refusal(folder_ / "loop.json").find("cannot be read"), std::string::npos);

  const int bound = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string name = "/tmp/carom-socket-" + std::to_string(getpid());
  name.copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(bind(bound, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_NE(refusal(name).find("this is a socket"), std::string::npos);
  close(bound);
  fs::remove(name);
}

TEST_F(FileText, HugeFilesAreRefusedUnread) {
  const fs::path huge = folder_ / "huge.json";
  std::ofstream(huge).close();
  fs::resize_file(huge, 10'000'000'000);  // a hole: no room is taken
  EXPECT_EQ(refusal(huge), huge.string() + ": the file is larger than 256 MB; allowed: a preset file");
}

// Files of /proc say that they are empty.
TEST_F(FileText, AFileMayBeLongerThanItSays) { EXPECT_FALSE(file_text("/proc/self/status").empty()); }

TEST_F(FileText, LinksToFilesAreFollowed) {
  fs::create_symlink(test::preset_file("piles/pile.json"), folder_ / "pile.json");
  EXPECT_EQ(refusal(folder_ / "pile.json"), "read");
}

}  // namespace
}  // namespace carom
