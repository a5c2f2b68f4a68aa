#include <cmath>
#include <numbers>

#include "tests/widgets/edit/inspector_fixture.h"
#include "widgets/edit/slider_scale.h"
#include "widgets/edit/value_slider.h"

namespace carom {
namespace {

TEST(SliderScale, IsLogarithmicForWhatIsPositive) {
  const SliderScale mass = slider_scale(positive("kg"), 1.0);
  EXPECT_EQ(mass.value_at(0.0), 0.1);
  EXPECT_EQ(mass.value_at(0.5), 1.0);
  EXPECT_EQ(mass.value_at(1.0), 10.0);
  EXPECT_DOUBLE_EQ(mass.place_of(1.0), 0.5);
  EXPECT_EQ(mass.value_at(0.75), 3.16);
}

TEST(SliderScale, StartsInTheMiddleForWhatHasASign) {
  const SliderScale spin = slider_scale(any_number("rad/s"), 0.0);
  EXPECT_EQ(spin.place_of(0.0), 0.5);
  EXPECT_EQ(spin.value_at(0.0), -20.0);
  EXPECT_EQ(spin.value_at(0.505), 0.2);
  const SliderScale angle = slider_scale(any_number("rad"), 0.0);
  EXPECT_EQ(angle.value_at(0.75), std::numbers::pi / 2.0);
  const SliderScale e = slider_scale(kRestitutionRange, 0.5);
  EXPECT_EQ(e.value_at(0.3), 0.3);
}

TEST(SliderScale, StretchesToALargerValueWithinTheRange) {
  EXPECT_EQ(slider_scale(positive("kg"), 50.0).high, 50.0);
  EXPECT_EQ(slider_scale(positive("kg"), 0.01).low, 0.01);
  EXPECT_EQ(slider_scale(any_number("m/s²"), -30.0).low, -30.0);
  EXPECT_EQ(slider_scale(kTangentialRestitution, 0.0).low, -1.0);
  // A point-like disc.
  const SliderScale radius = slider_scale(kDiscRadiusRange, 0.0);
  EXPECT_EQ(radius.place_of(0.0), 0.0);
  EXPECT_GT(radius.value_at(0.0), 0.0);
}

class SliderTest : public InspectorTest {
 protected:
  ValueSlider* slider(const QString& name) {
    QTest::qWait(20);  // laid out
    for (ValueSlider* each : inspector_.findChildren<ValueSlider*>()) {
      if (each->accessibleName() == name && each->isVisibleTo(&inspector_)) return each;
    }
    ADD_FAILURE() << "no slider " << name.toStdString();
    return nullptr;
  }
  static QPoint at(const ValueSlider* slider, double place) {
    return {static_cast<int>(std::lround(7 + place * (slider->width() - 14))), slider->height() / 2};
  }
};

TEST_F(SliderTest, APullIsOneEdit) {
  select({"light"});
  ValueSlider* mass = slider("Mass, kg");
  QTest::mousePress(mass, Qt::LeftButton, {}, at(mass, 0.5));
  EXPECT_TRUE(made_.empty()) << "a press on the knob moves nothing";
  QTest::mouseMove(mass, at(mass, 0.7));
  QTest::mouseMove(mass, at(mass, 1.0) + QPoint(30, 0));
  QTest::mouseRelease(mass, Qt::LeftButton, {}, at(mass, 1.0));
  ASSERT_EQ(made_.size(), 2U);
  EXPECT_EQ(light().mass, 10.0);
  EXPECT_GT(made_[0].drag, 0);
  EXPECT_EQ(made_[1].drag, made_[0].drag);
  EXPECT_EQ(made_[1].name, "Mass of light 1.00 → 10.0 kg");
  QTest::mouseClick(mass, Qt::LeftButton, {}, at(mass, 0.5));
  EXPECT_NEAR(*light().mass, 1.0, 0.1);
  EXPECT_NE(made_.back().drag, made_[0].drag);
}

TEST_F(SliderTest, EscapeTakesAPullBack) {
  select({"light"});
  ValueSlider* spin = slider("Spin, rad/s");
  QTest::mousePress(spin, Qt::LeftButton, {}, at(spin, 0.5));
  QTest::mouseMove(spin, at(spin, 0.8));
  EXPECT_GT(light().spin, 0.0);
  QTest::keyClick(spin, Qt::Key_Escape);
  EXPECT_EQ(light().spin, 0.0);
  QTest::mouseMove(spin, at(spin, 0.9));
  EXPECT_EQ(light().spin, 0.0);
}

TEST_F(SliderTest, ASpeedPulledThroughZeroKeepsItsDirection) {
  Body up = light();
  up.velocity = Vec2(0.0, 2.0);
  apply({Replace<Body>{up}});
  select({"light"});
  ValueSlider* speed = slider("Speed, m/s");
  QTest::mousePress(speed, Qt::LeftButton, {}, at(speed, 0.4));
  QTest::mouseMove(speed, at(speed, 0.0));
  EXPECT_TRUE(light().velocity.isZero(0.0));
  QTest::mouseMove(speed, at(speed, 1.0));
  QTest::mouseRelease(speed, Qt::LeftButton, {}, at(speed, 1.0));
  EXPECT_EQ(light().velocity, Vec2(0.0, 5.0));
}

TEST_F(SliderTest, BodiesThatDifferAreTypedFirst) {
  select({"light", "heavy"});
  EXPECT_FALSE(slider("Mass, kg")->isEnabled());
  enter(field("Mass, kg"), "20");
  EXPECT_TRUE(slider("Mass, kg")->isEnabled());
  EXPECT_EQ(slider("Mass, kg")->value(), slider("Mass, kg")->maximum()) << "the scale stretches";
}

}  // namespace
}  // namespace carom
