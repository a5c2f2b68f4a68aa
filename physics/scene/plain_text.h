#pragma once

#include <cstddef>
#include <string>
#include <string_view>

// Makes texts from outside (names in files, file names, arguments) safe to show.
namespace carom {

// The text made safe for a terminal. Control characters, bidirectional marks and bytes that are not UTF-8 are
// replaced by escapes such as \x1b, \u202e, \xff.
[[nodiscard]] std::string printable(std::string_view text);

// Longest file name in a message, in bytes.
inline constexpr std::size_t kMostOfFileName = 200;

// The same; a text longer than `most` bytes is cut after a whole character and ends in "...".
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most = 60);

// The text with each byte that is not UTF-8 replaced by U+FFFD.
[[nodiscard]] std::string valid_utf8(std::string_view text);

// The number of UTF-8 characters.
[[nodiscard]] std::size_t characters(std::string_view text);

// Index of the first byte that is not UTF-8; the text's length if there is none.
[[nodiscard]] std::size_t first_bad_byte(std::string_view text);

}  // namespace carom
