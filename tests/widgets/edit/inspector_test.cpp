#include "widgets/edit/inspector.h"

#include <numbers>

#include "physics/scene/validate.h"
#include "tests/widgets/edit/inspector_fixture.h"

namespace carom {
namespace {

TEST_F(InspectorTest, MassTakesThePlaceOfDensityAndBack) {
  select({"light"});
  enter(field("Density, kg/m²"), "100");
  EXPECT_FALSE(light().mass.has_value());
  EXPECT_EQ(light().density, 100.0);
  EXPECT_NEAR(field("Mass, kg")->text().toDouble(), mass_of(light()), 1e-5);
  enter(field("Mass, kg"), "2");
  EXPECT_FALSE(light().density.has_value());
}

// As a drag of a handle does; or, if that is chosen, the mass stays.
TEST_F(InspectorTest, ATypedSizeKeepsDensityOrMass) {
  std::vector<Keeps> told;
  QObject::connect(&inspector_, &Inspector::keepsChosen, &inspector_,
                   [&](Keeps keeps) { told.push_back(keeps); });
  select({"light"});
  const double radius = std::get<Disc>(light().shape).radius;
  enter(field("Radius, m"), "*2");
  EXPECT_NEAR(std::get<Disc>(light().shape).radius, 2.0 * radius, 1e-12);
  EXPECT_NEAR(*light().mass, 4.0, 1e-12);
  choose_below(box("Resized"));
  EXPECT_EQ(told, std::vector{Keeps::kMass});
  EXPECT_EQ(made_.size(), 1U) << "no edit";
  enter(field("Radius, m"), "*0.5");
  EXPECT_NEAR(*light().mass, 4.0, 1e-12);
  enter(field("Density, kg/m²"), "100");
  const double mass = mass_of(light());
  enter(field("Radius, m"), "*3");
  EXPECT_NEAR(mass_of(light()), mass, 1e-12);
}

TEST_F(InspectorTest, BodiesArePutIntoAGroup) {
  select({"heavy", "light"});
  EXPECT_EQ(field("Group")->placeholderText(), "none");
  enter(field("Group"), "ghosts");
  EXPECT_EQ(made_.back().name, "Put 2 bodies into group ghosts");
  EXPECT_EQ(light().group, "ghosts");
  EXPECT_EQ(heavy().group, "ghosts");
  select({"light"});
  enter(field("Group"), " ");
  EXPECT_EQ(made_.back().name, "Take light out of the group");
  EXPECT_EQ(light().group, "");
  select({"heavy", "light"});
  EXPECT_EQ(field("Group")->placeholderText(), "several");
  enter(field("Group"), "none");
  EXPECT_EQ(made_.back().name, "Take 2 bodies out of their groups");
  EXPECT_EQ(heavy().group, "");
  EXPECT_EQ(field("Group")->placeholderText(), "none");
}

TEST_F(InspectorTest, AWallIsAHalfPlaneOrHasALength) {
  Body floor;
  floor.name = "floor";
  floor.shape = Wall{};
  floor.fixed = true;
  floor.material = "wood";
  apply({Add<Body>{floor}});
  select({"floor"});
  EXPECT_EQ(field("Length, m")->placeholderText(), "half-plane");
  enter(field("Length, m"), "2.5");
  EXPECT_EQ(std::get<Wall>(scene_->bodies[2].shape).length, 2.5);
  enter(field("Length, m"), " ");
  EXPECT_EQ(made_.back().name, "Make floor a half-plane");
  EXPECT_FALSE(std::get<Wall>(scene_->bodies[2].shape).length);
}

TEST_F(InspectorTest, ChangesAllSelectedBodies) {
  select({"heavy", "light"});
  EXPECT_FALSE(has_field("Name"));
  QLineEdit* mass = field("Mass, kg");
  EXPECT_EQ(mass->text(), "");
  EXPECT_EQ(mass->placeholderText(), "2 values");
  EXPECT_EQ(field("Velocity x, m/s")->text(), "2");
  enter(mass, "*2");
  ASSERT_EQ(made_.size(), 1U);
  EXPECT_EQ(made_[0].name, "Mass of 2 bodies");
  EXPECT_EQ(light().mass, 2.0);
  EXPECT_EQ(heavy().mass, 5.0);
  enter(mass, "3");
  EXPECT_EQ(mass->text(), "3");
  enter(field("Position y, m"), "+50 cm");
  EXPECT_EQ(made_.back().name, "Move 2 bodies");
  EXPECT_EQ(heavy().position, Vec2(1.0, 0.5));
}

// The inspector has no line of its own for it: its fields alone tell of it.
TEST_F(InspectorTest, HasAFieldForEachNumberThatABodyStates) {
  EXPECT_FALSE(has_field("Inertia, kg m²"));
  Body body = light();
  body.inertia = 0.5;
  apply({Replace<Body>{body}});
  select({"light"});
  enter(field("Inertia, kg m²"), "0.25");
  ASSERT_EQ(made_.size(), 1U);
  EXPECT_EQ(made_[0].name, "Inertia of light 0.500 → 0.250 kg m²");
  EXPECT_EQ(light().inertia, 0.25);
}

TEST_F(InspectorTest, NothingCanBeTypedWhileARunPlays) {
  select({"light"});
  inspector_.set_playing(true);
  inspector_.show_selection(nullptr, names_);
  EXPECT_FALSE(field("Mass, kg")->isEnabled());
  EXPECT_EQ(field("Mass, kg")->text(), "1");
  const auto muted = [this] {
    QStringList texts;
    for (const QLabel* label : inspector_.findChildren<QLabel*>("muted")) {
      if (label->isVisibleTo(&inspector_)) texts << label->text();
    }
    return texts;
  };
  EXPECT_TRUE(muted().contains("Pause to edit"));
  inspector_.set_playing(false);
  inspector_.show_selection(nullptr, names_);
  EXPECT_FALSE(muted().contains("Pause to edit")) << "it is paused: a moment of the past has no scene yet";
  EXPECT_TRUE(muted().contains("Computing this moment"));
  inspector_.show_selection(scene_, names_);
  EXPECT_TRUE(field("Mass, kg")->isEnabled());
}

TEST_F(InspectorTest, TheSameSceneAgainPaintsNothing) {
  class Paints : public QObject {
   public:
    int count = 0;
    bool eventFilter(QObject* watched, QEvent* event) override {
      if (event->type() == QEvent::Paint) ++count;
      return QObject::eventFilter(watched, event);
    }
  };
  Paints paints;
  // All that is to be painted so far, and how much that was.
  const auto painted = [&paints] {
    const int before = paints.count;
    for (int seen = -1; seen != paints.count;) {
      seen = paints.count;
      QCoreApplication::sendPostedEvents();
      QCoreApplication::processEvents();
    }
    return paints.count - before;
  };
  select({"light"});
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&inspector_));
  for (QWidget* widget : inspector_.findChildren<QWidget*>()) widget->installEventFilter(&paints);
  select({"heavy"});
  EXPECT_GT(painted(), 0);
  for (int i = 0; i < 3; ++i) {
    inspector_.show_selection(scene_, names_);
    inspector_.show_selection(std::make_shared<const Scene>(*scene_), names_);
    EXPECT_EQ(painted(), 0) << i;
  }
}

