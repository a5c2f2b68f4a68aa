#include "widgets/edit/bodies_sheet.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>
#include <memory>
#include <numbers>
#include <tuple>

#include "widgets/edit/bodies_model.h"
#include "widgets/edit/driven.h"

namespace carom {
namespace {

using Column = BodiesModel::Column;

Body body(const std::string& name, double mass, double x) {
  Body b;
  b.name = name;
  b.mass = mass;
  b.position = Vec2(x, 0.0);
  b.velocity = Vec2(2.0, 0.0);
  return b;
}

// The table, the keys to it, and, as a document does, the scene that its edits change.
class BodiesSheetTest : public testing::Test {
 protected:
  BodiesSheetTest() {
    Body floor;
    floor.name = "floor";
    floor.shape = Wall{};
    floor.fixed = true;
    show({body("light", 1.0, -1.0), body("heavy", 1.0 / 3.0, 1.0), floor});
    QObject::connect(&sheet_, &BodiesSheet::edited, &sheet_,
                     [this](const SceneEdits& edits, const QString& name) {
                       names_.push_back(name);
                       Scene scene = *scene_;
                       apply_edits(scene, edits);
                       scene_ = std::make_shared<const Scene>(scene);
                       sheet_.show_moment(scene_, nullptr);
                     });
    QObject::connect(&sheet_, &BodiesSheet::chosen, &sheet_,
                     [this](const std::vector<std::string>& names) { chosen_ = names; });
    sheet_.resize(700, 200);
    sheet_.show();
    sheet_.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&sheet_));
    table().setFocus();
  }

  void show(const std::vector<Body>& bodies) {
    Scene scene;
    scene.bodies = bodies;
    give_ids(scene);
    scene_ = std::make_shared<const Scene>(scene);
    sheet_.show_moment(scene_, nullptr);
  }
  QTableView& table() { return *sheet_.findChild<QTableView*>(); }
  [[nodiscard]] QModelIndex at(int row, int column) { return table().model()->index(row, column); }
  [[nodiscard]] QString text(int row, int column) { return at(row, column).data().toString(); }
  void click(int row, int column) {
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, table().visualRect(at(row, column)).center());
  }
  QLineEdit* field() {
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // those that were closed
    return table().findChild<QLineEdit*>("cell");
  }
  // To what has the focus, as the keyboard does.
  static void keys(const QString& text) {
    for (const QChar c : text) QTest::keyClicks(QApplication::focusWidget(), c);
  }
  static void key(Qt::Key k, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(QApplication::focusWidget(), k, modifiers);
  }
  QString sentence() {
    const auto* label = sheet_.findChild<QLabel*>("fault");
    return label->isVisible() ? label->text() : QString();
  }
  [[nodiscard]] const Body& now(std::size_t i) const { return scene_->bodies[i]; }
  [[nodiscard]] bool is_at(int row, int column) { return table().currentIndex() == at(row, column); }

  BodiesSheet sheet_{light_theme()};
  std::shared_ptr<const Scene> scene_;
  std::vector<QString> names_;  // of the edits
  std::vector<std::string> chosen_;
};

TEST_F(BodiesSheetTest, TypingReplacesAndEnterGoesDown) {
  click(0, Column::kMass);
  keys("2500 g");
  key(Qt::Key_Return);
  EXPECT_EQ(now(0).mass, 2.5);
  EXPECT_EQ(names_, std::vector<QString>{"Mass of light 1.00 → 2.50 kg"});
  EXPECT_TRUE(is_at(1, Column::kMass));
  EXPECT_EQ(field(), nullptr);
  keys("*2");
  key(Qt::Key_Return);
  EXPECT_EQ(now(1).mass, 2.0 / 3.0);
  EXPECT_EQ(text(0, Column::kMomentum), "5.000");
  EXPECT_EQ(text(3, Column::kMass), "3.167") << "all";
  EXPECT_EQ(text(3, Column::kVelocityX), "2.000") << "the centre of mass";
}

