#include "widgets/scene/scene_accessible.h"

#include <QTest>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "tests/support/scene_fixture.h"
#include "tests/widgets/scene/scene_tools_fixture.h"
#include "tests/widgets/scene/scene_view_fixture.h"
#include "widgets/scene/value_bubble.h"

namespace carom {
namespace {

class SceneAccessibleTest : public SceneViewFixture {
 protected:
  void SetUp() override {
    SceneViewFixture::SetUp();
    show(preset_);
  }
  std::shared_ptr<const Frame> show(const Preset& preset, bool playing = false) {
    const auto frame = frame_of(Simulation(setup_of(preset)));
    frame->playing = playing;
    view_.set_frame(frame);
    return frame;
  }
  QAccessibleInterface* list() { return QAccessible::queryAccessibleInterface(&view_); }

  Preset preset_ = two_discs();
};

TEST_F(SceneAccessibleTest, TheSceneIsAListOfItsBodies) {
  Body& disc = preset_.scene.bodies[1];
  disc.name = "light";
  disc.shape = Disc{0.1};
  disc.mass = 1.0;
  disc.density.reset();
  disc.position = {-0.85, -0.16};
  disc.velocity = {std::sqrt(3.0), 1.0};
  disc.spin = -0.5;
  show(preset_);
  ASSERT_EQ(list()->role(), QAccessible::List);
  const int bodies = static_cast<int>(preset_.scene.bodies.size());
  ASSERT_GT(list()->childCount(), bodies) << "what lies over the scene too";
  QAccessibleInterface* over = list()->child(bodies);
  ASSERT_NE(over, nullptr);
  EXPECT_NE(over->object(), nullptr);
  EXPECT_EQ(list()->indexOfChild(over), bodies);
  QAccessibleInterface* item = list()->child(1);
  EXPECT_EQ(item->text(QAccessible::Name),
            QString::fromUtf8("light, disc, 1 kg, x −0.85 m, y −0.16 m, 2 m/s at 30°, "
                              "spin −0.5 rad/s"));
  EXPECT_EQ(list()->indexOfChild(item), 1);
  EXPECT_EQ(item->parent(), list());
  EXPECT_EQ(list()->child(99), nullptr);
  // 100 px/m about the world's origin in the middle.
  const QRect place = item->rect().translated(-view_.mapToGlobal(QPoint()));
  EXPECT_EQ(place, QRect(205, 206, 20, 20));
  const QPoint at = view_.mapToGlobal(QPoint(215, 216));
  EXPECT_EQ(list()->childAt(at.x(), at.y()), item);
  EXPECT_EQ(list()->childAt(-1000, 0), nullptr);
}

TEST_F(SceneAccessibleTest, AnItemIsSelectedByItsAction) {
  QAccessibleInterface* item = list()->child(1);
  EXPECT_FALSE(item->state().selected);
  auto* actions = item->actionInterface();
  ASSERT_NE(actions, nullptr);
  actions->doAction(QAccessibleActionInterface::pressAction());
  EXPECT_EQ(view_.selection(), std::vector{preset_.scene.bodies[1].name});
  EXPECT_TRUE(item->state().selected);
  EXPECT_FALSE(list()->child(0)->state().selected);
}

// After the bodies; their action opens the field of their value.
TEST_F(SceneAccessibleTest, HandlesHaveNamesAndValues) {
  Body& disc = preset_.scene.bodies[1];
  disc.name = "light";
  disc.shape = Disc{0.1};
  disc.velocity = {std::sqrt(3.0), 1.0};
  preset_.scene.bodies[1].fixed = false;
  const auto frame = frame_of(Simulation(setup_of(preset_)));
  frame->scene = std::make_shared<const Scene>(preset_.scene);
  view_.set_frame(frame);
  const int bodies = static_cast<int>(preset_.scene.bodies.size());
  const int before = list()->childCount();
  view_.select({"light"});
  std::map<QString, QString> told;
  QAccessibleInterface* radius = nullptr;
  for (int i = bodies; i < bodies + (list()->childCount() - before); ++i) {
    QAccessibleInterface* handle = list()->child(i);
    told[handle->text(QAccessible::Name)] = handle->text(QAccessible::Value);
    if (handle->text(QAccessible::Name) == "Radius of light") radius = handle;
    EXPECT_EQ(list()->indexOfChild(handle), i);
    const QPoint at = handle->rect().center();
    EXPECT_EQ(list()->childAt(at.x(), at.y()), handle);
  }
  EXPECT_EQ(told, (std::map<QString, QString>{{"Radius of light", "0.1 m"},
                                              {"Angle of light", "0°"},
                                              {"Spin of light", "0 rad/s"},
                                              {"Speed and direction of light", "2 m/s, 30°"}}));
  ASSERT_NE(radius, nullptr);
  radius->actionInterface()->doAction(QAccessibleActionInterface::pressAction());
  EXPECT_TRUE(view_.findChild<ValueBubble*>()->isVisibleTo(&view_));
  view_.select({});
  EXPECT_EQ(list()->childCount(), before);
  EXPECT_FALSE(radius->isValid());
  EXPECT_EQ(list()->indexOfChild(radius), -1);
}

TEST_F(SceneAccessibleTest, HandlesOfOneBodyAreToldApart) {
  const std::vector<Shape> shapes = {Box{0.4, 0.3}, Polygon{{{0, 0}, {0.5, 0}, {0.2, 0.4}}}};
  for (const Shape& shape : shapes) {
    Body& body = preset_.scene.bodies[1];
    body.shape = shape;
    const auto frame = frame_of(Simulation(setup_of(preset_)));
    frame->scene = std::make_shared<const Scene>(preset_.scene);
    view_.set_frame(frame);
    view_.select({body.name});
    std::set<QString> names;
    const auto told = view_.told_handles();
    for (const auto& handle : told) names.insert(handle.name);
    EXPECT_GT(told.size(), 5U);
    EXPECT_EQ(names.size(), told.size());
  }
}

TEST_F(SceneAccessibleTest, ASelectionAndWhatBecomesOfItAreSaid) {
  SpokenBody spoken;
  const std::vector<std::string> selection = {"A", "B"};
  EXPECT_FALSE(spoken.selected(view_.frame(), {}));
  EXPECT_FALSE(spoken.selected(nullptr, selection));
  const auto first = spoken.selected(view_.frame(), selection);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->event, QAccessible::Focus);
  EXPECT_EQ(first->body, 2);
  EXPECT_FALSE(spoken.shown(show(preset_).get(), selection)) << "nothing has changed";
  preset_.scene.bodies[2].position.x() += 0.01;
  const auto moved = spoken.shown(show(preset_).get(), selection);
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->event, QAccessible::NameChanged);
  EXPECT_EQ(moved->body, 2);
  preset_.scene.bodies[2].position.x() += 0.01;
  EXPECT_FALSE(spoken.shown(show(preset_, true).get(), selection)) << "never the running clock";
}