TEST_F(InspectorTest, ABodyIsRenamed) {
  select({"light"});
  names_ = {"ball"};
  enter(field("Name"), "ball");
  ASSERT_EQ(made_.size(), 1U);
  EXPECT_EQ(made_[0].name, "Rename light to ball");
  EXPECT_EQ(light().name, "ball");
  enter(field("Name"), " ");
  EXPECT_EQ(sentences(), QStringList{"A body has a name."});
  enter(field("Name"), "heavy");
  EXPECT_EQ(sentences(), QStringList{"Another body is called heavy."});
  EXPECT_EQ(made_.size(), 1U);
}

TEST_F(InspectorTest, AFixedBodyHasNoMassAndNoMotion) {
  select({"light"});
  button("Kind: moves")->setFocus();
  QTest::keyClick(button("Kind: moves"), Qt::Key_Right);
  ASSERT_EQ(made_.size(), 1U);
  EXPECT_EQ(made_[0].name, "Fix light");
  EXPECT_TRUE(light().fixed && light().velocity.isZero(0.0));
  EXPECT_FALSE(has_field("Mass, kg"));
  EXPECT_FALSE(has_field("Velocity x, m/s"));
  choose_below(box("Surface"));
  EXPECT_EQ(made_.back().name, "Surface of light: rubber");
  EXPECT_EQ(light().material, "rubber");
}