TEST_F(BodiesSheetTest, TheEditorHasEveryDigitAndEscapeRestores) {
  click(1, Column::kMass);
  EXPECT_EQ(text(1, Column::kMass), "0.3333");
  key(Qt::Key_F2);
  ASSERT_NE(field(), nullptr);
  EXPECT_EQ(field()->text(), "0.3333333333333333");
  keys("7");
  key(Qt::Key_Escape);
  EXPECT_EQ(now(1).mass, 1.0 / 3.0);
  key(Qt::Key_Return);
  ASSERT_NE(field(), nullptr);
  key(Qt::Key_Return);
  EXPECT_TRUE(names_.empty()) << "nothing was typed";
}

TEST_F(BodiesSheetTest, TheValueOfAFormulaIsShownByItsCell) {
  const auto* shown = table().findChild<QLabel*>("bubble");
  click(0, Column::kVelocityX);
  keys("*1.5");
  EXPECT_TRUE(shown->isVisible());
  EXPECT_EQ(shown->text(), "= 3 m/s");
  key(Qt::Key_Return);
  EXPECT_FALSE(shown->isVisible());
  keys("7");
  EXPECT_FALSE(shown->isVisible());
  key(Qt::Key_Escape);
}

TEST_F(BodiesSheetTest, TabGoesRightAndThenOut) {
  click(0, Column::kVelocityX);
  keys("1");
  key(Qt::Key_Tab);
  EXPECT_EQ(now(0).velocity, Vec2(1.0, 0.0));
  EXPECT_TRUE(is_at(0, Column::kVelocityY));
  key(Qt::Key_Tab);
  EXPECT_TRUE(is_at(0, Column::kSpin));
  key(Qt::Key_Tab);
  EXPECT_TRUE(is_at(0, Column::kRestitution));
  EXPECT_TRUE(table().hasFocus());
  QPushButton* button = sheet_.findChild<QPushButton*>();
  button->show();
  key(Qt::Key_Tab);
  EXPECT_TRUE(button->hasFocus());
  click(2, Column::kBody);
  key(Qt::Key_Tab);
  EXPECT_TRUE(is_at(2, Column::kX)) << "the mass of a fixed body is skipped";
  key(Qt::Key_Backtab, Qt::ShiftModifier);
  EXPECT_TRUE(is_at(2, Column::kBody));
}

TEST_F(BodiesSheetTest, ABadValueIsSaidAndTheOldOneHolds) {
  click(0, Column::kMass);
  keys("-1");
  key(Qt::Key_Return);
  ASSERT_NE(field(), nullptr);
  EXPECT_TRUE(field()->property("fault").toBool());
  EXPECT_EQ(sentence(), "Mass is more than 0.");
  EXPECT_TRUE(names_.empty());
  key(Qt::Key_Escape);
  EXPECT_EQ(sentence(), "");
  EXPECT_EQ(text(0, Column::kMass), "1.000");
  keys("3 m");
  click(1, Column::kX);
  EXPECT_TRUE(sentence().contains("no unit of this")) << sentence().toStdString();
  EXPECT_TRUE(names_.empty());
}

