#include "widgets/edit/quantity.h"

#include <QLocale>
#include <gtest/gtest.h>
#include <numbers>

#include "physics/scene/fields.h"
#include "widgets/edit/units.h"

namespace carom {
namespace {

using std::numbers::pi;

struct Good {
  const char* text;
  const char* si;
  double old;
  double value;
};

TEST(Quantity, ReadsWhatPeopleType) {
  const Good cases[] = {
      {"2.5", "kg", 1.0, 2.5},
      {"2,5 kg", "kg", 1.0, 2.5},
      {" 300g ", "kg", 1.0, 0.3},
      {"1.5 t", "kg", 1.0, 1500.0},
      {"30 cm", "m", 1.0, 0.3},
      {"30cm", "m", 1.0, 0.3},
      {"5 mm", "m", 1.0, 0.005},
      {"2 km", "m", 1.0, 2000.0},
      {"-3", "m", 1.0, -3.0},
      {"−0,85 m", "m", 1.0, -0.85},
      {"1e3", "m", 1.0, 1000.0},
      {"1e-3 m", "m", 1.0, 0.001},
      {"45", "rad", 1.0, pi / 4.0},
      {"45°", "rad", 1.0, pi / 4.0},
      {"45 deg", "rad", 1.0, pi / 4.0},
      {"pi/2 rad", "rad", 1.0, pi / 2.0},
      {"0.5 rev", "rad", 1.0, pi},
      {"90 km/h", "m/s", 1.0, 25.0},
      {"20 cm/s", "m/s", 1.0, 0.2},
      {"2 rev/s", "rad/s", 1.0, 4.0 * pi},
      {"60 rpm", "rad/s", 1.0, 2.0 * pi},
      {"180°/s", "rad/s", 1.0, pi},
      {"3", "rad/s", 1.0, 3.0},
      {"20 ms", "s", 1.0, 0.02},
      {"2 min", "s", 1.0, 120.0},
      {"3 kN", "N", 1.0, 3000.0},
      {"2 N·m", "N m", 1.0, 2.0},
      {"2 kg/m²", "kg/m²", 1.0, 2.0},
      {"2 kg/m^2", "kg/m²", 1.0, 2.0},
      {"sqrt(2*g*0.8)", "m/s", 1.0, std::sqrt(2.0 * 9.81 * 0.8)},
      {"sqrt(0,25) m", "m", 1.0, 0.5},
      {"(1,5+1) * 2", "m", 1.0, 5.0},
      {"max(2,3)", "m", 1.0, 3.0},
      {"2×3", "m", 1.0, 6.0},
      {"g", "m/s²", 1.0, 9.81},
      {"-g", "m/s²", 1.0, -9.81},
      {"2*g", "kg", 1.0, 19.62},
      {"2 g", "kg", 1.0, 0.002},
      {"e", "", 1.0, std::numbers::e},
      {"1/3", "", 1.0, 1.0 / 3.0},
      {"*2", "kg", 1.5, 3.0},
      {"/ 2", "kg", 1.5, 0.75},
      {"+10 cm", "m", 1.5, 1.6},
      {"+1", "m", 1.5, 2.5},
      {"+45", "rad", pi, 1.25 * pi},
      {"*2", "rad", pi, 2.0 * pi},
  };
  for (const Good& c : cases) {
    const TypedQuantity typed = typed_quantity(c.text, c.si);
    ASSERT_TRUE(typed.change.has_value()) << c.text << ": " << typed.fault.toStdString();
    EXPECT_TRUE(typed.fault.isEmpty()) << c.text;
    EXPECT_NEAR(typed.change->of(c.old), c.value, 1e-12 * std::abs(c.value)) << c.text;
  }
}

TEST(Quantity, SaysInASentenceWhatItCannotRead) {
  const struct {
    QString text;
    const char* si;
    const char* fault;
  } cases[] = {
      {"", "kg", "A number is missing."},
      {"   ", "kg", "A number is missing."},
      {"*", "kg", "A number is missing."},
      {"two", "kg", "“two” is not known; formulas know g, pi and e."},
      {"2 m", "kg", "“m” is no unit of this; it takes kg, g, t."},
      {"2 km/h", "m", "“km/h” is no unit of this; it takes m, mm, cm, km."},
      {"0.5 m", "", "“m” can't stand here: this is a plain number."},
      {"kg", "kg", "“kg” is not known; formulas know g, pi and e."},
      {"sqrt(2", "m", "A bracket is not closed."},
      {"2+", "m", "The formula ends too soon."},
      {"1,5,2", "m", nullptr},
      {"1.2.3", "m", nullptr},
      {"2 3", "m", nullptr},
      {"a = 3", "m", nullptr},
      {"\"2\"", "m", nullptr},
      {")", "m", nullptr},
      {"1/0", "m", "This formula has no value."},
      {"sqrt(-1)", "m", "This formula has no value."},
      {"/0", "m", "Nothing is divided by 0."},
      {"*2 cm", "m", "A factor has no unit."},
      {QString(300, '1'), "m", "This is too long."},
      {QString(150, '('), "m", nullptr},
      {QString::fromUtf8("½ 漢字 \xF0\x9F\x99\x82"), "m", nullptr},
  };
  for (const auto& c : cases) {
    const TypedQuantity typed = typed_quantity(c.text, c.si);
    EXPECT_FALSE(typed.change.has_value()) << c.text.toStdString();
    EXPECT_TRUE(typed.fault.endsWith('.')) << c.text.toStdString() << ": " << typed.fault.toStdString();
    if (c.fault == nullptr) continue;
    EXPECT_EQ(typed.fault, QString::fromUtf8(c.fault)) << c.text.toStdString();
  }
}

TEST(Quantity, FormulasKnowWhatTheyAreGiven) {
  const std::vector<FormulaNames> names = {{{"m", 2.0}, {"r", 0.1}}, {{"m", 3.0}, {"r", 0.2}}};
  const Range any;
  EXPECT_EQ(typed_values("2*m + r", "Mass", any, {0.0, 0.0}, names).values, (std::vector<double>{4.1, 6.2}));
  EXPECT_EQ(typed_values("+m", "Mass", any, {1.0, 1.0}, names).values, (std::vector<double>{3.0, 4.0}));
  EXPECT_EQ(typed_values("2*v", "Mass", any, {0.0}, names).fault,
            "“v” is not known; formulas know g, pi, e, m and r.");
  // A unit stays a unit.
  EXPECT_EQ(typed_values("2 m", "Position x", {.unit = "m"}, {0.0}, names).values, std::vector<double>{2.0});
  EXPECT_EQ(typed_values("m", "Position x", {.unit = "m"}, {0.0}, names).values, std::vector<double>{2.0});
}

TEST(Quantity, ANumberThatIsTooLargeIsSaidToBe) {
  const Range fraction{.low = 0.0, .high = 1.0};
  EXPECT_EQ(typed_values("1e400", "e", fraction, {0.5}).fault,
            "This number is too large. e lies between 0 and 1.");
  EXPECT_EQ(typed_values("/1e400", "e", fraction, {0.5}).fault,
            "This number is too large. e lies between 0 and 1.");
  EXPECT_EQ(typed_values("1e-400", "e", fraction, {0.5}).fault, "");
}

TEST(Quantity, IsTheSameInEveryLocale) {
  QLocale::setDefault(QLocale(QLocale::German));
  EXPECT_DOUBLE_EQ(typed_quantity("1.5", "m").change->number, 1.5);
  EXPECT_DOUBLE_EQ(typed_quantity("1,5", "m").change->number, 1.5);
  EXPECT_EQ(quantity_text(1234.5, "m"), "1234.5 m");
  QLocale::setDefault(QLocale::c());
}

TEST(Quantity, ShowsTheUnitThatPeopleUseWithoutNoise) {
  EXPECT_EQ(quantity_text(0.1 + 0.2, "m"), "0.3 m");
  EXPECT_EQ(quantity_text(pi / 4.0, "rad"), "45°");
  EXPECT_EQ(quantity_text(2.0, "rad/s"), "2 rad/s");
  EXPECT_EQ(quantity_text(-0.0, "m"), "0 m");
  EXPECT_EQ(quantity_text(-3e-15 * pi / 180.0, "rad"), "0°") << "rounding of a turn";
  EXPECT_EQ(quantity_text(1e-6 * pi / 180.0, "rad"), "1e−6°");
  EXPECT_EQ(quantity_text(-0.85, "m"), "−0.85 m");
  EXPECT_EQ(quantity_text(0.6, ""), "0.6");
  EXPECT_EQ(quantity_text(1.0 / 3.0, "kg"), "0.333333 kg");
  EXPECT_EQ(quantity_text(1e9, "kg"), "1e9 kg");
  EXPECT_EQ(change_text(1.0, 2.0, "kg"), "1.00 → 2.00 kg");
  EXPECT_EQ(change_text(1.0, 1.0001, "kg"), "1.0000 → 1.0001 kg");
}

// What a field shows is read as the same value again.
TEST(Quantity, ReadsWhatItShows) {
  for (const char* si : {"", "m", "kg", "rad", "rad/s", "m/s", "N m", "kg m²", "N s/m", "N m²/kg²", "kg/m²"}) {
    for (const double value : {0.0, 1.5, -2.25e-7, 3.0e11}) {
      const TypedQuantity typed = typed_quantity(quantity_text(value, si), si);
      ASSERT_TRUE(typed.change.has_value()) << si << ": " << typed.fault.toStdString();
      EXPECT_NEAR(typed.change->of(0.0), value, 1e-5 * std::abs(value)) << si;
    }
  }
}

TEST(Quantity, RoundingIsNoValue) {
  EXPECT_EQ(field_text(5.36519e-17, "m"), "0");
  EXPECT_EQ(field_text(-1e-12, "m"), "−1e−12");
}

TEST(Quantity, SaysWhatARangeAllows) {
  EXPECT_EQ(range_sentence("e", 1.2, kRestitutionRange), "e lies between 0 and 1.");
  EXPECT_EQ(range_sentence("Mass", 0.0, positive("kg")), "Mass is more than 0.");
  EXPECT_EQ(range_sentence("Mass", 1e-15, positive("kg")), "Mass is at least 1e−12 kg.");
  EXPECT_EQ(range_sentence("Mass", 1e13, positive("kg")), "Mass is at most 1e12 kg.");
  EXPECT_EQ(range_sentence("Linear drag", -1.0, from_zero("kg/s")), "Linear drag is 0 or more.");
  EXPECT_EQ(range_sentence("Radius", -1.0, kDiscRadiusRange), "Radius is 0 or more.");
  EXPECT_EQ(range_sentence("x", -1e13, any_number("m")), "x is at least −1e12 m.");
}

TEST(ValueOfTyped, IsThatOfAFormulaAndNotOfANumber) {
  const Range speed = from_zero("m/s");
  EXPECT_EQ(value_of_typed("sqrt(2*g*0.8)", speed, {1.0}), "= 3.96182 m/s");
  EXPECT_EQ(value_of_typed("*2", speed, {1.5}), "= 3 m/s");
  EXPECT_EQ(value_of_typed("36 km/h", speed, {1.0}), "= 10 m/s");
  EXPECT_EQ(value_of_typed("*2", speed, {1.0, 2.5}), "= 2 to 5 m/s") << "each its own";
  EXPECT_EQ(value_of_typed("2*v", speed, {1.0}, {{{"v", 3.0}}}), "= 6 m/s");
  for (const char* plain : {"", "2", "2,5", "2 m/s", "-1.5e3", "1e"}) {
    EXPECT_EQ(value_of_typed(plain, speed, {1.0}), "") << plain;
  }
  for (const char* wrong : {"sqrt(", "2*k", "1-2"}) EXPECT_EQ(value_of_typed(wrong, speed, {1.0}), "") << wrong;
  EXPECT_EQ(value_of_typed("2*45", any_number("rad"), {0.0}), "= 90°");
}

}  // namespace
}  // namespace carom
