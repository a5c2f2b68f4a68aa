#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

// The words that stand for choices in files.
namespace carom {

template <class Id>
struct Named {
  Id id;
  std::string_view name;
};

// The word for `id`; the tables contain every id.
template <class Id, std::size_t N>
[[nodiscard]] constexpr std::string_view name_of(const std::array<Named<Id>, N>& table, Id id) {
  for (const auto& [known, name] : table) {
    if (known == id) return name;
  }
  return table.front().name;
}

// The words of a table of ids, or of words.
template <class Table>
[[nodiscard]] std::vector<std::string> words_of(const Table& table) {
  std::vector<std::string> words;
  for (const auto& row : table) {
    if constexpr (requires { row.name; }) {
      words.emplace_back(row.name);
    } else {
      words.emplace_back(row);
    }
  }
  return words;
}

template <class Table, class Id>
[[nodiscard]] std::size_t index_of(const Table& table, Id id) {
  std::size_t i = 0;
  while (i + 1 < table.size() && table[i].id != id) ++i;
  return i;
}

}  // namespace carom
