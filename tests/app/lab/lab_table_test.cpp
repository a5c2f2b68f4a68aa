#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTabWidget>
#include <QTableView>
#include <algorithm>
#include <cmath>

#include "app/lab/session.h"
#include "tests/app/lab/lab_fixture.h"
#include "widgets/edit/bodies_model.h"
#include "widgets/edit/bodies_sheet.h"
#include "widgets/edit/inspector.h"
#include "widgets/run/before_after_panel.h"

// The table of the bodies in the real window.
namespace carom {
namespace {

class LabTableTest : public LabWindowTest {
 protected:
  QTableView& table() { return *window_.findChild<BodiesSheet*>()->findChild<QTableView*>(); }
  void click(int row, int column) {
    const QModelIndex index = table().model()->index(row, column);
    table().scrollTo(index);
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, table().visualRect(index).center());
  }
  // To what has the focus, as the keyboard does.
  static void type(const QString& text, Qt::Key end = Qt::Key_Return) {
    for (const QChar c : text) QTest::keyClicks(QApplication::focusWidget(), c);
    QTest::keyClick(QApplication::focusWidget(), end);
  }
  // The two discs at rest, on a rod of this length or of their distance.
  void show_on_a_rod(std::optional<double> length) {
    Preset pair = window_.preset();
    for (Body& body : pair.scene.bodies) body.velocity.setZero();
    Joint rod;
    rod.name = "Rod 1";
    rod.body = "light";
    rod.to = "heavy";
    rod.length = length;
    pair.scene.joints = {rod};
    pair.expect.clear();
    window_.show_scene(pair, {}, {});
    ASSERT_TRUE(wait_for([this] {
      const auto scene = window_.session().runs().scene();
      return scene != nullptr && scene->joints.size() == 1;
    }));
  }
  [[nodiscard]] const Body& light() const { return window_.preset().scene.bodies[0]; }
  [[nodiscard]] bool is_selected(const std::string& name) {
    return wait_for([&] { return window_.scene_view().selection() == std::vector<std::string>{name}; });
  }
};

TEST_F(LabTableTest, TypesUndoesAndRedoes) {
  ASSERT_TRUE(wait_for([this] { return window_.session().runs().scene() != nullptr; }));
  const double mass = mass_of(light());
  const Vec2 velocity = light().velocity;
  click(0, BodiesModel::kMass);
  EXPECT_TRUE(is_selected("light"));
  type("2");
  EXPECT_EQ(mass_of(light()), 2.0);
  EXPECT_TRUE(is_selected("heavy")) << "Enter goes down";
  click(0, BodiesModel::kVelocityX);
  type("3.6 km/h");
  EXPECT_EQ(light().velocity.x(), 1.0);
  QUndoStack& edits = window_.session().edits();
  EXPECT_EQ(edits.count(), 2);
  EXPECT_TRUE(edits.text(0).startsWith("Mass of light")) << edits.text(0).toStdString();
  QTest::keyClick(&table(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(light().velocity, velocity);
  QTest::keyClick(&table(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(mass_of(light()), mass);
  QTest::keyClick(&table(), Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(mass_of(light()), 2.0);
  const QModelIndex mass_cell = table().model()->index(0, BodiesModel::kMass);
  EXPECT_TRUE(wait_for([&] { return mass_cell.data().toString() == "2.000"; }));
}

TEST_F(LabTableTest, SelectsAsTheSceneDoes) {
  ASSERT_TRUE(wait_for([this] { return window_.session().runs().scene() != nullptr; }));
  click(1, BodiesModel::kBody);
  EXPECT_TRUE(is_selected("heavy"));
  const QPoint at = window_.scene_view().camera().to_screen(light().position).toPoint();
  QTest::mouseClick(&window_.scene_view(), Qt::LeftButton, {}, at);
  EXPECT_TRUE(is_selected("light"));
  const auto* rows = static_cast<const BodiesModel*>(table().model());
  EXPECT_TRUE(rows->is_marked(0));
  EXPECT_FALSE(rows->is_marked(1));
  // A renamed body stays selected; letters that are keys of the window are text here.
  click(0, BodiesModel::kBody);
  type("fried", Qt::Key_Tab);
  EXPECT_EQ(light().name, "fried");
  EXPECT_TRUE(is_selected("fried"));
}

// Bodies of a generator, and the walls around them, whose mass takes nothing: no key of it reaches the window.
TEST_F(LabTableTest, EditsBodiesOfAGenerator) {
  ASSERT_TRUE(window_.open("gas"));
  ASSERT_TRUE(
      wait_for([this] { return window_.session().runs().scene() && table().model()->rowCount() > 100; }));
  click(0, BodiesModel::kMass);
  type("0.5");
  EXPECT_EQ(window_.session().edits().count(), 0);
  EXPECT_EQ(time(), 0.0);
  const std::string name = (*window_.frame()->bodies)[8].name;
  click(8, BodiesModel::kMass);
  type("2");
  const std::vector<Body>& bodies = window_.preset().scene.bodies;
  const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == name; });
  ASSERT_NE(found, bodies.end());
  EXPECT_EQ(found->mass, 2.0);
  EXPECT_TRUE(wait_for([this] { return mass_of((*window_.frame()->bodies)[8]) == 2.0; }));
}

// The window's own copy is that of bodies.
TEST_F(LabTableTest, CopiesCellsAndOtherTablesWhole) {
  ASSERT_TRUE(wait_for([this] { return window_.session().runs().scene() != nullptr; }));
  click(0, BodiesModel::kBody);
  QTest::keyClick(&table(), Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QApplication::clipboard()->text(), "light");
  auto* tabs = window_.findChild<QTabWidget*>();
  auto* panel = window_.findChild<BeforeAfterPanel*>();
  tabs->setCurrentWidget(panel);
  panel->choose(BeforeAfterPanel::Choice::kStart);
  QTest::keyClick(panel->findChild<BeforeAfterTable*>(), Qt::Key_C, Qt::ControlModifier);
  EXPECT_TRUE(QApplication::clipboard()->text().startsWith("body\tm / kg\tv before"));
}

TEST_F(LabTableTest, SavesATableAsCsv) {
  ASSERT_TRUE(wait_for([this] { return window_.session().runs().scene() != nullptr; }));
  auto* panel = window_.findChild<BeforeAfterPanel*>();
  window_.findChild<QTabWidget*>()->setCurrentWidget(panel);
  panel->choose(BeforeAfterPanel::Choice::kStart);
  chosen_file_ = folder_.filePath("bodies.csv");
  QFile file(chosen_file_);
  emit panel->findChild<BeforeAfterTable*>()->saveAsked();
  ASSERT_TRUE(wait_for([&file] { return file.exists(); }));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_TRUE(file.readLine().startsWith("body,m / kg,"));
  EXPECT_EQ(file.readLine(), "light,1,2,0,2,0,2,0,2,0,2,2\n");
}

// A column that is marked by its head begins at the first body, whatever cell is current.
TEST_F(LabTableTest, PastesIntoAColumnAndSaysWhatCannotBe) {
  ASSERT_TRUE(wait_for([this] { return window_.session().runs().scene() != nullptr; }));
  click(1, BodiesModel::kMass);
  const double mass = mass_of(window_.preset().scene.bodies[1]);
  QHeaderView* head = table().horizontalHeader();
  const int x = head->sectionViewportPosition(BodiesModel::kMass) + 20;
  QTest::mouseClick(head->viewport(), Qt::LeftButton, {}, QPoint(x, head->height() / 2));
  table().selectionModel()->setCurrentIndex(table().model()->index(1, BodiesModel::kMass),
                                            QItemSelectionModel::NoUpdate);
  QApplication::clipboard()->setText("2\n-3");
  QTest::keyClick(&table(), Qt::Key_V, Qt::ControlModifier);
  EXPECT_EQ(mass_of(light()), 2.0);
  EXPECT_EQ(mass_of(window_.preset().scene.bodies[1]), mass);
  const auto* rows = static_cast<const BodiesModel*>(table().model());
  const auto* sentence = window_.findChild<BodiesSheet*>()->findChild<QLabel*>("fault");
  // The body that was changed is selected meanwhile.
  ASSERT_TRUE(is_selected("light"));
  EXPECT_NE(rows->fault(1, BodiesModel::kMass), nullptr);
  EXPECT_TRUE(sentence->isVisible());
  EXPECT_EQ(sentence->text(), "Mass is more than 0.");
  window_.session().edits().undo();
  EXPECT_EQ(rows->fault(1, BodiesModel::kMass), nullptr);
  EXPECT_FALSE(sentence->isVisible());
}

// Two free discs on a rod: what it forbids is red, and the sentence says what to do.
TEST_F(LabTableTest, AVelocityAgainstAJointIsRed) {
  ASSERT_NO_FATAL_FAILURE(show_on_a_rod({}));
  click(0, BodiesModel::kVelocityX);
  type("1");
  const auto* field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
  ASSERT_NE(field, nullptr) << "it is still typed";
  EXPECT_TRUE(field->property("fault").toBool());
  const auto* sentence = window_.findChild<BodiesSheet*>()->findChild<QLabel*>("fault");
  EXPECT_TRUE(sentence->isVisible());
  EXPECT_EQ(
      sentence->text(),
      "Rod 1 joins light and heavy: their ends would close in at 1 m/s. Select both, or change both at once.");
  EXPECT_EQ(window_.session().edits().count(), 0);
  // Both at once.
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
  QApplication::clipboard()->setText("1\n1");
  QTest::keyClick(&table(), Qt::Key_V, Qt::ControlModifier);
  EXPECT_EQ(light().velocity.x(), 1.0);
  EXPECT_FALSE(sentence->isVisible());
}

// A pendulum 30° to the right: of (1, 0) the rod leaves what is across it.
TEST_F(LabTableTest, ARodLeavesTheAllowedPartOfATypedVelocity) {
  Preset pendulum = window_.preset();
  pendulum.scene.bodies.resize(1);
  Body& bob = pendulum.scene.bodies[0];
  bob.position = Vec2(0.5, -0.5 * std::sqrt(3.0));
  bob.velocity.setZero();
  Joint rod;
  rod.body = bob.name;
  pendulum.scene.joints = {rod};
  pendulum.expect.clear();
  pendulum.plots.clear();
  window_.show_scene(pendulum, {}, {});
  ASSERT_TRUE(wait_for([this] {
    const auto scene = window_.session().runs().scene();
    return scene != nullptr && scene->joints.size() == 1;
  }));
  click(0, BodiesModel::kVelocityX);
  type("1");
  EXPECT_NEAR(light().velocity.x(), 0.75, 1e-12);
  EXPECT_NEAR(light().velocity.y(), std::sqrt(3.0) / 4.0, 1e-12);
  EXPECT_EQ(window_.session().edits().count(), 1);
  EXPECT_TRUE(wait_for([this] {
    for (const QLabel* label : window_.findChildren<QLabel*>()) {
      if (label->text().contains("Rod 1 allows no other direction")) return true;
    }
    return false;
  }));
}

// Places that a rod does not allow slide in the table and the inspector, or stand red as they were typed.
TEST_F(LabTableTest, ATypedPlaceSlidesOnItsRodOrIsRed) {
  const std::vector<Body> both = window_.preset().scene.bodies;
  const Vec2 apart = both[1].position - both[0].position;
  ASSERT_NO_FATAL_FAILURE(show_on_a_rod(apart.norm()));
  click(0, BodiesModel::kY);
  type("0.3");
  const auto length = [this] {
    const std::vector<Body>& bodies = window_.preset().scene.bodies;
    return (bodies[1].position - bodies[0].position).norm();
  };
  EXPECT_GT(light().position.y(), 0.2);
  EXPECT_NEAR(length(), apart.norm(), 1e-9);
  EXPECT_EQ(window_.session().edits().count(), 1);
  // Along the rod nothing is left; in the inspector too.
  window_.session().edits().undo();
  ASSERT_TRUE(wait_for([this] {
    const auto scene = window_.session().runs().scene();
    return scene != nullptr && scene->bodies[0].position.y() == 0.0;
  }));
  window_.scene_view().select({"light"});
  QLineEdit* x = nullptr;
  for (QLineEdit* edit : window_.findChild<Inspector*>()->findChildren<QLineEdit*>()) {
    if (edit->accessibleName() == "Position x, m" && edit->isVisible()) x = edit;
  }
  ASSERT_NE(x, nullptr);
  x->setFocus();
  x->selectAll();
  type("-3");
  EXPECT_TRUE(x->property("fault").toBool());
  EXPECT_EQ(x->text(), "-3");
  bool said = false;
  for (const QLabel* label : window_.findChild<Inspector*>()->findChildren<QLabel*>("fault"))
    said = said || (label->isVisible() && label->text().startsWith("Rod 1 would be "));
  EXPECT_TRUE(said);
  EXPECT_EQ(light().position.x(), both[0].position.x());
}

// What is typed at a later moment: a mass goes on, a velocity is a new start from there.
TEST_F(LabTableTest, FollowsTheRuleOfTime) {
  window_.run_until(0.2);
  ASSERT_TRUE(wait_for([this] { return window_.session().runs().scene() != nullptr; }));
  click(0, BodiesModel::kMass);
  type("2");
  ASSERT_TRUE(
      wait_for([this] { return window_.frame()->scene && mass_of(window_.frame()->scene->bodies[0]) == 2.0; }));
  EXPECT_GT(time(), 0.1);
  click(0, BodiesModel::kVelocityY);
  type("1");
  ASSERT_TRUE(wait_for([this] { return time() == 0.0; }));
  EXPECT_EQ(light().velocity.y(), 1.0);
}

// Where it is at the shown moment, also in the inspector; the scene states where it began.
TEST_F(LabTableTest, ADrivenBodyIsShownAndEditedWhereItIs) {
  ASSERT_TRUE(window_.open("moving-piston"));
  constexpr int kSteps = 50;  // of 0.01 s, in which the piston moves by 0.05 m
  ASSERT_TRUE(
      wait_for([this] { return window_.session().runs().scene() && table().model()->rowCount() == 6; }));
  for (int i = 0; i < kSteps; ++i) window_.session().starts().step_by(1);
  ASSERT_TRUE(wait_for([this] { return steps() == kSteps && window_.session().runs().scene(); }));
  constexpr int kPiston = 1;
  const QModelIndex x = table().model()->index(kPiston, BodiesModel::kX);
  EXPECT_TRUE(wait_for([&] { return x.data().toString() == "2.450"; })) << x.data().toString().toStdString();
  click(kPiston, BodiesModel::kBody);
  ASSERT_TRUE(is_selected("piston"));
  const auto fields = window_.findChild<Inspector*>()->findChildren<QLineEdit*>();
  const auto place = std::find_if(fields.begin(), fields.end(), [](const QLineEdit* field) {
    return field->accessibleName() == "Position x, m";
  });
  ASSERT_NE(place, fields.end());
  EXPECT_EQ((*place)->text(), "2.45");
  // A place that is typed is one of this moment.
  click(kPiston, BodiesModel::kX);
  type("2.4");
  ASSERT_TRUE(wait_for([this] { return window_.preset().saved.has_value(); }));
  EXPECT_DOUBLE_EQ(window_.preset().scene.bodies[kPiston].position.x(), 2.45);
  EXPECT_TRUE(
      wait_for([this] { return std::abs(window_.frame()->state.position(kPiston).x() - 2.4) < 1e-12; }));
  EXPECT_TRUE(wait_for([&] { return x.data().toString() == "2.400"; })) << x.data().toString().toStdString();
  // Also that at which the scene states it.
  click(kPiston, BodiesModel::kX);
  type("2.45");
  EXPECT_TRUE(wait_for([&] { return x.data().toString() == "2.450"; })) << x.data().toString().toStdString();
  EXPECT_DOUBLE_EQ(window_.preset().scene.bodies[kPiston].position.x(), 2.5);
}

TEST_F(LabTableTest, AnotherExperimentBeginsAtTheFirstCell) {
  ASSERT_TRUE(window_.open("gas"));
  ASSERT_TRUE(
      wait_for([this] { return window_.session().runs().scene() && table().model()->rowCount() > 100; }));
  click(90, BodiesModel::kEnergy);
  ASSERT_GT(table().verticalScrollBar()->value(), 0);
  ASSERT_TRUE(window_.open("newtons-cradle"));
  EXPECT_EQ(table().verticalScrollBar()->value(), 0);
  EXPECT_EQ(table().horizontalScrollBar()->value(), 0);
  EXPECT_FALSE(table().currentIndex().isValid());
}

}  // namespace
}  // namespace carom