TEST_F(BodiesSheetTest, TheBounceIsThatOfTheSurface) {
  Scene scene = *scene_;
  Material wood;
  wood.name = "wood";
  wood.restitution = 0.6;
  scene.materials = {wood};
  scene.bodies[0].material = scene.bodies[1].material = "wood";
  give_ids(scene);
  scene_ = std::make_shared<const Scene>(scene);
  sheet_.show_moment(scene_, nullptr);
  EXPECT_EQ(text(0, Column::kRestitution), "0.6000");
  EXPECT_TRUE(at(0, Column::kRestitution)
                  .data(Qt::ToolTipRole)
                  .toString()
                  .contains("e of wood, the surface of 2 bodies: it changes for all of them"));
  click(0, Column::kRestitution);
  keys("0.8");
  key(Qt::Key_Return);
  EXPECT_EQ(names_, std::vector<QString>{"e of wood 0.600 → 0.800"});
  EXPECT_EQ(scene_->materials[0].restitution, 0.8);
  EXPECT_EQ(text(1, Column::kRestitution), "0.8000");
  EXPECT_EQ(text(3, Column::kRestitution), "") << "all";
  keys("1.2");
  key(Qt::Key_Return);
  EXPECT_EQ(sentence(), "e lies between 0 and 1.");
  key(Qt::Key_Escape);
  // That of a fixed body too; the surface that the scene does not list is added.
  QGuiApplication::clipboard()->setText("0.5\n0.5\n0.25");
  click(0, Column::kRestitution);
  key(Qt::Key_V, Qt::ControlModifier);
  EXPECT_EQ(names_.back(), "Paste 3 values");
  EXPECT_EQ(material_named(*scene_, "wood").restitution, 0.5);
  EXPECT_EQ(material_named(*scene_, now(2).material).restitution, 0.25);
}

TEST_F(BodiesSheetTest, TheMenuOfTheHeadShowsAndHidesColumns) {
  const auto is_shown = [this](Column column) { return !table().isColumnHidden(column); };
  EXPECT_TRUE(is_shown(Column::kMomentumX));
  EXPECT_TRUE(is_shown(Column::kEnergy));
  EXPECT_FALSE(is_shown(Column::kMomentum));
  EXPECT_EQ(sheet_.shown_columns(), (QStringList{"px", "py", "K"}));
  auto* button = sheet_.findChild<QToolButton*>();
  ASSERT_EQ(button->accessibleName(), "Columns");
  for (QAction* action : button->menu()->actions()) {
    if (action->text() == "p" || action->text() == "v relative to the centre of mass") action->trigger();
  }
  EXPECT_TRUE(is_shown(Column::kMomentum));
  EXPECT_TRUE(is_shown(Column::kRelativeY));
  EXPECT_GT(table().columnWidth(Column::kRelativeX), 20);
  EXPECT_EQ(sheet_.shown_columns(), (QStringList{"relative", "p", "px", "py", "K"}));
  table().clearSelection();
  key(Qt::Key_C, Qt::ControlModifier);
  EXPECT_TRUE(QGuiApplication::clipboard()->text().startsWith(
      "body\tm / kg\tx / m\ty / m\tvx / m/s\tvy / m/s\tvx from centre / m/s\tvy from centre / m/s\t"
      "spin / rad/s\te\tp / kg m/s\tpx / kg m/s\tpy / kg m/s\tK / J\n"));
  sheet_.show_columns({"L"});
  EXPECT_FALSE(is_shown(Column::kEnergy));
  EXPECT_TRUE(is_shown(Column::kAngularMomentum));
  // A right click on the head opens the same menu.
  QHeaderView* head = table().horizontalHeader();
  emit head->customContextMenuRequested(QPoint(20, 5));
  EXPECT_TRUE(button->menu()->isVisible());
  button->menu()->close();
}

// Two discs of 1 and 3 kg: the centre of mass moves at (1, 0.75) m/s.
TEST_F(BodiesSheetTest, WhatFollowsIsShownWithItsSum) {
  std::vector<Body> bodies = {body("A", 1.0, 0.0), body("B", 3.0, 2.0)};
  bodies[0].velocity = Vec2(4.0, 3.0);
  bodies[1].velocity = Vec2(0.0, 0.0);
  bodies[0].position = Vec2(0.0, 2.0);
  bodies[0].spin = 2.0;
  bodies[0].inertia = 0.5;
  show(bodies);
  const auto column = [this](Column c) { return QStringList{text(0, c), text(1, c), text(2, c)}; };
  EXPECT_EQ(column(Column::kSpeed), (QStringList{"5.000", "0", "1.250"}));
  EXPECT_EQ(column(Column::kDirection), (QStringList{"36.87", "", "36.87"}));
  EXPECT_EQ(column(Column::kRelativeX), (QStringList{"3.000", "−1.000", ""}));
  EXPECT_EQ(column(Column::kRelativeY), (QStringList{"2.250", "−0.7500", ""}));
  EXPECT_EQ(column(Column::kMomentum), (QStringList{"5.000", "0", "5.000"}));
  EXPECT_EQ(column(Column::kMomentumY), (QStringList{"3.000", "0", "3.000"}));
  EXPECT_EQ(column(Column::kAngularMomentum), (QStringList{"−7.000", "0", "−7.000"}));
  EXPECT_EQ(column(Column::kInertia)[0], "0.5000");
  EXPECT_EQ(column(Column::kRadius)[0], QString("0.1000"));
}

