#pragma once

#include <fmt/format.h>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

// Stdout and stderr of the commands. Stdout is an output like any file: a failed write is an error.
namespace carom {

// Call first in main(). Reserves the descriptors 0, 1 and 2 if the caller has closed them; makes a closed pipe
// and a file that grows too large write errors instead of fatal signals.
void prepare_process();

// Prints to stdout. finish_stdout() reports a failure.
void write_out(std::string_view text);
template <class... Values>
void print_out(fmt::format_string<Values...> format, Values&&... values) {
  write_out(fmt::format(format, std::forward<Values>(values)...));
}

// The error if stdout could not take everything, otherwise nothing; an empty text if its reader is gone, as
// with `| head`.
[[nodiscard]] std::optional<std::string> finish_stdout();

// Prints to stderr; ignores a closed one.
void write_err(std::string_view text);

// Prints one line on stderr: unprintable characters are escaped, and the middle of a very long text is left
// out.
void print_error(const std::string& line);

}  // namespace carom
