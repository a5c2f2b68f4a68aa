#include "app/text_table.h"

#include <algorithm>

#include "app/standard_output.h"

namespace carom {
namespace {

// Characters, not bytes: names and units are UTF-8.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string padded(const std::string& text, std::size_t width, Align align) {
  const std::string blanks(width - std::min(width, width_of(text)), ' ');
  return align == Align::kLeft ? text + blanks : blanks + text;
}

}  // namespace

void print_table(const std::vector<std::vector<std::string>>& rows, std::span<const Align> columns) {
  std::vector<std::size_t> widths(columns.size());
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t c = 0; c < columns.size(); ++c) widths[c] = std::max(widths[c], width_of(row[c]));
  }
  for (const std::vector<std::string>& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < columns.size(); ++c) line += padded(row[c], widths[c], columns[c]) + "  ";
    line.erase(line.find_last_not_of(' ') + 1);
    print_out("{}\n", line);
  }
}

}  // namespace carom
