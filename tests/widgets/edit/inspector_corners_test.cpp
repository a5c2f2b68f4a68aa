#include <QToolButton>
#include <cmath>

#include "tests/widgets/edit/inspector_fixture.h"
#include "widgets/base/plain_text.h"

// The corners of polygons in the inspector.
namespace carom {
namespace {

// By hand, apart from the code under test.
Vec2 turned(double angle, const Vec2& v) {
  return {std::cos(angle) * v.x() - std::sin(angle) * v.y(), std::sin(angle) * v.x() + std::cos(angle) * v.y()};
}
Vec2 mean(const Vec2& a, const Vec2& b, const Vec2& c) { return (a + b + c) / 3.0; }

// A triangle "light" whose corners are written about a point outside of it, turned and spinning.
class InspectorCornersTest : public InspectorTest {
 protected:
  InspectorCornersTest() { show(Polygon{{Vec2(1.0, 1.0), Vec2(1.6, 1.0), Vec2(1.0, 1.3)}}); }

  void show(const Shape& shape) {
    Body body = light();
    body.shape = shape;
    body.angle = 0.7;
    body.spin = 3.0;
    apply({Replace<Body>{body}});
    select({"heavy"});
    select({"light"});
  }
  const Polygon& polygon() { return std::get<Polygon>(light().shape); }
  // m: of a triangle.
  Vec2 in_scene(const Vec2& corner) {
    const auto& v = polygon().vertices;
    return light().position + turned(light().angle, corner - mean(v[0], v[1], v[2]));
  }
  QToolButton* small_button(const QString& name) {
    for (QToolButton* each : inspector_.findChildren<QToolButton*>()) {
      if (each->accessibleName() == name && each->isVisibleTo(&inspector_)) return each;
    }
    ADD_FAILURE() << "no button " << name.toStdString();
    return nullptr;
  }
};

TEST_F(InspectorCornersTest, ListsTheCornersAsTheyAreWritten) {
  label("Corner 3");
  EXPECT_EQ(field("Corner 2 x, m")->text(), "1.6");
  EXPECT_EQ(field("Corner 3 y, m")->text(), "1.3");
  EXPECT_FALSE(has_field("Corner 4 x, m"));
  select({"heavy"});
  EXPECT_FALSE(has_field("Corner 1 x, m"));
}

TEST_F(InspectorCornersTest, AnEditLeavesTheOtherCornersWhereTheyAre) {
  const Vec2 first = in_scene(Vec2(1.0, 1.0));
  const Vec2 third = in_scene(Vec2(1.0, 1.3));
  const Vec2 wanted = in_scene(Vec2(2.2, 1.0));
  const Body before = light();
  enter(field("Corner 2 x, m"), "220 cm");
  ASSERT_EQ(made_.size(), 1U);
  EXPECT_EQ(made_[0].name, "Corner 2 of light");
  EXPECT_EQ(polygon().vertices[1], Vec2(2.2, 1.0));
  EXPECT_LT((in_scene(Vec2(1.0, 1.0)) - first).norm(), 1e-12);
  EXPECT_LT((in_scene(Vec2(1.0, 1.3)) - third).norm(), 1e-12);
  EXPECT_LT((in_scene(Vec2(2.2, 1.0)) - wanted).norm(), 1e-12);
  // What it is drawn by says the same.
  const Outline drawn = outline_of(light().shape);
  EXPECT_LT((light().position + turned(0.7, drawn.vertices[0]) - first).norm(), 1e-12);
  // It moves as before: the corner at rest in the body has v + ω × r.
  const auto velocity_at = [](const Body& body, const Vec2& place) {
    const Vec2 arm = place - body.position;
    return Vec2(body.velocity + body.spin * Vec2(-arm.y(), arm.x()));
  };
  EXPECT_LT((velocity_at(light(), first) - velocity_at(before, first)).norm(), 1e-12);
  EXPECT_NEAR(*light().mass / area(light().shape), *before.mass / area(before.shape), 1e-12);
}

TEST_F(InspectorCornersTest, TheRodStaysAtItsPointOfTheBody) {
  Joint rod = scene_->joints[0];
  rod.point = Vec2(0.1, 0.05);
  apply({Replace<Joint>{rod}});
  select({"heavy"});
  select({"light"});
  const Vec2 before = light().position + turned(0.7, rod.point);
  enter(field("Corner 2 x, m"), "*2");
  EXPECT_EQ(polygon().vertices[1].x(), 3.2);
  EXPECT_LT((light().position + turned(0.7, scene_->joints[0].point) - before).norm(), 1e-12);
}

TEST_F(InspectorCornersTest, SaysInPlaceWhatIsNoPolygon) {
  show(Polygon{{Vec2(0.0, 0.0), Vec2(1.0, 0.0), Vec2(1.0, 1.0), Vec2(0.0, 1.0)}});
  enter(field("Corner 1 x, m"), "2");
  EXPECT_TRUE(made_.empty());
  EXPECT_EQ(sentences(), QStringList{"Corner 1 can't be there: edges that cross are not allowed."});
  type(field("Corner 1 x, m"), "0");
  QTest::keyClick(field("Corner 1 x, m"), Qt::Key_Return);
  EXPECT_TRUE(sentences().empty());
  show(Polygon{{Vec2(0.0, 0.0), Vec2(1.0, 0.0), Vec2(1.0, 1.0), Vec2(0.0, 1.0)}, 0.1});
  enter(field("Corner 1 x, m"), "0.75");
  enter(field("Corner 1 y, m"), "0.5");
  ASSERT_EQ(sentences().size(), 1);
  EXPECT_TRUE(sentences()[0].startsWith("Corner 1 can't be there: a reentrant corner at [0.75, 0.5]"))
      << sentences()[0].toStdString();
}

TEST_F(InspectorCornersTest, ArrowKeysStepACorner) {
  QLineEdit* x = field("Corner 2 x, m");
  x->setFocus();
  QTest::keyClick(x, Qt::Key_Up);
  QTest::keyClick(x, Qt::Key_Up);
  ASSERT_EQ(made_.size(), 2U);
  EXPECT_EQ(polygon().vertices[1].x(), 1.8);
  EXPECT_EQ(made_[0].drag, made_[1].drag);
  EXPECT_GT(made_[0].drag, 0);
}

TEST_F(InspectorCornersTest, AddsACornerInTheMiddleOfItsEdgeAndRemovesIt) {
  const Vec2 place = light().position;
  EXPECT_FALSE(small_button("Remove corner 1")->isEnabled());
  EXPECT_EQ(small_button("Remove corner 1")->toolTip(),
            plain_tip("A polygon without a rounding has at least 3 corners."));
  small_button("Add a corner after corner 3")->click();
  ASSERT_EQ(made_.size(), 1U);
  EXPECT_EQ(made_[0].name, "Add a corner to light");
  ASSERT_EQ(polygon().vertices.size(), 4U);
  EXPECT_EQ(polygon().vertices[3], Vec2(1.0, 1.15));
  EXPECT_LT((light().position - place).norm(), 1e-15);
  EXPECT_TRUE(has_field("Corner 4 y, m"));
  small_button("Remove corner 4")->click();
  EXPECT_EQ(made_.back().name, "Remove corner 4 of light");
  EXPECT_EQ(polygon().vertices.size(), 3U);
}

TEST_F(InspectorCornersTest, FoldsAListOfMany) {
  Polygon nonagon;
  for (int k = 0; k < 9; ++k) nonagon.vertices.push_back(turned(2.0 * M_PI * k / 9.0, Vec2(1.0, 0.0)));
  show(nonagon);
  EXPECT_FALSE(has_field("Corner 1 x, m"));
  button("Show 9 corners")->click();
  EXPECT_TRUE(has_field("Corner 9 x, m"));
  enter(field("Corner 1 x, m"), "1.1");
  EXPECT_TRUE(has_field("Corner 9 x, m"));
  button("Fold 9 corners")->click();
  EXPECT_FALSE(has_field("Corner 9 x, m"));
}

// A triangle of 1/2 m² in a compound with a box of 1 m².
TEST_F(InspectorCornersTest, AShapeOfACompoundKeepsItsOtherCornersAndTheOtherShape) {
  const std::vector<Vec2> corners{Vec2(0.0, 0.0), Vec2(1.0, 0.0), Vec2(0.0, 1.0)};
  show(Compound{{{Polygon{corners}, Vec2(0.2, 0.1), 0.4, {}}, {Box{1.0, 1.0}, Vec2(-2.0, 0.0), 0.0, {}}}});
  const auto corner_and_box = [this](double size) {
    const auto& shapes = std::get<Compound>(light().shape).shapes;
    const auto& v = std::get<Polygon>(shapes[0].shape).vertices;
    const Vec2 centre = (size * shapes[0].position + shapes[1].position) / (size + 1.0);
    const Vec2 corner = shapes[0].position + turned(0.4, v[0] - mean(v[0], v[1], v[2]));
    return std::pair(Vec2(light().position + turned(0.7, corner - centre)),
                     Vec2(light().position + turned(0.7, shapes[1].position - centre)));
  };
  const auto before = corner_and_box(0.5);
  enter(field("Corner 2 x of shape 1, m"), "4");
  ASSERT_EQ(made_.size(), 1U);
  EXPECT_EQ(made_[0].name, "Corner 2 of shape 1 of light");
  const auto after = corner_and_box(2.0);
  EXPECT_LT((after.first - before.first).norm(), 1e-12);
  EXPECT_LT((after.second - before.second).norm(), 1e-12);
  EXPECT_FALSE(small_button("Remove corner 2 of shape 1")->isEnabled());
}

}  // namespace
}  // namespace carom
