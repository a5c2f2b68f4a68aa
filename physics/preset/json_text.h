#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace carom {

// Keys keep the order in which people write them.
using Json = nlohmann::ordered_json;

// Nesting deeper than this is refused: a preset needs five levels.
inline constexpr int kDeepestNesting = 64;

// Elements of one array and keys of one object beyond this are refused.
inline constexpr std::size_t kMostMembers = 1'000'000;

// Parses JSON strictly: duplicate keys, too deep nesting, too many members, numbers beyond double, NUL and
// bytes that are not UTF-8 are errors too. Takes n log n time in the text's length. Throws SceneError, one
// line with the line and column of the place, or its JSON pointer.
[[nodiscard]] Json parse_json(std::string_view text);

// A value as an error message quotes it: compact and short.
[[nodiscard]] std::string quoted(const Json& value);

// A key, escaped as a part of a JSON pointer.
[[nodiscard]] std::string pointer_token(std::string_view key);

}  // namespace carom