TEST_F(BodiesSheetTest, ADrivenBodyHasThePlaceAndVelocityOfItsDrive) {
  Body paddle = body("paddle", 1.0, 0.5);
  paddle = driven(paddle, {.velocity = Vec2::Zero(),
                           .amplitude = Vec2(0.1, 0.0),
                           .angular_frequency = 2.0 * std::numbers::pi,
                           .phase = 0.5 * std::numbers::pi});
  show({paddle, body("light", 1.0, -1.0)});
  auto frame = std::make_shared<Frame>();
  for (const auto& [time, place, speed] :
       {std::tuple(0.0, "0.6000", "0"), std::tuple(0.25, "0.5000", "−0.6283"),
        std::tuple(0.5, "0.4000", "0")}) {
    frame->time = time;
    scene_ = std::make_shared<const Scene>(*scene_);
    sheet_.show_moment(scene_, frame);
    EXPECT_EQ(text(0, Column::kX), place) << time;
    EXPECT_EQ(text(0, Column::kVelocityX), speed) << time;
    EXPECT_EQ(text(0, Column::kMass), "driven");
    EXPECT_EQ(text(2, Column::kVelocityX), "2.000") << "of what moves freely";
  }
}

TEST_F(BodiesSheetTest, NamesAreDifferent) {
  click(0, Column::kBody);
  keys("heavy");
  key(Qt::Key_Return);
  EXPECT_EQ(sentence(), "Another body is called heavy.");
  key(Qt::Key_Escape);
  keys("small");
  key(Qt::Key_Tab);
  EXPECT_EQ(now(0).name, "small");
  EXPECT_EQ(names_, std::vector<QString>{"Rename light to small"});
}

TEST_F(BodiesSheetTest, AMassTakesThePlaceOfADensity) {
  Body disc = body("disc", 1.0, 0.0);
  disc.mass.reset();
  disc.density = 5.0;
  show({disc});
  click(0, Column::kMass);
  keys("2");
  key(Qt::Key_Return);
  EXPECT_EQ(now(0).mass, 2.0);
  EXPECT_FALSE(now(0).density.has_value());
}

TEST_F(BodiesSheetTest, RoundingIsZero) {
  std::vector<Body> bodies = scene_->bodies;
  bodies[0].position.y() = 5.7e-16;
  bodies[0].velocity = {2.0, -3e-15};
  bodies[0].spin = -6.1e-34;
  show(bodies);
  for (const Column column :
       {Column::kY, Column::kVelocityY, Column::kSpin, Column::kMomentumY, Column::kDirection})
    EXPECT_EQ(text(0, column), "0") << column;
}

TEST_F(BodiesSheetTest, WhatFollowsSaysWhatToChange) {
  sheet_.show_columns({"p"});
  click(0, Column::kMomentum);
  EXPECT_EQ(sentence(), "p = m v: change m or v.");
  key(Qt::Key_F2);
  EXPECT_EQ(field(), nullptr);
  click(0, Column::kX);
  EXPECT_EQ(sentence(), "");
  EXPECT_EQ(text(2, Column::kMass), "fixed");
  EXPECT_EQ(text(2, Column::kVelocityX), "");
  click(2, Column::kMass);
  EXPECT_TRUE(sentence().startsWith("floor is fixed")) << sentence().toStdString();
  click(2, Column::kY);
  keys("-50 cm");
  key(Qt::Key_Return);
  EXPECT_EQ(now(2).position, Vec2(0.0, -0.5));
  EXPECT_EQ(names_, std::vector<QString>{"Move floor"});
}

