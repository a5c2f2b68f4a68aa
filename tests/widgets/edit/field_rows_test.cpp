#include "widgets/edit/field_rows.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

const FieldRow* row_at(const std::vector<FieldRow>& rows, const std::string& key, int part = -1) {
  for (const FieldRow& row : rows) {
    if (row.place == FieldPlace{key, part}) return &row;
  }
  return nullptr;
}

// Each number that is listed can be set, alone.
template <class T>
void expect_settable(const T& value) {
  const std::vector<FieldRow> rows = field_rows(value);
  EXPECT_FALSE(rows.empty());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool flag = std::holds_alternative<bool>(rows[i].value);
    const FieldValue set = flag ? FieldValue(!std::get<bool>(rows[i].value)) : FieldValue(0.375);
    const std::vector<FieldRow> after = field_rows(with_field(value, rows[i].place, set));
    EXPECT_FALSE(rows[i].meaning.isEmpty()) << rows[i].place.key;
    EXPECT_FALSE(rows[i].label.isEmpty()) << rows[i].place.key;
    for (const FieldRow& row : after) {
      const FieldRow* before = row_at(rows, row.place.key, row.place.part);
      ASSERT_NE(before, nullptr) << row.place.key;
      EXPECT_EQ(row.value, row.place == rows[i].place ? set : before->value)
          << row.place.key << " after " << rows[i].place.key;
    }
  }
}

Body disc() {
  Body body;
  body.name = "A";
  body.mass = 2.0;
  body.inertia = 0.5;
  body.velocity = Vec2(1.0, 2.0);
  body.spin = 3.0;
  return body;
}

TEST(FieldRows, EachNumberCanBeSet) {
  expect_settable(Material{});
  expect_settable(Spring{});
  expect_settable(AppliedForce{});
  Body box = disc();
  box.shape = Box{};
  Body driven = disc();
  driven.drive = Drive{};
  Body wall = disc();
  wall.shape = Wall{.length = 2.0};
  Body compound = disc();
  compound.shape = Compound{{{Disc{0.2}, Vec2(0.0, 0.3), 0.1, {}}, {Box{0.5, 0.1}, Vec2::Zero(), 0.0, "wood"}}};
  Body polygon = disc();
  polygon.shape = Polygon{{Vec2(0.0, 0.0), Vec2(0.5, 0.0), Vec2(0.0, 0.25)}};
  EXPECT_EQ(field_rows(with_field(polygon, {"shape/vertices/2", 1}, 0.75)).size(), field_rows(polygon).size());
  for (const Body& body : {box, driven, wall, compound, polygon}) expect_settable(body);
  for (const JointKind kind : {JointKind::kRod, JointKind::kString, JointKind::kPin, JointKind::kWeld}) {
    Joint joint;
    joint.kind = kind;
    expect_settable(joint);
  }
}

TEST(FieldRows, SaysRangesAndUnitsAsTheDescriptionHasThem) {
  const std::vector<FieldRow> rows = field_rows(disc());
  const FieldRow* mass = row_at(rows, "mass");
  ASSERT_NE(mass, nullptr);
  EXPECT_EQ(mass->label, "Mass");
  EXPECT_EQ(mass->range.unit, "kg");
  EXPECT_EQ(mass->range.low, kLeastPositive);
  EXPECT_EQ(std::get<double>(mass->value), 2.0);
  const FieldRow* radius = row_at(rows, "shape/radius");
  ASSERT_NE(radius, nullptr);
  EXPECT_EQ(radius->label, "Radius");
  EXPECT_TRUE(radius->range.or_zero);
  ASSERT_NE(row_at(rows, "velocity", 1), nullptr);
  EXPECT_EQ(row_at(rows, "velocity", 1)->label, "Velocity y");
  EXPECT_EQ(std::get<double>(row_at(rows, "velocity", 1)->value), 2.0);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(row_at(rows, "density")->value));
  EXPECT_FALSE(std::get<bool>(row_at(rows, "fixed")->value));

  const std::vector<FieldRow> surface = field_rows(Material{});
  EXPECT_EQ(row_at(surface, "restitution")->label, "Restitution e");
  EXPECT_EQ(row_at(surface, "restitution")->range.high, kRestitutionRange.high);
}

TEST(FieldRows, AnOptionalNumberCanBeTakenBack) {
  const Body body = with_field(disc(), {"mass", -1}, std::monostate{});
  EXPECT_FALSE(body.mass.has_value());
}

TEST(FieldRows, SetsNothingThatIsNotThereOrOfAnotherKind) {
  EXPECT_EQ(field_rows(with_field(disc(), {"shape/width", -1}, 2.0)).size(), field_rows(disc()).size());
  EXPECT_FALSE(with_field(disc(), {"fixed", -1}, 1.0).fixed);
  EXPECT_EQ(with_field(disc(), {"spin", -1}, true).spin, 3.0);
}

}  // namespace
}  // namespace carom
