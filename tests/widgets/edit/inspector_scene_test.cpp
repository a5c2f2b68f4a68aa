#include <QScrollArea>
#include <QScrollBar>

#include "tests/widgets/edit/inspector_fixture.h"

namespace carom {
namespace {

class InspectorSceneTest : public InspectorTest {
 protected:
  InspectorSceneTest() { select({}); }
};

TEST_F(InspectorSceneTest, GravityOfAPlanet) {
  EXPECT_EQ(box("Gravity of")->currentText(), "Earth 9.81");
  choose_below(box("Gravity of"));
  EXPECT_EQ(scene_->forces.gravity, Vec2(0.0, -1.62));
  EXPECT_EQ(made_.back().name, "Gravity 9.81 → 1.62 m/s²");
  choose_below(box("Gravity of"), 2);
  EXPECT_TRUE(scene_->forces.gravity.isZero(0.0));
  enter(field("Gravity, m/s²"), "1");
  EXPECT_EQ(scene_->forces.gravity, Vec2(0.0, -1.0)) << "downwards again";
  EXPECT_EQ(box("Gravity of")->currentIndex(), -1);
}

TEST_F(InspectorSceneTest, GravityHasASizeAndADirection) {
  EXPECT_EQ(field("Gravity, m/s²")->text(), "9.81");
  EXPECT_EQ(field("Direction of gravity, °")->text(), "−90");
  enter(field("Direction of gravity, °"), "-60");
  EXPECT_EQ(made_.back().name, "Direction of gravity −90.0 → −60.0°");
  EXPECT_NEAR(scene_->forces.gravity.x(), 0.5 * 9.81, 1e-12);
  EXPECT_EQ(box("Gravity of")->currentText(), "Earth 9.81");
  choose_below(box("Gravity of"));
  EXPECT_NEAR(scene_->forces.gravity.x(), 0.5 * 1.62, 1e-12) << "the direction stays";
  enter(field("Gravity, m/s²"), "-1");
  EXPECT_TRUE(sentences().isEmpty());
  EXPECT_TRUE(scene_->forces.gravity.isApprox(Vec2(-0.5, std::sqrt(0.75)), 1e-12)) << "turned round";
  EXPECT_EQ(field("Gravity, m/s²")->text(), "1");
  EXPECT_EQ(field("Direction of gravity, °")->text(), "120");
  enter(field("Gravity, m/s²"), "0");
  enter(field("Direction of gravity, °"), "-90");
  EXPECT_EQ(sentences(), QStringList{"Without gravity there is no direction: its size comes first."});
}

TEST_F(InspectorSceneTest, TheDurationAndTheStopsStandWithTheScene) {
  EXPECT_FALSE(has_field("Duration, s"));
  double duration = 0.0;
  QString name;
  int stops_asked = 0;
  QObject::connect(&inspector_, &Inspector::durationEdited, [&](double seconds, const QString& text, int) {
    duration = seconds;
    name = text;
  });
  QObject::connect(&inspector_, &Inspector::stopsAsked, [&] { ++stops_asked; });
  inspector_.show_duration_and_stops({.duration = 5.0});
  EXPECT_EQ(field("Duration, s")->text(), "5");
  EXPECT_TRUE(texts().contains("none"));
  enter(field("Duration, s"), "8");
  EXPECT_EQ(duration, 8.0);
  EXPECT_EQ(name, "Duration 5.00 → 8.00 s");
  EXPECT_TRUE(made_.empty()) << "it is no edit of the scene";
  enter(field("Duration, s"), "0");
  EXPECT_EQ(sentences(), QStringList{"Duration is more than 0."});
  inspector_.show_duration_and_stops({.duration = 8.0, .stops = {"at 2.5 s", "when all is at rest"}});
  EXPECT_TRUE(texts().contains("at 2.5 s\nwhen all is at rest"));
  QTest::mouseClick(button("Edit the stops"), Qt::LeftButton);
  EXPECT_EQ(stops_asked, 1);
  select({"light"});
  EXPECT_FALSE(has_field("Duration, s"));
}

TEST_F(InspectorSceneTest, LawsOfImpacts) {
  EXPECT_EQ(box("Impact law")->currentText(), "energetic");
  EXPECT_TRUE(box("Impact law")->toolTip().contains("gives back"));
  choose_below(box("Impact law"));
  EXPECT_EQ(scene_->impact_law, ImpactLawId::kNewton);
  EXPECT_EQ(made_.back().name, "Impact law: Newton");
  choose_below(box("Several impacts"));
  EXPECT_EQ(scene_->several_impacts, SeveralImpactsId::kSimultaneous);
  EXPECT_EQ(scene_->impact_law, ImpactLawId::kNewton);
}

TEST_F(InspectorSceneTest, AttractionIsAddedAndRemoved) {
  EXPECT_FALSE(has_field("Constant G, N m²/kg²"));
  choose_below(box("Attraction"));
  ASSERT_TRUE(scene_->forces.attraction.has_value());
  EXPECT_TRUE(box("Attraction")->hasFocus()) << "although rows were added";
  enter(field("Constant G, N m²/kg²"), "2.5");
  EXPECT_EQ(scene_->forces.attraction->constant, 2.5);
  EXPECT_EQ(made_.back().name, "Constant G 1.00 → 2.50 N m²/kg²");
  enter(field("Softening, m"), "-1 cm");
  EXPECT_EQ(sentences(), QStringList{"Softening is 0 or more."});
  box("Attraction")->setFocus();
  QTest::keyClick(box("Attraction"), Qt::Key_Up);
  EXPECT_FALSE(scene_->forces.attraction.has_value());
}

TEST_F(InspectorSceneTest, ASurfaceThatIsUsedStays) {
  QTest::mouseClick(button("Remove surface wood"), Qt::LeftButton);
  EXPECT_EQ(sentences(), QStringList{"wood is the surface of light and 1 more."});
  EXPECT_TRUE(made_.empty());
  QTest::mouseClick(button("Remove surface rubber"), Qt::LeftButton);
  EXPECT_EQ(made_.back().name, "Remove surface rubber");
  EXPECT_EQ(scene_->materials.size(), 1U);
  QTest::mouseClick(button("Add a surface"), Qt::LeftButton);
  EXPECT_EQ(scene_->materials.back().name, "surface 2");
  enter(field("Name of surface surface 2"), "ice");
  EXPECT_EQ(scene_->materials.back().name, "ice");
  enter(field("Name of surface ice"), " ");
  EXPECT_TRUE(sentences().contains("A surface has a name."));
}

TEST_F(InspectorSceneTest, APairHasALawOfItsOwn) {
  QTest::mouseClick(button("Add a pair"), Qt::LeftButton);
  ASSERT_EQ(scene_->pairs.size(), 1U);
  EXPECT_EQ(made_.back().name, "Add pair wood on rubber");
  EXPECT_EQ(scene_->pairs[0].surface.restitution, 0.6) << "as they combined before";
  enter(field("e of wood on rubber"), "0.9");
  EXPECT_EQ(made_.back().name, "e of wood on rubber 0.600 → 0.900");
  EXPECT_EQ(combined_material(*scene_, "rubber", "wood").restitution, 0.9);
  enter(field("e of wood on rubber"), "2");
  EXPECT_EQ(sentences(), QStringList{"e lies between 0 and 1."});
  enter(field("µ of wood on rubber"), "0.4");
  EXPECT_EQ(scene_->pairs[0].surface.static_friction, 0.4);
  choose_below(box("Second of wood on rubber"));
  EXPECT_EQ(scene_->pairs[0].b, "default");
  EXPECT_EQ(made_.back().name, "Pair wood on rubber → wood on default");
  choose_below(box("Sticking of wood on default"));
  EXPECT_TRUE(scene_->pairs[0].surface.sticks);
  QTest::mouseClick(button("Remove pair wood on default"), Qt::LeftButton);
  EXPECT_TRUE(scene_->pairs.empty());
}

TEST_F(InspectorSceneTest, OnlyHereGivesABodyASurfaceOfItsOwn) {
  QTest::mouseClick(button("Add a pair"), Qt::LeftButton);
  select({"light"});
  QTest::mouseClick(button("Only here"), Qt::LeftButton);
  EXPECT_EQ(made_.back().name, "Surface of light: wood 2");
  EXPECT_EQ(light().material, "wood 2");
  EXPECT_EQ(heavy().material, "wood");
  ASSERT_EQ(scene_->pairs.size(), 2U) << "it meets rubber as wood does";
  EXPECT_EQ(scene_->pairs[1].a, "wood 2");
  enter(field("e of wood 2"), "0.2");
  EXPECT_EQ(material_named(*scene_, "wood").restitution, 0.6);
  EXPECT_EQ(material_named(*scene_, "wood 2").restitution, 0.2);
  select({"light", "heavy"});
  EXPECT_FALSE(has_field("e of wood"));
}

TEST_F(InspectorSceneTest, AnotherObjectIsShownFromItsTop) {
  inspector_.resize(320, 200);
  select({"light"});
  QScrollBar* bar = inspector_.findChild<QScrollArea*>()->verticalScrollBar();
  QApplication::processEvents();
  ASSERT_GT(bar->maximum(), 0);
  bar->setValue(bar->maximum());
  select({"light"});
  EXPECT_EQ(bar->value(), bar->maximum()) << "the same one stays";
  select({"heavy"});
  EXPECT_EQ(bar->value(), 0);
}

}  // namespace
}  // namespace carom
