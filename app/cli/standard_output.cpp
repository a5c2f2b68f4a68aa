#include "app/cli/standard_output.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <poll.h>
#include <system_error>
#include <unistd.h>

#include "physics/scene/plain_text.h"

namespace carom {

void prepare_process() {
  // open() takes the lowest free descriptor, so these are 0, 1 and 2; the first two cannot be written.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) < 0 && errno == EBADF)
      (void)open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void write_out(std::string_view text) { (void)std::fwrite(text.data(), 1, text.size(), stdout); }

std::optional<std::string> finish_stdout() {
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return std::nullopt;
  const int error = errno;
  pollfd reader = {STDOUT_FILENO, POLLOUT, 0};
  if (error == EPIPE || (poll(&reader, 1, 0) == 1 && (reader.revents & POLLERR) != 0)) return "";
  const std::string why = error == 0 ? "" : fmt::format(" ({})", std::generic_category().message(error));
  return fmt::format(
      "stdout: not everything could be written{}; allowed: a place with room and the right to write", why);
}

void write_err(std::string_view text) { (void)std::fwrite(text.data(), 1, text.size(), stderr); }

void print_error(const std::string& line) {
  // Keeps the name at the front and the error at the end.
  constexpr std::size_t kFront = 600;
  constexpr std::size_t kEnd = 300;
  const bool whole = line.size() <= kFront + kEnd;
  const std::string end = whole ? "" : printable(line.substr(line.size() - kEnd));
  write_err(whole ? fmt::format("carom: {}\n", printable(line))
                  : fmt::format("carom: {} {}\n", shortened(line, kFront), end));
}

}  // namespace carom
