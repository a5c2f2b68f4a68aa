#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "physics/preset/preset_file.h"
#include "physics/scene/validate.h"

namespace carom {
namespace {

// An open file, closed at the end.
class Descriptor {
 public:
  explicit Descriptor(const std::filesystem::path& file)
      // Without O_NONBLOCK, opening a pipe waits for a writer.
      : number_(open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

// The kind of a file that is not a regular one.
const char* kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

}  // namespace

std::string file_text(const std::filesystem::path& file) {
  const std::string name = shortened(file.string(), kMostOfFileName);
  const auto refuse = [&](const std::string& what) {
    throw SceneError(fmt::format("{}: {}; allowed: a preset file", name, what));
  };
  // A socket cannot be opened, so its kind is checked first.
  struct stat about {};
  if (stat(file.c_str(), &about) == 0 && !S_ISREG(about.st_mode))
    refuse(fmt::format("this is {}", kind_of(about.st_mode)));
  const Descriptor in(file);
  if (in.number() < 0 || fstat(in.number(), &about) != 0) refuse("the file cannot be read");
  if (!S_ISREG(about.st_mode)) refuse(fmt::format("this is {}", kind_of(about.st_mode)));
  const auto too_large = [&] {
    refuse(fmt::format("the file is larger than {} MB", kLargestFile / 1'000'000));
  };
  if (about.st_size > static_cast<off_t>(kLargestFile)) too_large();
  std::string text;
  text.resize(static_cast<std::size_t>(about.st_size) + 1);  // one more shows that the file has grown
  std::size_t size = 0;
  while (true) {
    if (size == text.size()) text.resize(2 * size);
    const ssize_t count = read(in.number(), text.data() + size, text.size() - size);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse("the file cannot be read");
    if (count == 0) break;
    size += static_cast<std::size_t>(count);
    if (size > kLargestFile) too_large();
  }
  text.resize(size);
  return text;
}

}  // namespace carom
