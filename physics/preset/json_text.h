#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace carom {

// Keys keep the order that people write them in.
using Json = nlohmann::ordered_json;

// Nesting deeper than this is refused: a preset needs five levels.
inline constexpr int kDeepestNesting = 64;

// Parses JSON strictly: duplicate keys, too deep nesting and numbers beyond double are errors too.
// Throws SceneError, one line with the line and column of a syntax error or the JSON pointer of the place.
[[nodiscard]] Json parse_json(std::string_view text);

// A value as an error message quotes it: compact and short.
[[nodiscard]] std::string quoted(const Json& value);

}  // namespace carom