TEST_F(InspectorTest, TheKindOfSeveralIsOpenAndThatOfAHalfPlaneFixed) {
  Body body = light();
  body.fixed = true;
  body.velocity = Vec2::Zero();
  apply({Remove<Joint>{scene_->joints[0].id}, Replace<Body>{body}});
  select({"light", "heavy"});
  EXPECT_FALSE(button("Kind: moves")->isChecked());
  EXPECT_FALSE(button("Kind: fixed")->isChecked());
  button("Kind: fixed")->click();
  EXPECT_TRUE(button("Kind: fixed")->isChecked());
  EXPECT_TRUE(heavy().fixed);
  body.shape = Wall{};
  apply({Replace<Body>{body}});
  select({"light"});
  EXPECT_TRUE(button("Kind: fixed")->isChecked());
  EXPECT_FALSE(button("Kind: moves")->isEnabled());
  EXPECT_TRUE(button("Kind: moves")->toolTip().contains("can only stand still"));
}

TEST_F(InspectorTest, ADrivenBodyShowsItsDrive) {
  apply({Remove<Joint>{scene_->joints[0].id}});
  select({"light"});
  button("Kind: driven")->click();
  ASSERT_TRUE(light().drive.has_value());
  EXPECT_EQ(made_.back().name, "Drive light");
  EXPECT_NO_THROW(validate(*scene_));
  EXPECT_FALSE(has_field("Mass, kg"));
  EXPECT_FALSE(has_field("Speed, m/s"));
  enter(field("Frequency, Hz"), "2");
  EXPECT_DOUBLE_EQ(light().drive->angular_frequency, 4.0 * std::numbers::pi);
  EXPECT_EQ(made_.back().name, "Frequency of light 0 → 2.00 Hz");
  enter(field("ω, rad/s"), "1 Hz");
  EXPECT_EQ(field("Frequency, Hz")->text(), "1");
  enter(field("Amplitude y, m"), "10 cm");
  enter(field("Velocity x, m/s"), "1");
  enter(field("Phase, °"), "90");
  EXPECT_DOUBLE_EQ(light().drive->phase, std::numbers::pi / 2.0);
  button("Kind: moves")->click();
  EXPECT_EQ(made_.back().name, "Let light move");
  EXPECT_FALSE(light().drive.has_value() || light().fixed);
}

TEST_F(InspectorTest, SpeedAndDirectionAreTypedBesideTheComponents) {
  select({"light"});
  enter(field("Direction, °"), "90");
  EXPECT_EQ(light().velocity, Vec2(0.0, 2.0));
  EXPECT_EQ(made_.back().name, "Direction of light 0 → 90.0°");
  enter(field("Speed, m/s"), "3");
  EXPECT_EQ(light().velocity, Vec2(0.0, 3.0));
  EXPECT_EQ(made_.back().name, "Speed of light 2.00 → 3.00 m/s");
  EXPECT_EQ(field("Velocity y, m/s")->text(), "3");
  enter(field("Speed, m/s"), "-1");
  EXPECT_EQ(sentences(), QStringList{"Speed is 0 or more."});
  enter(field("Speed, m/s"), "0");
  enter(field("Direction, °"), "45");
  EXPECT_EQ(sentences(), QStringList{"At rest there is no direction: a speed comes first."});
}

TEST_F(InspectorTest, SeveralBodiesHaveSumsAndACentreOfMass) {
  Body light_one = light();
  Body heavy_one = heavy();
  light_one.position = {-1.0, 0.5};
  light_one.velocity = {0.1, 3.0};
  heavy_one.position = {1.0, 0.5};
  heavy_one.mass = 3.0;
  heavy_one.velocity = {-0.1, -1.0};
  QStringList derived = derived_texts({light_one, heavy_one});
  derived.replaceInStrings(QString(QChar::Nbsp), " ");
  EXPECT_EQ(derived, (QStringList{"m 4.00 kg", "p 0.200 kg m/s", "K 6.02 J", "L −5.90 kg m²/s",
                                  "centre of mass x, y: 0.500, 0.500 m", "its velocity: −0.050, 0.000 m/s"}));
  heavy_one.velocity.x() = -0.1 / 3.0;
  derived = derived_texts({light_one, heavy_one});
  derived.replaceInStrings(QString(QChar::Nbsp), " ");
  EXPECT_EQ(derived[1], "p 0 kg m/s") << "without rounding";
}

TEST_F(InspectorTest, DerivedValuesHaveTheirFormulasOnHover) {
  const auto derived = [this]() -> const QLabel* {
    for (const QLabel* label : inspector_.findChildren<QLabel*>()) {
      if (label->isVisible() && label->text().contains("J") &&
          label->text().contains(QString("kg m/s").replace(' ', QChar::Nbsp)))
        return label;
    }
    return nullptr;
  };
  select({"light"});
  ASSERT_NE(derived(), nullptr);
  EXPECT_TRUE(derived()->toolTip().contains("L = m (x vy − y vx) + I ω")) << derived()->toolTip().toStdString();
  EXPECT_TRUE(derived()->toolTip().contains("p = m v"));
  select({"light", "heavy"});
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  ASSERT_NE(derived(), nullptr);
  EXPECT_TRUE(derived()->toolTip().contains("p = |Σ m v|"));
}

