#include "app/cli/text_table.h"

#include <algorithm>

#include "app/cli/standard_output.h"
#include "physics/scene/plain_text.h"

namespace carom {
namespace {

std::string padded(const std::string& text, std::size_t width, Align align) {
  const std::string blanks(width - std::min(width, characters(text)), ' ');
  return align == Align::kLeft ? text + blanks : blanks + text;
}

}  // namespace

void print_table(const std::vector<std::vector<std::string>>& texts, std::span<const Align> columns) {
  std::vector<std::vector<std::string>> rows = texts;
  for (std::vector<std::string>& row : rows) {
    for (std::string& cell : row) cell = printable(cell);
  }
  std::vector<std::size_t> widths(columns.size());
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t c = 0; c < columns.size(); ++c) widths[c] = std::max(widths[c], characters(row[c]));
  }
  for (const std::vector<std::string>& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < columns.size(); ++c) line += padded(row[c], widths[c], columns[c]) + "  ";
    line.erase(line.find_last_not_of(' ') + 1);
    print_out("{}\n", line);
  }
}

}  // namespace carom
