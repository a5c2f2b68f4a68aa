#pragma once

#include <span>
#include <string>
#include <vector>

namespace carom {

enum class Align { kLeft, kRight };

// Prints rows of as many cells as there are columns, with aligned columns, two blanks between columns and none
// at the end of a line.
void print_table(const std::vector<std::vector<std::string>>& rows, std::span<const Align> columns);

}  // namespace carom
