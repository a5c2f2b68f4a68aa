#include "physics/files/csv.h"

#include <cmath>
#include <fmt/format.h>

namespace carom {

std::string csv_number(double value) { return fmt::format("{}", value == 0.0 ? 0.0 : value); }

std::string csv_text(std::string_view text, char separator) {
  const char special[] = {separator, '"', '\n', '\r', '\0'};
  if (text.find_first_of(special) == std::string_view::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

std::string csv_heading(std::string_view heading, std::string_view unit) {
  constexpr std::string_view kSquared = "²";
  const std::size_t at = unit.find(kSquared);
  if (at == std::string_view::npos) return fmt::format("{} [{}]", heading, unit);
  return csv_heading(heading, fmt::format("{}^2{}", unit.substr(0, at), unit.substr(at + kSquared.size())));
}

CsvLine& CsvLine::add(double value) { return add_field(std::isnan(value) ? std::string() : csv_number(value)); }

CsvLine& CsvLine::add_field(std::string_view field) {
  if (!first_) line_ += separator_;
  first_ = false;
  line_ += field;
  return *this;
}

}  // namespace carom
