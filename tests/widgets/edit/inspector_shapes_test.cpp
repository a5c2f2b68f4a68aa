#include "tests/widgets/edit/inspector_fixture.h"

// Bodies of several shapes in the inspector.
namespace carom {
namespace {

// A hammer "light": a handle of 0.1 m × 0.6 m under a head of 0.4 m × 0.2 m, 2 kg, turned to the left.
class InspectorShapesTest : public InspectorTest {
 protected:
  InspectorShapesTest() {
    Body body = light();
    body.shape = Compound{{{Box{0.1, 0.6}, Vec2(0.0, 0.0), 0.0, {}}, {Box{0.4, 0.2}, Vec2(0.0, 0.4), 0.0, {}}}};
    body.angle = 0.5;
    body.spin = 3.0;
    body.mass = 2.0;
    apply({Replace<Body>{body}});
    select({"light"});
  }
  // m and m/s: of its first shape.
  [[nodiscard]] Body handle() { return bodies_of(std::get<Compound>(light().shape), light())[0]; }
};

TEST_F(InspectorShapesTest, ListsTheFieldsOfEachShape) {
  label("2 shapes");
  label("Shape 1 · box");
  EXPECT_EQ(field("Height of shape 1, m")->text(), "0.6");
  EXPECT_EQ(field("Position y of shape 2, m")->text(), "0.4");
  EXPECT_FALSE(has_field("Radius of shape 1, m"));
  EXPECT_FALSE(has_field("Width, m"));
}

TEST_F(InspectorShapesTest, AnEditLeavesTheOtherShapesWhereTheyAre) {
  const Body before = handle();
  enter(field("Width of shape 2, m"), "80 cm");
  ASSERT_EQ(made_.size(), 1U);
  EXPECT_EQ(made_[0].name, "Width of shape 2 of light 0.400 → 0.800 m");
  EXPECT_EQ(std::get<Box>(std::get<Compound>(light().shape).shapes[1].shape).width, 0.8);
  EXPECT_LT((handle().position - before.position).norm(), 1e-12);
  EXPECT_LT((handle().velocity - before.velocity).norm(), 1e-12);
  enter(field("Position x of shape 2, m"), "10 cm");
  EXPECT_EQ(made_.back().name, "Move shape 2 of light");
  EXPECT_LT((handle().position - before.position).norm(), 1e-12);
  enter(field("Angle of shape 2, °"), "90°");
  EXPECT_EQ(made_.back().name, "Turn shape 2 of light");
}

TEST_F(InspectorShapesTest, AShapeHasASurfaceOfItsOwn) {
  QComboBox* surface = box("Surface of shape 2");
  EXPECT_EQ(surface->currentText(), "as the body");
  choose_below(surface, 2);
  EXPECT_EQ(made_.back().name, "Surface of shape 2 of light: rubber");
  EXPECT_EQ(std::get<Compound>(light().shape).shapes[1].material, "rubber");
  select({});
  EXPECT_TRUE(texts().join(' ').contains("rubber"));
}

// Areas 0.06 and 0.08 m²: the centre of mass is 0.4 · 4/7 m up, and with 2 kg
// I = 2 (3/7 (0.37/12 + (1.6/7)²) + 4/7 (0.2/12 + (1.2/7)²)) kg m².
TEST_F(InspectorShapesTest, ItsInertiaIsThatOfThePlate) {
  const double inertia = 2.0 * (3.0 / 7.0 * (0.37 / 12.0 + 0.4 * 0.4 * 16.0 / 49.0) +
                                4.0 / 7.0 * (0.2 / 12.0 + 0.4 * 0.4 * 9.0 / 49.0));
  EXPECT_NEAR(inertia_of(light()), inertia, 1e-12);
  const QStringList derived = derived_texts({light()});
  EXPECT_EQ(derived[0].simplified().replace(QChar::Nbsp, ' '), "p 4.00 kg m/s");
  EXPECT_EQ(derived[1].simplified().replace(QChar::Nbsp, ' '),
            QString("K %1 J").arg(0.5 * 2.0 * 4.0 + 0.5 * inertia * 9.0, 0, 'f', 2));
  EXPECT_EQ(derived[3].simplified().replace(QChar::Nbsp, ' '), QString("I %1 kg m²").arg(inertia, 0, 'f', 3));
}

}  // namespace
}  // namespace carom
