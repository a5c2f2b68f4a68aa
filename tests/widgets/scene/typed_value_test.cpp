#include "widgets/scene/typed_value.h"

#include <gtest/gtest.h>
#include <numbers>

#include "widgets/edit/derived_fields.h"
#include "widgets/scene/new_body.h"
#include "widgets/scene/typed_drawing.h"

// What can be typed at the mouse has the ranges of the fields.
namespace carom {
namespace {

void expect_range(const TypedValue& value, const std::vector<FieldRow>& rows, const FieldPlace& place) {
  for (const FieldRow& row : rows) {
    if (row.place == place) {
      EXPECT_EQ(value.range.text(), row.range.text()) << place.key;
      return;
    }
  }
  ADD_FAILURE() << "no field " << place.key;
}

Body moving_disc() {
  Body body;
  body.name = "A";
  body.shape = Disc{0.1};
  body.mass = 1.0;
  return body;
}

std::vector<TypedValue> values_of(HandleKind kind, const Body& body) {
  DragStart start;
  start.kind = kind;
  start.bodies = {body};
  return typed_body(start, body, 100.0)->values();
}

TEST(TypedValues, OfABodyHaveTheRangesOfItsFields) {
  const Body disc = moving_disc();
  const std::vector<FieldRow> rows = all_rows(disc);
  const auto expect = [&](HandleKind kind, const std::vector<FieldPlace>& places) {
    const std::vector<TypedValue> values = values_of(kind, disc);
    ASSERT_EQ(values.size(), places.size());
    for (std::size_t i = 0; i < places.size(); ++i) expect_range(values[i], rows, places[i]);
  };
  expect(HandleKind::kBody, {{"position", 0}, {"position", 1}});
  expect(HandleKind::kVelocity, {{"speed"}, {"direction"}});
  expect(HandleKind::kTurn, {{"angle"}});
  expect(HandleKind::kSpin, {{"spin"}});
  expect(HandleKind::kRadius, {{"shape/radius"}});
  EXPECT_TRUE(values_of(HandleKind::kRadius, disc)[0].range.contains(0.0)) << "a point-like body";
}

TEST(TypedValues, OfAShapeAreItsSizes) {
  const std::vector<TypedValue> box = typed_sizes(Box{0.4, 0.2});
  ASSERT_EQ(box.size(), 2U);
  EXPECT_EQ(box[0].name, "Width");
  EXPECT_EQ(box[0].value, 0.4);
  EXPECT_EQ(box[1].name, "Height");
  EXPECT_FALSE(box[1].range.contains(0.0));
  EXPECT_EQ(typed_sizes(Wall{.length = 2.0})[0].name, "Length");
  EXPECT_TRUE(typed_sizes(Wall{}).empty()) << "a half-plane";
  EXPECT_TRUE(typed_sizes(Polygon{{Vec2(0.0, 0.0), Vec2(0.5, 0.0), Vec2(0.0, 0.25)}}).empty());
}

TEST(TypedValues, OfAForceAreItsSizeAndDirection) {
  AppliedForce force;
  force.force = Vec2(0.0, -2.0);
  const std::vector<FieldRow> rows = derived_rows(force);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].label, "Size");
  EXPECT_EQ(rows[0].value, FieldValue(2.0));
  EXPECT_FALSE(rows[0].range.contains(0.0)) << "it would have no direction";
  EXPECT_EQ(rows[1].label, "Direction");
  EXPECT_EQ(rows[1].value, FieldValue(-0.5 * std::numbers::pi));
}

TEST(TypedValues, OfADrawnDiscMayBeThatOfAPoint) {
  Drawn drawn;
  drawn.shape = Disc{0.1};
  TypedDrawing drawing("disc", drawn, Vec2::Zero());
  ASSERT_EQ(drawing.values().size(), 1U);
  EXPECT_TRUE(drawing.values()[0].range.contains(0.0));
  (void)drawing.set(0, 0.0, false);
  const Body point = new_body(std::vector{moving_disc()}, drawing.drawn().shape, Vec2::Zero());
  EXPECT_FALSE(point.density);
  EXPECT_EQ(point.mass, 1.0) << "that of the model: no area has a density";
}

}  // namespace
}  // namespace carom
