#pragma once

#include <cstddef>
#include <string>
#include <string_view>

// Texts that others wrote, such as names in files, file names and arguments, on their way to people.
namespace carom {

// The text as a terminal may show it: what would move the cursor, change colours or turn the direction of
// writing, and bytes that are no UTF-8, stand there as \x1b, \u202e, \xff.
[[nodiscard]] std::string printable(std::string_view text);

// Bytes of a file's name that a message shows.
inline constexpr std::size_t kMostOfFileName = 200;

// The same, on one line, and cut behind a whole character where the text is longer than `most` bytes.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most = 60);

// The text with U+FFFD in place of each byte that is no UTF-8.
[[nodiscard]] std::string valid_utf8(std::string_view text);

// The number of characters of UTF-8.
[[nodiscard]] std::size_t characters(std::string_view text);

// The first byte that is no part of UTF-8; the text's length if there is none.
[[nodiscard]] std::size_t first_bad_byte(std::string_view text);

}  // namespace carom
