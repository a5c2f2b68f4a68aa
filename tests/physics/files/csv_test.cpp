#include "physics/files/csv.h"

#include <gtest/gtest.h>
#include <limits>

namespace carom {
namespace {

TEST(Csv, ALineHasAllDigitsAndNoNegativeZero) {
  CsvLine line;
  line.add(0.1 + 0.2).add(-0.0).add(std::numeric_limits<double>::quiet_NaN()).add("plain").add("a, \"b\"");
  EXPECT_EQ(line.text(), "0.30000000000000004,0,,plain,\"a, \"\"b\"\"\"");
}

TEST(Csv, AnEmptyFirstFieldKeepsItsSeparator) {
  EXPECT_EQ(CsvLine('\t').add("").add("a,b").add("tab\t").text(), "\ta,b\t\"tab\t\"");
}

TEST(Csv, UnitsStandInBracketsWithoutSuperscripts) {
  EXPECT_EQ(csv_heading("angular momentum", "kg m²/s"), "angular momentum [kg m^2/s]");
  EXPECT_EQ(csv_heading("x", "m²/s²"), "x [m^2/s^2]");
}

}  // namespace
}  // namespace carom
