#include <QComboBox>
#include <QToolButton>
#include <numbers>

#include "tests/widgets/edit/inspector_fixture.h"

namespace carom {
namespace {

// A rod, a spring to the plane, a weld and a force on light.
class InspectorPartTest : public InspectorTest {
 protected:
  InspectorPartTest() {
    Spring spring;
    spring.body = "light";
    spring.anchor = Vec2(0.0, 2.0);
    spring.stiffness = 10.0;
    spring.rest_length = 0.5;
    Joint weld;
    weld.kind = JointKind::kWeld;
    weld.body = "light";
    weld.to = "heavy";
    weld.point = Vec2(0.1, 0.0);
    AppliedForce force;
    force.body = "light";
    force.force = Vec2(1.0, 0.0);
    apply({Add<Joint>{weld}, Add<Spring>{spring}, Add<AppliedForce>{force}});
    QObject::connect(&inspector_, &Inspector::partOpened, &inspector_, [this] { part_ = inspector_.part(); });
    QObject::disconnect(&inspector_, &Inspector::edited, &inspector_, nullptr);
    QObject::connect(&inspector_, &Inspector::edited, &inspector_,
                     [this](const SceneEdits& edits, const QString& name, int drag) {
                       made_.push_back({edits, name, drag});
                       apply(edits);
                       part_ ? inspector_.show_part(scene_, *part_) : inspector_.show_selection(scene_, {});
                     });
  }