TEST_F(BodiesSheetTest, PastesAsASpreadsheetDoesInOneStep) {
  QGuiApplication::clipboard()->setText("2\t0,5\r\n-3\t70 cm\r\n1\t1\r\n");
  click(0, Column::kMass);
  key(Qt::Key_V, Qt::ControlModifier);
  EXPECT_EQ(now(0).mass, 2.0);
  EXPECT_EQ(now(0).position.x(), 0.5);
  EXPECT_EQ(now(1).mass, 1.0 / 3.0) << "-3 kg can't be";
  EXPECT_DOUBLE_EQ(now(1).position.x(), 0.7);
  EXPECT_EQ(now(2).position.x(), 1.0);
  EXPECT_EQ(names_, std::vector<QString>{"Paste 4 values"});
  EXPECT_TRUE(sentence().contains("Mass is more than 0.")) << sentence().toStdString();
  const auto* rows = static_cast<const BodiesModel*>(table().model());
  EXPECT_NE(rows->fault(1, Column::kMass), nullptr);
  EXPECT_NE(rows->fault(2, Column::kMass), nullptr) << "a fixed body has none";
  EXPECT_EQ(rows->fault(0, Column::kMass), nullptr);
  key(Qt::Key_Escape);
  EXPECT_EQ(rows->fault(1, Column::kMass), nullptr);
}

TEST_F(BodiesSheetTest, RowsWithoutABodyAreSaid) {
  QGuiApplication::clipboard()->setText("0.1\n0.2\n0.3\n0.4\n0.5\n");
  click(0, Column::kX);
  key(Qt::Key_V, Qt::ControlModifier);
  EXPECT_EQ(now(2).position.x(), 0.3);
  EXPECT_EQ(sentence(), "2 rows had no body to go to.");
}

// Several cells go into several cells; one goes into what is typed.
TEST_F(BodiesSheetTest, PastesCellsAlsoWhileOneIsTyped) {
  click(0, Column::kMass);
  keys("7");
  ASSERT_NE(field(), nullptr);
  QGuiApplication::clipboard()->setText("2\t0.5\n3\t0.75\n");
  key(Qt::Key_V, Qt::ControlModifier);
  EXPECT_EQ(field(), nullptr);
  EXPECT_EQ(now(0).mass, 2.0);
  EXPECT_EQ(now(1).position.x(), 0.75);
  EXPECT_EQ(names_, std::vector<QString>{"Paste 4 values"});
  click(0, Column::kMass);
  keys("1");
  QGuiApplication::clipboard()->setText(".5\n");
  key(Qt::Key_V, Qt::ControlModifier);
  ASSERT_NE(field(), nullptr);
  key(Qt::Key_Return);
  EXPECT_EQ(now(0).mass, 1.5);
}