TEST_F(InspectorTest, WithoutASelectionItShowsTheScene) {
  select({});
  QLineEdit* gravity = field("Gravity, m/s²");
  EXPECT_EQ(gravity->text(), "9.81");
  enter(gravity, "1,62");
  EXPECT_EQ(made_.back().name, "Gravity 9.81 → 1.62 m/s²");
  EXPECT_EQ(scene_->forces.gravity, Vec2(0.0, -1.62));
  enter(field("Linear drag, kg/s"), "-1");
  EXPECT_EQ(sentences(), QStringList{"Linear drag is 0 or more."});
}

TEST_F(InspectorTest, NeedsNoMoreThan260Pixels) {
  inspector_.resize(260, 500);
  for (const std::vector<std::string>& names : {std::vector<std::string>{"light"}, {}, {"light", "heavy"}}) {
    select(names);
    QTest::qWait(20);
    for (const QLineEdit* line : inspector_.findChildren<QLineEdit*>()) {
      if (!line->isVisibleTo(&inspector_)) continue;
      EXPECT_LE(line->mapTo(&inspector_, line->rect().topRight()).x(), 260)
          << line->accessibleName().toStdString();
    }
  }
}

TEST_F(InspectorTest, ShowsTheSurfaceThatBodiesShare) {
  select({"light"});
  EXPECT_TRUE(label("Surface wood · 2 bodies share it")->isVisibleTo(&inspector_));
  EXPECT_TRUE(label("2 bodies")->isVisibleTo(&inspector_));
  enter(field("e of wood"), "0.5");
  EXPECT_EQ(scene_->materials[0].restitution, 0.5);
  // Static friction is never less than kinetic friction.
  enter(field("µ of wood"), "0.3");
  EXPECT_EQ(scene_->materials[0].kinetic_friction, 0.3);
  EXPECT_EQ(scene_->materials[0].static_friction, 0.3);
  EXPECT_EQ(made_.back().name, "µ of wood 0 → 0.300, µs too");
  select({});
  const std::size_t edits = made_.size();
  enter(field("µs of wood"), "0.2");
  EXPECT_EQ(sentences(), QStringList{"µs is never less than the friction µ, 0.3 here: lower µ first."});
  EXPECT_EQ(made_.size(), edits);
  QTest::keyClick(field("µs of wood"), Qt::Key_Escape);
  for (int step = 0; step < 3; ++step) QTest::keyClick(field("µs of wood"), Qt::Key_Down);
  EXPECT_EQ(scene_->materials[0].static_friction, 0.3) << "nor by steps";
  EXPECT_EQ(scene_->materials[0].kinetic_friction, 0.3);
  enter(field("µ of wood"), "0.2");
  EXPECT_EQ(made_.back().name, "µ of wood 0.300 → 0.200");
  enter(field("µs of wood"), "0.25");
  EXPECT_EQ(scene_->materials[0].static_friction, 0.25);
  EXPECT_EQ(scene_->materials[0].kinetic_friction, 0.2);
}

TEST_F(InspectorTest, ASurfaceThatTheSceneDoesNotListIsAdded) {
  Body plain = light();
  plain.material = "default";
  apply({Replace<Body>{plain}});
  select({"light"});
  enter(field("e of default"), "0.25");
  EXPECT_EQ(material_named(*scene_, "default").restitution, 0.25);
  EXPECT_EQ(scene_->materials.size(), 3U);
}

TEST_F(InspectorTest, FieldsThatADragChangesHaveARing) {
  const auto ringed = [this](const char* name) { return field(name)->property("changes").toBool(); };
  select({"light"});
  inspector_.watch_changes(true);
  Body moved = light();
  moved.position.x() = -0.5;
  apply({Replace<Body>{moved}});
  select({"light"});
  EXPECT_TRUE(ringed("Position x, m"));
  EXPECT_FALSE(ringed("Position y, m"));
  moved.position.x() = -1.0;
  apply({Replace<Body>{moved}});
  select({"light"});
  EXPECT_FALSE(ringed("Position x, m"));
  moved.position.y() = 1.0;
  apply({Replace<Body>{moved}});
  select({"light"});
  EXPECT_TRUE(ringed("Position y, m"));
  inspector_.watch_changes(false);
  EXPECT_FALSE(ringed("Position y, m"));
}

}  // namespace
}  // namespace carom
