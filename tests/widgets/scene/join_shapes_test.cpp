#include "widgets/scene/join_shapes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <span>

#include "physics/scene/edit_rules.h"

namespace carom {
namespace {

constexpr double kSame = 1e-12;

Body body_of(const char* name, const Shape& shape, const Vec2& position, const Vec2& velocity = Vec2::Zero()) {
  Body body;
  body.name = name;
  body.shape = shape;
  body.position = position;
  body.velocity = velocity;
  return body;
}

Polygon ell() { return {{{0.0, 0.0}, {0.6, 0.0}, {0.6, 0.2}, {0.2, 0.2}, {0.2, 0.7}, {0.0, 0.7}}}; }

// Of all kinds of shapes, turned and moving.
std::vector<Body> mixed_bodies() {
  std::vector<Body> bodies = {
      body_of("A", Disc{0.3}, {1.0, -0.5}, {0.4, -1.2}),
      body_of("B", Box{0.5, 0.2}, {1.4, -0.3}, {-2.0, 0.3}),
      body_of("C", ell(), {0.2, 0.4}, {0.1, 0.9}),
      body_of("D", Polygon{{{0.0, 0.0}, {0.4, 0.1}}, 0.1}, {-0.7, 0.2}, {0.0, -0.6}),
  };
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const auto n = static_cast<double>(k);
    bodies[k].angle = 0.7 - 0.9 * n;
    bodies[k].spin = 1.5 - n;
    bodies[k].density = 2.5;
  }
  return bodies;
}

double angular_momentum(const Body& body, const Vec2& about) {
  return inertia_of(body) * body.spin + mass_of(body) * cross(body.position - about, body.velocity);
}
double kinetic_energy(const Body& body) {
  return 0.5 * mass_of(body) * body.velocity.squaredNorm() + 0.5 * inertia_of(body) * body.spin * body.spin;
}

// m, in the plane.
std::vector<Vec2> corners_of(const Body& body) {
  std::vector<Vec2> all;
  for (const ConvexPart& part : convex_parts(body.shape)) {
    for (const Vec2& v : part.outline.vertices)
      all.push_back(body.position + turned_by(body.angle, part.position + v));
  }
  return all;
}
std::vector<Vec2> corners_of(const std::vector<Body>& bodies) {
  std::vector<Vec2> all;
  for (const Body& body : bodies) {
    const std::vector<Vec2> own = corners_of(body);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

void expect_same_places(const std::vector<Vec2>& places, const std::vector<Vec2>& expected) {
  ASSERT_EQ(places.size(), expected.size());
  for (std::size_t k = 0; k < places.size(); ++k) EXPECT_LT((places[k] - expected[k]).norm(), kSame) << k;
}

// Two unit squares of 1 kg side by side, passing one another.
TEST(JoinedBody, TurnsAsThePlasticJoiningOfTwoSquares) {
  std::vector<Body> squares = {body_of("A", Box{1.0, 1.0}, {0.0, 0.0}, {3.0, 1.0}),
                               body_of("B", Box{1.0, 1.0}, {1.0, 0.0}, {3.0, -1.0})};
  const Body whole = joined(squares);
  EXPECT_EQ(whole.name, "A");
  EXPECT_LT((whole.position - Vec2(0.5, 0.0)).norm(), kSame);
  EXPECT_LT((whole.velocity - Vec2(3.0, 0.0)).norm(), kSame);
  EXPECT_EQ(mass_of(whole), 2.0);
  EXPECT_FALSE(whole.inertia) << "a plate of 2 m × 1 m";
  EXPECT_NEAR(inertia_of(whole), 2.0 * (4.0 + 1.0) / 12.0, kSame);
  EXPECT_NEAR(whole.spin, -1.0 / (5.0 / 6.0), kSame);
  EXPECT_NEAR(kinetic_energy(whole), 9.0 + 0.6, kSame) << "0.4 J of 10 J are lost";
}

TEST(JoinedBody, KeepsMomentumAndEveryOutline) {
  const std::vector<Body> bodies = mixed_bodies();
  const Body whole = joined(bodies);
  double mass = 0.0;
  double energy = 0.0;
  double about_centre = 0.0;
  Vec2 momentum = Vec2::Zero();
  for (const Body& body : bodies) {
    mass += mass_of(body);
    momentum += mass_of(body) * body.velocity;
    energy += kinetic_energy(body);
    about_centre += angular_momentum(body, whole.position);
  }
  EXPECT_NEAR(mass_of(whole), mass, kSame);
  EXPECT_LT((mass_of(whole) * whole.velocity - momentum).norm(), kSame);
  EXPECT_NEAR(angular_momentum(whole, whole.position), about_centre, kSame);
  EXPECT_LE(kinetic_energy(whole), energy);
  expect_same_places(corners_of(whole), corners_of(bodies));
}

// Joined in two steps, as in one.
TEST(JoinedBody, OpensCompounds) {
  const std::vector<Body> bodies = mixed_bodies();
  const Body half = joined(std::span(bodies).first(2));
  const Body whole = joined(std::vector{half, bodies[2], bodies[3]});
  const Body at_once = joined(bodies);
  EXPECT_EQ(std::get<Compound>(whole.shape).shapes.size(), 4U);
  expect_same_places(corners_of(whole), corners_of(at_once));
  EXPECT_LT((whole.velocity - at_once.velocity).norm(), kSame);
  EXPECT_NEAR(whole.spin, at_once.spin, kSame);
  EXPECT_NEAR(inertia_of(whole), inertia_of(at_once), kSame);
}

TEST(JoinedBody, KeepsTheSurfaceOfEachShape) {
  std::vector<Body> bodies = mixed_bodies();
  bodies[0].material = "wood";
  bodies[1].material = "wood";
  const Body whole = joined(bodies);
  EXPECT_EQ(whole.material, "wood");
  const std::vector<PlacedShape>& shapes = std::get<Compound>(whole.shape).shapes;
  EXPECT_EQ(shapes[1].material, "");
  EXPECT_EQ(shapes[2].material, "default");
  const std::vector<Body> parts = taken_apart(whole);
  for (std::size_t k = 0; k < parts.size(); ++k) EXPECT_EQ(parts[k].material, bodies[k].material);
}

// A heavy disc in the middle of a light square.
TEST(JoinedBody, StatesTheInertiaOfWhatIsNotHomogeneous) {
  std::vector<Body> bodies = {body_of("A", Box{1.0, 1.0}, {0.0, 0.0}), body_of("B", Disc{0.2}, {0.0, 0.0})};
  bodies[1].mass = 3.0;
  const Body whole = joined(bodies);
  ASSERT_TRUE(whole.inertia);
  EXPECT_NEAR(*whole.inertia, 1.0 / 6.0 + 3.0 * 0.02, kSame);
}

TEST(TakenApartBody, MovesOnAsARigidBody) {
  std::vector<Body> bodies = mixed_bodies();
  const Vec2 about(0.3, -0.2);
  for (Body& body : bodies) {
    body.spin = 1.7;
    body.velocity = Vec2(0.5, -0.1) + body.spin * crossed(body.position - about);
  }
  const std::vector<Body> parts = taken_apart(joined(bodies));
  ASSERT_EQ(parts.size(), bodies.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    EXPECT_LT((parts[k].position - bodies[k].position).norm(), kSame) << k;
    EXPECT_NEAR(parts[k].angle, bodies[k].angle, kSame) << k;
    EXPECT_LT((parts[k].velocity - bodies[k].velocity).norm(), kSame) << k;
    EXPECT_NEAR(parts[k].spin, 1.7, kSame) << k;
    EXPECT_NEAR(mass_of(parts[k]), mass_of(bodies[k]), kSame) << k;
  }
  expect_same_places(corners_of(parts), corners_of(bodies));
}

TEST(TakenApartBody, SharesTheMassOfThinRodsByLength) {
  std::vector<Body> rods = {body_of("A", Wall{1.0}, {0.0, 0.0}), body_of("B", Wall{3.0}, {2.0, 0.0})};
  rods[0].mass = 0.5;
  rods[1].mass = 1.5;
  const Body whole = joined(rods);
  EXPECT_LT((whole.position - Vec2(1.5, 0.0)).norm(), kSame);
  EXPECT_NEAR(inertia_of(whole), 2.0 * 16.0 / 12.0, kSame) << "one rod of 4 m";
  const std::vector<Body> parts = taken_apart(whole);
  EXPECT_NEAR(mass_of(parts[0]), 0.5, kSame);
  EXPECT_NEAR(mass_of(parts[1]), 1.5, kSame);
}

class JoiningTest : public testing::Test {
 protected:
  JoiningTest() {
    scene_.bodies = mixed_bodies();
    give_ids(scene_);
  }
  [[nodiscard]] QString refusal(const std::vector<std::string>& names) const {
    const Regrouping made = joining(scene_, names);
    EXPECT_EQ(made.refusal.isEmpty(), !made.edits.empty());
    return made.refusal;
  }
  // The scene after the edits, and all that they take along.
  [[nodiscard]] Scene after(const Regrouping& made) const {
    EXPECT_TRUE(made.refusal.isEmpty()) << made.refusal.toStdString();
    Scene scene = scene_;
    apply_edits(scene, with_followers(scene, made.edits));
    return scene;
  }
  void add_joint(JointKind kind, const char* body, const Vec2& point, const char* to, const Vec2& anchor) {
    Joint joint;
    joint.kind = kind;
    joint.body = body;
    joint.point = point;
    joint.to = to;
    joint.anchor = anchor;
    scene_.joints.push_back(joint);
    give_ids(scene_);
  }
  [[nodiscard]] static Vec2 place(const Scene& scene, const std::string& name, const Vec2& point) {
    if (name.empty()) return point;
    const auto body =
        std::find_if(scene.bodies.begin(), scene.bodies.end(), [&](const Body& b) { return b.name == name; });
    return body->position + turned_by(body->angle, point);
  }
  Scene scene_;
};

TEST_F(JoiningTest, MakesOneBodyCalledAsTheFirst) {
  const Regrouping made = joining(scene_, std::vector<std::string>{"B", "A"});
  EXPECT_EQ(made.name, "Join B and A into one body");
  EXPECT_EQ(made.bodies, std::vector<std::string>{"B"});
  const Scene now = after(made);
  ASSERT_EQ(now.bodies.size(), 3U);
  EXPECT_EQ(now.bodies[0].name, "B");
  EXPECT_EQ(now.bodies[0].id, scene_.bodies[1].id);
  EXPECT_EQ(joining(scene_, std::vector<std::string>{"B", "A", "C"}).name, "Join B, A and C into one body");
}

TEST_F(JoiningTest, JointsHoldTheBodyAtTheSamePlace) {
  add_joint(JointKind::kWeld, "A", {0.1, 0.0}, "B", {0.0, 0.1});
  add_joint(JointKind::kRod, "B", {0.2, 0.1}, "C", {-0.1, 0.1});
  add_joint(JointKind::kWeld, "C", {0.0, 0.2}, "A", {0.1, 0.2});
  scene_.joints[2].angle = scene_.bodies[2].angle - scene_.bodies[0].angle;
  add_joint(JointKind::kPin, "B", {0.0, 0.1}, "", {0.5, 0.5});
  const Scene now = after(joining(scene_, std::vector<std::string>{"A", "B"}));
  ASSERT_EQ(now.joints.size(), 3U) << "the weld between them goes";
  for (std::size_t k = 0; k < 3; ++k) {
    const Joint& was = scene_.joints[k + 1];
    const Joint& is = now.joints[k];
    EXPECT_EQ(is.id, was.id);
    EXPECT_LT((place(now, is.body, is.point) - place(scene_, was.body, was.point)).norm(), kSame);
    EXPECT_LT((place(now, is.to, is.anchor) - place(scene_, was.to, was.anchor)).norm(), kSame);
  }
  EXPECT_EQ(now.joints[1].to, "A");
  EXPECT_NEAR(*now.joints[1].angle, now.bodies[1].angle - now.bodies[0].angle, kSame);
}

// B hangs on two rods and C on one: with A joined to B all three would stretch.
TEST_F(JoiningTest, JointsTakeOutWhatTheyForbid) {
  for (Body& body : scene_.bodies) {
    if (body.name == "A") continue;
    body.velocity.setZero();
    body.spin = 0.0;
  }
  add_joint(JointKind::kRod, "B", {0.2, 0.1}, "", {3.0, 0.0});
  add_joint(JointKind::kRod, "B", {0.0, 0.0}, "C", {0.0, 0.0});
  add_joint(JointKind::kRod, "C", {0.1, 0.0}, "", {-2.0, 0.0});
  const Body free = joined(std::span(scene_.bodies).first(2));
  const Scene now = after(joining(scene_, std::vector<std::string>{"A", "B"}));
  const auto velocity_at = [&](const std::string& name, const Vec2& point) -> Vec2 {
    const auto body =
        std::find_if(now.bodies.begin(), now.bodies.end(), [&](const Body& b) { return b.name == name; });
    if (body == now.bodies.end()) return Vec2::Zero();
    return body->velocity + body->spin * crossed(turned_by(body->angle, point));
  };
  double energy = 0.0;
  for (const Body& body : now.bodies) energy += body.name == "D" ? 0.0 : kinetic_energy(body);
  for (const Joint& rod : now.joints) {
    const Vec2 along = (place(now, rod.body, rod.point) - place(now, rod.to, rod.anchor)).normalized();
    const Vec2 apart = velocity_at(rod.body, rod.point) - velocity_at(rod.to, rod.anchor);
    EXPECT_NEAR(along.dot(apart), 0.0, 1e-5);
  }
  EXPECT_GT(energy, 0.0);
  EXPECT_LT(energy, kinetic_energy(free));
}

TEST_F(JoiningTest, SaysWhyBodiesCantBeOne) {
  EXPECT_EQ(refusal({"A"}), "Two bodies or more become one");
  scene_.bodies[1].density = 5.0;
  EXPECT_EQ(refusal({"A", "B"}), "A and B have different densities; give them one density first");
  EXPECT_EQ(refusal({"C", "A", "B"}), "C and B have different densities; give them one density first");
  scene_.bodies[1].fixed = true;
  EXPECT_EQ(refusal({"A", "B"}), "A and B do not move alike: let both move, or fix both, first");
  scene_.bodies[0].fixed = true;
  EXPECT_EQ(refusal({"A", "B"}), "") << "fixed bodies have no density";
  EXPECT_TRUE(after(joining(scene_, std::vector<std::string>{"A", "B"})).bodies[0].fixed);
  scene_.bodies[1].shape = Wall{};
  EXPECT_EQ(refusal({"A", "B"}), "B is a half-plane, which has no centre of mass");
  scene_.bodies[2].drive = Drive{};
  scene_.bodies[3].drive = Drive{.velocity = Vec2(1.0, 0.0)};
  EXPECT_EQ(refusal({"C", "D"}), "C and D are driven differently");
}

TEST_F(JoiningTest, WhatIsThinOrAPointSharesNoDensity) {
  scene_.bodies[3].mass = 1.0;
  scene_.bodies[3].density.reset();
  scene_.bodies[3].shape = Wall{1.0};
  EXPECT_EQ(refusal({"A", "D"}), "A and D can't share one density: what is thin or a point has no area");
}

// In the scene they stay where they are; a spring between the joined bodies goes.
TEST_F(JoiningTest, SpringsAndForcesHoldOnAtTheSamePlace) {
  Spring held;
  held.body = "A";
  held.to = "C";
  Spring within;
  within.body = "A";
  within.to = "B";
  scene_.forces.springs = {held, within};
  AppliedForce force;
  force.body = "B";
  force.point = Vec2(0.05, 0.02);
  force.force = Vec2(1.0, 2.0);
  scene_.forces.applied = {force};
  give_ids(scene_);
  const auto place = [](const Scene& scene, const std::string& name, const Vec2& point) {
    for (const Body& body : scene.bodies) {
      if (body.name == name) return Vec2(body.position + turned_by(body.angle, point));
    }
    return Vec2(Vec2::Constant(NAN));
  };
  const Scene now = after(joining(scene_, std::vector<std::string>{"A", "B"}));
  ASSERT_EQ(now.forces.springs.size(), 1U);
  const Spring& spring = now.forces.springs[0];
  EXPECT_EQ(spring.body, "A");
  EXPECT_EQ(spring.to, "C");
  EXPECT_TRUE(spring.anchor.isZero(0.0));
  EXPECT_TRUE(place(now, "A", spring.point).isApprox(place(scene_, "A", Vec2::Zero()), 1e-12));
  const AppliedForce& moved = now.forces.applied.at(0);
  EXPECT_EQ(moved.body, "A");
  EXPECT_EQ(moved.force, Vec2(1.0, 2.0));
  EXPECT_TRUE(place(now, "A", moved.point).isApprox(place(scene_, "B", force.point), 1e-12));
}

TEST_F(JoiningTest, TakingApartGivesNewNamesAndTakesJointsAlong) {
  scene_ = after(joining(scene_, std::vector<std::string>{"A", "B", "C"}));
  add_joint(JointKind::kRod, "D", {0.0, 0.0}, "A", {0.1, 0.0});
  scene_.bodies[1].name = "A-2";
  scene_.joints[0].body = "A-2";
  const Regrouping made = taking_apart(scene_, std::vector<std::string>{"A"});
  EXPECT_EQ(made.name, "Take A apart into 3 bodies and delete 1 rod");
  EXPECT_EQ(made.bodies, (std::vector<std::string>{"A-1", "A-3", "A-4"}));
  const Scene now = after(made);
  EXPECT_TRUE(now.joints.empty());
  ASSERT_EQ(now.bodies.size(), 4U);
  EXPECT_EQ(taking_apart(scene_, std::vector<std::string>{"A-2"}).refusal, "A-2 has only one shape");
}

TEST_F(JoiningTest, SeveralAreTakenApartAtOnce) {
  scene_ = after(joining(scene_, std::vector<std::string>{"A", "B"}));
  const Regrouping one = taking_apart(scene_, std::vector<std::string>{"A", "D"});
  EXPECT_EQ(one.name, "Take A apart into 2 bodies");
  EXPECT_EQ(one.bodies, (std::vector<std::string>{"D", "A-1", "A-2"})) << "selected then";
  scene_ = after(joining(scene_, std::vector<std::string>{"C", "D"}));
  const Regrouping made = taking_apart(scene_, std::vector<std::string>{"A", "C"});
  EXPECT_EQ(made.name, "Take A and C apart into 4 bodies");
  EXPECT_EQ(made.bodies, (std::vector<std::string>{"A-1", "A-2", "C-1", "C-2"}));
  scene_ = after(made);
  EXPECT_EQ(scene_.bodies.size(), 4U);
  EXPECT_EQ(taking_apart(scene_, std::vector<std::string>{"A-1", "C-1"}).refusal,
            "Each of the 2 bodies has only one shape");
}

}  // namespace
}  // namespace carom