TEST_F(BodiesSheetTest, CopiesTheMarkedCellsAndComesBackUnchanged) {
  click(0, Column::kMass);
  key(Qt::Key_Down, Qt::ShiftModifier);
  key(Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_EQ(chosen_, (std::vector<std::string>{"light", "heavy"}));
  key(Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QGuiApplication::clipboard()->text(), "1\t-1\n0.3333333333333333\t1");
  table().clearSelection();
  key(Qt::Key_C, Qt::ControlModifier);
  EXPECT_TRUE(QGuiApplication::clipboard()->text().startsWith("body\tm / kg"));
  click(0, Column::kBody);
  key(Qt::Key_V, Qt::ControlModifier);
  EXPECT_TRUE(names_.empty());
  EXPECT_EQ(sentence(), "");
}

TEST_F(BodiesSheetTest, TheSelectionIsThatOfTheScene) {
  click(1, Column::kX);
  EXPECT_EQ(chosen_, std::vector<std::string>{"heavy"});
  sheet_.show_selection({"heavy"});
  EXPECT_TRUE(table().selectionModel()->isSelected(at(1, Column::kX)));
  chosen_.clear();
  sheet_.show_selection({"light"});
  EXPECT_TRUE(chosen_.empty());
  EXPECT_FALSE(table().selectionModel()->hasSelection());
  const auto* rows = static_cast<const BodiesModel*>(table().model());
  EXPECT_TRUE(rows->is_marked(0));
  EXPECT_FALSE(rows->is_marked(1));
  EXPECT_TRUE(is_at(0, Column::kX)) << "where the keys go on";
}

TEST_F(BodiesSheetTest, WhatIsTypedStaysWhileTheSceneIsShownAnew) {
  click(0, Column::kMass);
  keys("4");
  sheet_.show_moment(std::make_shared<const Scene>(*scene_), nullptr);
  ASSERT_NE(field(), nullptr);
  EXPECT_EQ(field()->text(), "4");
  // The runs are on their way to a moment: nothing can be typed.
  auto frame = std::make_shared<Frame>();
  frame->bodies = std::make_shared<const std::vector<Body>>(scene_->bodies);
  frame->state = initial_state(*frame->bodies);
  frame->state.v(0, 0) = 7.0;
  sheet_.show_moment(nullptr, frame);
  EXPECT_EQ(field(), nullptr);
  EXPECT_TRUE(names_.empty());
  EXPECT_EQ(text(0, Column::kVelocityX), "7.000");
  key(Qt::Key_F2);
  EXPECT_EQ(field(), nullptr);
  EXPECT_EQ(sentence(), "Nothing can be edited at this moment.");
  // That is over when they are there, whether a cell is current or none.
  sheet_.show_moment(std::make_shared<const Scene>(*scene_), nullptr);
  EXPECT_EQ(sentence(), "");
  sheet_.show_moment(nullptr, frame);
  key(Qt::Key_F2);
  EXPECT_EQ(sentence(), "Nothing can be edited at this moment.");
  table().setCurrentIndex({});
  sheet_.show_moment(std::make_shared<const Scene>(*scene_), nullptr);
  EXPECT_EQ(sentence(), "");
}

TEST_F(BodiesSheetTest, ShowsTheFirst200AndThenAll) {
  std::vector<Body> many;
  for (int i = 0; i < 300; ++i) many.push_back(body("b" + std::to_string(i), 1.0, i));
  show(many);
  EXPECT_EQ(table().model()->rowCount(), 201);
  EXPECT_EQ(text(200, Column::kMass), "300.0") << "the sums have all";
  auto* button = sheet_.findChild<QPushButton*>();
  ASSERT_TRUE(button->isVisible());
  EXPECT_EQ(button->text(), "Show all 300 bodies");
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(table().model()->rowCount(), 301);
  EXPECT_FALSE(button->isVisible());
}

TEST_F(BodiesSheetTest, SumsThatCancelAreZero) {
  std::vector<Body> bodies = {body("A", 0.1, 0.3), body("B", 0.2, -0.1), body("C", 0.3, -1.0 / 30.0)};
  bodies[0].velocity = Vec2(0.5, 0.3);
  bodies[1].velocity = Vec2(0.5, 0.1);
  bodies[2].velocity = Vec2(0.5, -1.0 / 6.0);
  double momentum = 0.0;
  for (const Body& each : bodies) momentum += *each.mass * each.velocity.y();
  ASSERT_NE(momentum, 0.0) << "by rounding";
  show(bodies);
  EXPECT_EQ(text(3, Column::kVelocityY), "0");
  EXPECT_EQ(text(3, Column::kX), "0");
  EXPECT_EQ(text(3, Column::kVelocityX), "0.5000");
}

// What rests on a floor keeps velocities of rounding.
TEST_F(BodiesSheetTest, WhatRestsHasNoSpeedsOfRounding) {
  std::vector<Body> bodies = {body("A", 1.0, 0.3), body("B", 2.0, -0.1)};
  bodies[0].velocity = Vec2(1.6e-15, -8.2e-15);
  bodies[1].velocity = Vec2(0.0, 1.1e-15);
  bodies[1].spin = -3e-16;
  show(bodies);
  for (int row = 0; row < 3; ++row) {
    for (const int column : {Column::kVelocityX, Column::kVelocityY, Column::kMomentumX, Column::kMomentumY,
                             Column::kAngularMomentum, Column::kEnergy})
      EXPECT_EQ(text(row, column), "0") << row << ", " << column;
  }
  EXPECT_EQ(text(1, Column::kSpin), "0");
}

TEST_F(BodiesSheetTest, CanBeReadAloud) {
  EXPECT_EQ(table().accessibleName(), "Bodies");
  const auto spoken = [this](int row, int column) {
    return at(row, column).data(Qt::AccessibleTextRole).toString();
  };
  EXPECT_EQ(spoken(0, Column::kMass), "mass of light: 1.000 kg");
  EXPECT_EQ(spoken(2, Column::kMass), "mass of floor: fixed");
  EXPECT_EQ(spoken(2, Column::kSpin), "spin of floor: none");
  EXPECT_EQ(spoken(3, Column::kEnergy), "kinetic energy of all: 2.667 J");
}

TEST_F(BodiesSheetTest, AnEmptySceneHasNoRow) {
  show({});
  EXPECT_EQ(table().model()->rowCount(), 0);
  show({body("light", 1.0, -1.0)});
  EXPECT_EQ(table().model()->rowCount(), 2);
}

TEST_F(BodiesSheetTest, AFailedPasteIsSaidUntilTheSceneIsAnother) {
  QGuiApplication::clipboard()->setText("-3");
  click(1, Column::kMass);
  key(Qt::Key_V, Qt::ControlModifier);
  const auto* rows = static_cast<const BodiesModel*>(table().model());
  sheet_.end_sentence();
  EXPECT_NE(sentence(), "") << "its cell is red";
  sheet_.forget_faults();
  EXPECT_EQ(rows->fault(1, Column::kMass), nullptr);
  EXPECT_EQ(sentence(), "");
}

TEST_F(BodiesSheetTest, CellsThatADragChangesHaveARing) {
  auto* rows = dynamic_cast<BodiesModel*>(table().model());
  ASSERT_NE(rows, nullptr);
  sheet_.watch_changes(true);
  std::vector<Body> bodies = scene_->bodies;
  bodies[0].velocity.x() = 3.0;
  show(bodies);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < rows->columnCount(); ++column)
      EXPECT_EQ(rows->is_changed(row, column), row == 0 && column == Column::kVelocityX) << column;
  }
  // Its border is painted in the accent.
  const QRect cell = table().visualRect(rows->index(0, Column::kVelocityX));
  const auto left_border = [&] {
    const QImage image = table().viewport()->grab(cell).toImage();
    return image.pixelColor(4, image.height() / 2);
  };
  EXPECT_EQ(left_border(), light_theme().accent);
  sheet_.watch_changes(false);
  EXPECT_NE(left_border(), light_theme().accent);
}

// R restarts and D draws a disc, also where a number has the focus.
TEST_F(BodiesSheetTest, ALetterBeginsANameOnly) {
  click(0, Column::kMass);
  keys("r");
  EXPECT_EQ(field(), nullptr);
  click(0, Column::kBody);
  keys("r");
  ASSERT_NE(field(), nullptr);
  EXPECT_EQ(field()->text(), "r");
}

}  // namespace
}  // namespace carom
