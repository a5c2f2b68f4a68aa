#include "widgets/scene/drawing_jump.h"

#include "tests/support/run_fixture.h"
#include "tests/widgets/scene/scene_view_fixture.h"
#include "widgets/scene/text_places.h"

// 1 kg at 3 m/s hits 2 kg at rest at 0.2 s, elastically: they leave at -1 and 2 m/s, and each gets 4 N s.
namespace carom {
namespace {

class DrawingJump : public SceneViewFixture {
 protected:
  void SetUp() override {
    SceneViewFixture::SetUp();
    show(head_on_scene());
  }
  // The end of the step that has the impact, which is picked.
  void show(const Preset& preset) {
    Simulation run(setup_of(preset));
    run.watch_impacts(true);
    while (run.last_impacts().empty()) run.step();
    auto frame = std::make_shared<Frame>(run_to(preset, run.time()));
    frame->jumps = jump_moments(run);
    ASSERT_EQ(frame->jumps.size(), 1U);
    view_.set_picked(frame->jumps.front()->time());
    view_.set_frame(frame);
  }
  [[nodiscard]] const Drawing::Jump& jump() const { return view_.drawing().jump; }
  [[nodiscard]] QStringList texts() const {
    QStringList all;
    for (const Drawing::JumpText& text : jump().texts) all << text.text;
    return all;
  }
  [[nodiscard]] std::vector<bool> hollow() const {
    std::vector<bool> all;
    for (const Drawing::JumpArrow& arrow : jump().arrows) all.push_back(arrow.hollow);
    return all;
  }
};

TEST_F(DrawingJump, VelocitiesBeforeAndAfterAndTheImpulseOnEach) {
  EXPECT_EQ(texts(), (QStringList{"A 3.00 m/s", "A 1.00 m/s", "B 0 m/s", "B 2.00 m/s",
                                  "each gets 4.00 N·s\nlost 0 J, e = 1.00", "just before", "just after"}));
  // B's velocity before is zero, so it has no arrow.
  ASSERT_EQ(hollow(), (std::vector{true, false, false, false, false}));
  const auto& arrows = jump().arrows;
  EXPECT_GT(arrows[0].to.x(), arrows[0].from.x());
  EXPECT_GT(arrows[0].from.y(), 0.2) << "before stands over the bodies";
  EXPECT_LT(arrows[1].to.x(), arrows[1].from.x());
  EXPECT_LT(arrows[1].from.y(), -0.2) << "after stands under them";
  EXPECT_NEAR((arrows[0].to - arrows[0].from).norm(), 3.0 * (arrows[1].to - arrows[1].from).norm(), 1e-9);
  EXPECT_NEAR(arrows[3].from.x(), -0.2, 1e-9) << "at the contact";
  EXPECT_NEAR((arrows[3].to + arrows[4].to - 2.0 * arrows[4].from).norm(), 0.0, 1e-9) << "opposite";
}

TEST_F(DrawingJump, TakesThePlaceOfTheBodiesOwnArrowsAndNames) {
  EXPECT_TRUE(view_.drawing().arrows.empty());
  EXPECT_TRUE(view_.drawing().labels.empty());
  EXPECT_EQ(view_.drawing().marks.size(), 1U) << "its mark can be clicked";
  view_.select({"A"});
  EXPECT_EQ(view_.drawing().arrows.size(), 1U) << "a selected body has the arrow of its handle";
}

TEST_F(DrawingJump, TextsStandClearOfBodiesHandlesAndEachOther) {
  const auto places = [this] { return jump_places(view_.drawing(), view_.camera(), view_.font(), {}); };
  const auto body = [this](std::size_t k) {
    const Drawing::DiscItem& disc = view_.drawing().discs[k];
    Obstacles out;
    out.discs.push_back({view_.camera().to_screen(disc.center), disc.radius * view_.camera().scale});
    return out;
  };
  for (int zoom = 0; zoom < 12; ++zoom) {
    const std::vector<QRectF> all = places();
    ASSERT_EQ(all.size(), 7U);
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(body(0).covered_by(all[i]) + body(1).covered_by(all[i]), 0)
          << "text " << i << ", zoom " << zoom;
      for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(all[i].intersects(all[k])) << i << " and " << k;
    }
    if (view_.drawing().discs[0].radius * view_.camera().scale > 90.0) break;
    view_.zoom_in();
  }
  Obstacles handle;
  handle.rects.push_back(places().front());
  EXPECT_EQ(handle.covered_by(jump_places(view_.drawing(), view_.camera(), view_.font(), handle).front()), 0);
}

// Over and under the bodies, the dashed line between them is left free.
TEST_F(DrawingJump, VelocitiesStandOnTheSideOfTheirBody) {
  const std::vector<QRectF> all = jump_places(view_.drawing(), view_.camera(), view_.font(), {});
  const double line = view_.camera().to_screen(jump().arrows.back().from).x();
  ASSERT_EQ(all.size(), 7U);
  for (const std::size_t of_a : {0U, 1U}) EXPECT_LT(all[of_a].right(), line) << of_a;
  for (const std::size_t of_b : {2U, 3U}) EXPECT_GT(all[of_b].left(), line) << of_b;
}

TEST_F(DrawingJump, TheScaleOfVelocitiesStays) { EXPECT_GT(view_.drawing().velocity_key.amount, 0.0); }

TEST_F(DrawingJump, OneSwitchHidesIt) {
  DrawingOptions options = view_.options();
  options.jumps = false;
  view_.set_options(options);
  EXPECT_TRUE(jump().arrows.empty());
  EXPECT_EQ(view_.drawing().labels.size(), 2U);
  options.jumps = true;
  view_.set_options(options);
  EXPECT_FALSE(jump().arrows.empty());
  view_.set_picked(std::nullopt);
  EXPECT_TRUE(jump().arrows.empty());
}

TEST_F(DrawingJump, PairsThatMeetAtOneMomentHaveALineEach) {
  Preset preset;
  preset.scene.bodies = {disc("A", {-0.4, 0.0}, {3.0, 0.0}, 1.0), disc("B", {0.4, 0.0}, {0.0, 0.0}, 2.0),
                         disc("C", {-0.4, 2.0}, {3.0, 0.0}, 1.0), disc("D", {0.4, 2.0}, {0.0, 0.0}, 2.0)};
  show(preset);
  ASSERT_EQ(jump().axes.size(), 2U);
  EXPECT_EQ(texts().filter("just before").size(), 2);
  EXPECT_EQ(texts().filter("lost 0 J").size(), 2);
  for (const Drawing::JumpText& text : jump().texts) {
    const QChar who = text.text[0];
    if (text.text[1] == ' ') {
      EXPECT_EQ(text.at.y() > 1.0, who == 'C' || who == 'D');
    }
  }
}

// Beside a fast body what is left of an impact at rest is nothing.
TEST_F(DrawingJump, FiguresOfRoundingAreNotShown) {
  Preset preset = head_on_scene();
  preset.scene.bodies.push_back(disc("fast", {0.0, 3.0}, {5.0, 0.0}, 1.0));
  Simulation run(setup_of(preset));
  run.watch_impacts(true);
  while (run.last_impacts().empty()) run.step();
  auto frame = std::make_shared<Frame>(run_to(preset, run.time()));
  const auto known = jump_moments(run);
  auto moment = std::make_shared<JumpMoment>(*known.front());
  ImpactRecord& impact = moment->records.front();
  impact.normal_impulse = 2.2e-19;
  impact.closing_speed = 2.5e-17;
  for (Jump& each : moment->jumps) {
    each.before.v.col(BodyIndex{0}) *= 1e-17;
    each.after.v.col(BodyIndex{0}) *= 1e-17;
    each.after.v.col(BodyIndex{1}) *= 1e-17;
  }
  frame->jumps = {moment};
  view_.set_picked(moment->time());
  view_.set_frame(frame);
  EXPECT_EQ(texts(), (QStringList{"A 0 m/s", "A 0 m/s", "B 0 m/s", "B 0 m/s", "each gets 0 N·s\nlost 0 J",
                                  "just before", "just after"}));
  EXPECT_TRUE(jump().arrows.empty());
}

// Eight discs fall on a plate that moves freely, so that they are one group.
TEST_F(DrawingJump, OfManyImpactsTheLargestAreTold) {
  Preset preset;
  Body plate = disc("plate", {0.0, 0.0}, {0.0, 0.0}, 1000.0);
  plate.shape = Box{8.0, 1.0};
  preset.scene.bodies = {plate};
  for (int i = 0; i < 8; ++i)
    preset.scene.bodies.push_back(
        disc("disc " + std::to_string(i), {-3.5 + 1.0 * i, 1.0}, {0.0, -3.0}, 1.0 + i));
  show(preset);
  ASSERT_EQ(view_.drawing().marks.size(), 8U);
  const QStringList told = texts().filter("gets");
  EXPECT_EQ(told.size(), 6) << told.join("; ").toStdString();
}

TEST_F(DrawingJump, AtAWallTheBodyAlone) {
  Preset preset;
  Body floor;
  floor.name = "floor";
  floor.shape = Wall{};
  floor.position = Vec2(0.0, -0.5);
  floor.fixed = true;
  preset.scene.bodies = {disc("ball", {0.0, 0.0}, {0.0, -2.0}, 1.0), floor};
  Material dull;
  dull.restitution = 0.5;
  preset.scene.materials = {dull};
  show(preset);
  EXPECT_EQ(texts(), (QStringList{"ball 2.00 m/s", "ball 1.00 m/s",
                                  "ball gets 3.00 N·s\nlost 1.50 J, e = 0.500", "just before", "just after"}));
  ASSERT_EQ(jump().arrows.size(), 3U);
  EXPECT_LT(jump().arrows[0].from.x(), -0.2) << "before stands at the left";
  EXPECT_GT(jump().arrows[1].from.x(), 0.2);
  EXPECT_GT(jump().axes.front().first.y(), -0.4) << "through the ball, clear of the floor";
}

}  // namespace
}  // namespace carom
