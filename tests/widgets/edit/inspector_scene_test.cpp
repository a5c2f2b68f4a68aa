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
  enter(field("Gravity x, m/s²"), "1");
  EXPECT_EQ(box("Gravity of")->currentIndex(), -1);
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
