#pragma once

#include <fmt/format.h>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

// Stdout and stderr of the commands. Stdout is an output like any file: what cannot be written is an error.
namespace carom {

// For main(), first of all: no file may be opened as descriptor 0, 1 or 2 because a caller has closed that; a
// reader that goes away and a file that grows too large are errors of a write and don't end the process;
// signals that do end it leave no temporary files.
void prepare_process();

// To stdout. A failure is told by finish_stdout().
void write_out(std::string_view text);
template <class... Values>
void print_out(fmt::format_string<Values...> format, Values&&... values) {
  write_out(fmt::format(format, std::forward<Values>(values)...));
}

// Nothing, or what is to be said of a stdout that could not take everything: empty where nobody reads it any
// more, as behind `| head`.
[[nodiscard]] std::optional<std::string> finish_stdout();

// To stderr, which may be gone: then nobody is told.
void write_err(std::string_view text);

// One line on stderr, whatever it holds: what a terminal would not show is escaped, and the middle of a very
// long one is left out.
void print_error(const std::string& line);

}  // namespace carom