class SpokenValueTest : public SceneToolsTest {};

TEST_F(SpokenValueTest, AValueIsSaidAfterEachKey) {
  answers_ = true;
  view_.select({"A"});
  for (const char* value : {"2.1", "2.2"}) {
    QTest::keyClick(&view_, Qt::Key_Up, Qt::ControlModifier);
    EXPECT_TRUE(view_.bubble().value.startsWith(value)) << view_.bubble().value.toStdString();
    EXPECT_TRUE(view_.accessibleDescription().startsWith(view_.bubble().value));
  }
  view_.say("paused");
  view_.set_theme(dark_theme());
  EXPECT_EQ(view_.accessibleDescription(), "paused") << "a bubble is said once";
}

TEST_F(SceneAccessibleTest, OfAFrameWithFewerBodiesNoOtherIsLeft) {
  QAccessibleInterface* last = list()->child(static_cast<int>(preset_.scene.bodies.size()) - 1);
  ASSERT_TRUE(last->isValid());
  preset_.scene.bodies.pop_back();
  show(preset_);
  EXPECT_FALSE(last->isValid());
  EXPECT_TRUE(last->state().invalid);
  EXPECT_EQ(last->text(QAccessible::Name), "");
  view_.clear();
  EXPECT_FALSE(list()->child(0) != nullptr && list()->child(0)->role() == QAccessible::ListItem);
}

}  // namespace
}  // namespace carom
