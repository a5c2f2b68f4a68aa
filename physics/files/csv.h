#pragma once

#include <string>
#include <string_view>

// The tables that the program writes: CSV files (RFC 4180), and for the clipboard the same with tabs. A header
// with units in brackets, then a line for each row.
namespace carom {

// A number with all its digits, never "-0"; "nan" or "inf" if it is not finite.
[[nodiscard]] std::string csv_number(double value);
// A text, in quotes where it needs them.
[[nodiscard]] std::string csv_text(std::string_view text, char separator = ',');
// "heading [unit]"; a unit's superscripts are written as in m/s^2.
[[nodiscard]] std::string csv_heading(std::string_view heading, std::string_view unit);

// One line of a table, field by field and without its end.
class CsvLine {
 public:
  explicit CsvLine(char separator = ',') : separator_(separator) {}

  CsvLine& add(double value);  // an empty field where it is NaN
  CsvLine& add(std::string_view text) { return add_field(csv_text(text, separator_)); }
  CsvLine& add(const char* text) { return add(std::string_view(text)); }
  CsvLine& add_field(std::string_view field);  // as it stands
  [[nodiscard]] const std::string& text() const { return line_; }

 private:
  char separator_;
  bool first_ = true;
  std::string line_;
};

}  // namespace carom