  void choose(const PartId& part) {
    part_ = part;
    inspector_.show_part(scene_, part);
  }
  const Joint& rod() { return scene_->joints[0]; }
  const Joint& weld() { return scene_->joints[1]; }
  const Spring& spring() { return scene_->forces.springs[0]; }
  const AppliedForce& force() { return scene_->forces.applied[0]; }
  std::optional<PartId> part_;
};

TEST_F(InspectorPartTest, ARodHasTheDistanceUntilALengthIsTyped) {
  choose(rod().id);
  EXPECT_TRUE(texts().contains("Rod 1"));
  EXPECT_TRUE(texts().contains("rod"));
  EXPECT_TRUE(texts().contains("from light to heavy"));
  QLineEdit* length = field("Length, m");
  EXPECT_EQ(length->text(), "");
  EXPECT_EQ(length->placeholderText(), "2");
  enter(length, "200 cm");
  ASSERT_EQ(made_.size(), 1U) << "what is present is fixed by typing it";
  EXPECT_EQ(rod().length, 2.0);
  enter(length, "1.5");
  EXPECT_EQ(made_.back().name, "Length of Rod 1 2.00 → 1.50 m");
  EXPECT_NEAR((scene_->bodies[0].position - scene_->bodies[1].position).norm(), 1.5, 1e-15) << "it moves along";
  enter(length, "0");
  EXPECT_EQ(sentences(), QStringList{"Length is more than 0."});
  EXPECT_TRUE(length->property("fault").toBool());
  enter(length, " ");
  EXPECT_EQ(made_.back().name, "Length of Rod 1 as at the start");
  EXPECT_FALSE(rod().length.has_value());
  EXPECT_EQ(made_.size(), 3U);
}

TEST_F(InspectorPartTest, ASpringHasItsStiffnessAndActs) {
  choose(spring().id);
  EXPECT_TRUE(texts().contains("Spring 1"));
  EXPECT_TRUE(texts().contains("from light to the plane at (0, 2) m"));
  enter(field("Stiffness, N/m"), "20 N/m");
  ASSERT_EQ(made_.size(), 1U);
  EXPECT_EQ(made_[0].name, "Stiffness of Spring 1 10.0 → 20.0 N/m");
  EXPECT_EQ(spring().stiffness, 20.0);
  enter(field("Rest length, m"), "30 cm");
  EXPECT_EQ(spring().rest_length, 0.3);
  enter(field("Damping, N s/m"), "-1");
  EXPECT_EQ(sentences(), QStringList{"Damping is 0 or more."});
  auto* acts = inspector_.findChildren<QComboBox*>().last();
  EXPECT_EQ(acts->currentText(), "pushes and pulls");
  acts->setFocus();
  QTest::keyClick(acts, Qt::Key_Down);
  EXPECT_EQ(spring().acts, SpringActs::kPush);
  EXPECT_EQ(made_.back().name, "Spring 1 only pushes");
}

TEST_F(InspectorPartTest, PartsAreRenamedAndNeedNoName) {
  choose(spring().id);
  enter(field("Name"), "bumper");
  EXPECT_EQ(made_.back().name, "Rename Spring 1 to bumper");
  EXPECT_EQ(spring().name, "bumper");
  EXPECT_TRUE(texts().contains("bumper"));
  enter(field("Name"), " ");
  EXPECT_EQ(spring().name, "");
  enter(field("Name"), QString(201, 'x'));
  EXPECT_EQ(sentences(), QStringList{"A name has up to 200 characters."});
}

TEST_F(InspectorPartTest, AWeldHasAnAngle) {
  choose(weld().id);
  EXPECT_TRUE(texts().contains("Weld 1"));
  EXPECT_TRUE(texts().contains("from light at (0.1, 0) m to heavy"));
  EXPECT_FALSE(has_field("Length, m"));
  enter(field("Angle, °"), "90");
  EXPECT_DOUBLE_EQ(weld().angle.value(), std::numbers::pi / 2.0);
}

TEST_F(InspectorPartTest, AForceActsAtAPlaceInThreeFigures) {
  AppliedForce beside = force();
  beside.point = Vec2(0.2139541, -0.013240312);
  apply({Replace<AppliedForce>{beside}});
  choose(force().id);
  EXPECT_TRUE(texts().contains("at (0.214, −0.0132) m of light"));
  EXPECT_EQ(field("Point x, m")->text(), "0.213954");
}

TEST_F(InspectorPartTest, AForceHasASizeAndADirection) {
  choose(force().id);
  enter(field("Size, N"), "2");
  EXPECT_EQ(made_.back().name, "Size of Force on light 1.00 → 2.00 N");
  EXPECT_EQ(force().force, Vec2(2.0, 0.0));
  enter(field("Direction, °"), "90");
  EXPECT_NEAR((force().force - Vec2(0.0, 2.0)).norm(), 0.0, 1e-12);
}

// A stated length goes with them, and so does the other end of what holds two points together.
TEST_F(InspectorPartTest, EndsOfJointsAreTyped) {
  choose(rod().id);
  enter(field("Point x, m"), "0.05");
  EXPECT_EQ(made_.back().name, "Point x of Rod 1 0 → 0.050 m");
  EXPECT_EQ(rod().point, Vec2(0.05, 0.0));
  EXPECT_FALSE(rod().length);
  enter(field("Length, m"), "1.95");
  enter(field("Anchor x, m"), "0.1");
  EXPECT_NEAR(*rod().length, 2.05, 1e-12);
  choose(weld().id);
  const Vec2 anchor = weld().anchor;
  enter(field("Point y, m"), "0.2");
  EXPECT_EQ(weld().point, Vec2(0.1, 0.2));
  EXPECT_NEAR((weld().anchor - anchor - Vec2(0.0, 0.2)).norm(), 0.0, 1e-12);
  const Vec2 point = weld().point;
  enter(field("Anchor x, m"), "+0.3");
  EXPECT_NEAR((weld().point - point - Vec2(0.3, 0.0)).norm(), 0.0, 1e-12);
}

TEST_F(InspectorPartTest, AForceHasComponentsAndTimes) {
  choose(force().id);
  EXPECT_TRUE(texts().contains("Force on light"));
  enter(field("Force y, N"), "3");
  EXPECT_EQ(made_.back().name, "Force y of Force on light 0 → 3.00 N");
  EXPECT_EQ(force().force, Vec2(1.0, 3.0));
  enter(field("Torque, N m"), "2 N cm");
  EXPECT_DOUBLE_EQ(force().torque, 0.02);
  EXPECT_EQ(field("Until, s")->placeholderText(), "never");
  enter(field("From, s"), "500 ms");
  enter(field("Until, s"), "2");
  EXPECT_EQ(force().end, 2.0);
  enter(field("Until, s"), " ");
  EXPECT_FALSE(force().end.has_value());
  EXPECT_EQ(made_.back().name, "Until of Force on light never");
  enter(field("Rise, s"), "1 kg");
  EXPECT_EQ(sentences(), QStringList{"“kg” is no unit of this; it takes s, ms, min."});
}

TEST_F(InspectorPartTest, TheSceneListsItsPartsAndEscapeLeadsBack) {
  inspector_.show_selection(scene_, {});
  QTest::mouseClick(button("Spring 1, from light to the plane at (0, 2) m"), Qt::LeftButton);
  EXPECT_TRUE(has_field("Stiffness, N/m"));
  enter(field("Stiffness, N/m"), "30");
  EXPECT_EQ(spring().stiffness, 30.0);
  EXPECT_TRUE(has_field("Stiffness, N/m")) << "it stays chosen";
  QTest::keyClick(field("Stiffness, N/m"), Qt::Key_Escape);
  EXPECT_TRUE(has_field("Gravity, m/s²"));
  QTest::mouseClick(button("Rod 1, from light to heavy"), Qt::LeftButton);
  QTest::mouseClick(inspector_.findChild<QToolButton*>(), Qt::LeftButton);
  EXPECT_TRUE(has_field("Gravity, m/s²"));
  QTest::mouseClick(button("Force on light"), Qt::LeftButton);
  select({"heavy"});
  EXPECT_TRUE(has_field("Mass, kg"));
  EXPECT_FALSE(has_field("Torque, N m"));
}

TEST_F(InspectorPartTest, ALongNameIsElidedInTheList) {
  Spring named = spring();
  named.name = QString(60, 'W').toStdString();
  apply({Replace<Spring>{named}});
  inspector_.resize(260, 500);
  inspector_.show_selection(scene_, {});
  QTest::qWait(20);
  const QPushButton* shown = button(QString(60, 'W') + ", from light to the plane at (0, 2) m");
  ASSERT_NE(shown, nullptr);
  EXPECT_TRUE(shown->text().endsWith(QChar(0x2026)));
  EXPECT_TRUE(shown->toolTip().contains("the plane"));
  EXPECT_LE(shown->mapTo(&inspector_, shown->rect().topRight()).x(), 260);
}

TEST_F(InspectorPartTest, APartThatIsGoneGivesWayToTheScene) {
  choose(spring().id);
  apply({Remove<Spring>{spring().id}});
  inspector_.show_part(scene_, *part_);
  EXPECT_TRUE(has_field("Gravity, m/s²"));
}

}  // namespace
}  // namespace carom
