#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "physics/math/vectors.h"
#include "physics/run/run_setup.h"
#include "physics/scene/polygon.h"
#include "tests/support/scenes.h"

// A ball that runs off the end of a face, with contacts that last: the contact ends at its moment, within the
// step, and not where other bodies continue the face.
namespace carom {
namespace {

enum class Table { kBox, kTiles, kTwoShapes };

struct OffTheTable {
  double speed = 3.0;     // m/s
  double radius = 0.025;  // m
  double start = -0.503;  // m, from the edge
  double step = 0.005;    // s
  double angle = 0.0;     // rad: of all
  bool mirrored = false;
  Table table = Table::kBox;
  double friction = 0.0;
  double scale = 1.0;  // of lengths; speeds by its root, so that gravity stays
  IntegratorId integrator = IntegratorId::kRk4;

  static constexpr double kHeight = 0.9;  // m

  [[nodiscard]] RunSetup setup() const {
    RunSetup s = test::setup_with({}, 0.0, friction);
    const double side = mirrored ? -1.0 : 1.0;
    const auto put = [&](Body body) {
      body.position = turned_by(angle, scale * Vec2(side * body.position.x(), body.position.y()));
      body.velocity = turned_by(angle, std::sqrt(scale) * Vec2(side * body.velocity.x(), body.velocity.y()));
      body.angle = side * body.angle + angle;
      body.spin *= side / std::sqrt(scale);
      s.scene.bodies.push_back(std::move(body));
    };
    const auto box = [&](double width) { return Box{scale * width, scale * 0.05}; };
    Body top = test::wall("table", {-0.5, kHeight - 0.025}, 1.0, 0.05);
    top.shape = box(1.0);
    if (table == Table::kTwoShapes)
      top.shape =
          Compound{{{box(0.5), {-0.25 * scale, 0.0}, 0.0, ""}, {box(0.5), {0.25 * scale, 0.0}, 0.0, ""}}};
    if (table != Table::kTiles) put(top);
    for (int k = 0; table == Table::kTiles && k < 5; ++k) {
      top.name = fmt::format("tile {}", k);
      top.shape = box(0.2);
      top.position.x() = -0.1 - 0.2 * k;
      put(top);
    }
    Body floor;
    floor.name = "floor";
    floor.shape = Wall{};
    floor.fixed = true;
    put(floor);
    Body ball = test::disc("ball", {start, kHeight + radius}, {speed, 0.0}, scale * radius);
    if (friction > 0.0) ball.spin = -speed / radius;  // it rolls
    put(ball);
    s.scene.forces.gravity = turned_by(angle, Vec2(0.0, -9.81));
    s.method = {integrator, ImpactsId::kLocated, ContactsId::kLasting};
    s.method.step = std::sqrt(scale) * step;
    return s;
  }

  // m: how far from the edge it lands; NaN if it does not.
  [[nodiscard]] double landing() const {
    Simulation run(setup());
    while (run.time() < 6.0 * std::sqrt(scale)) {
      run.step();
      for (const ImpactRecord& r : run.last_impacts())
        return (mirrored ? -1.0 : 1.0) * turned_by(-angle, r.point).x() / scale;
    }
    return std::numeric_limits<double>::quiet_NaN();
  }
  // It leaves at once if v² > g r.
  [[nodiscard]] double expected() const { return speed * std::sqrt(2.0 * kHeight / 9.81); }
};

TEST(FaceEnds, ABallLeavesATableAtItsEdge) {
  for (const IntegratorId integrator :
       {IntegratorId::kVelocityVerlet, IntegratorId::kRk4, IntegratorId::kDormandPrince,
        IntegratorId::kAdaptiveDormandPrince, IntegratorId::kExactFlight}) {
    for (const double speed : {0.51, 1.0, 3.0, 7.3}) {
      for (const double step : {1.0 / 60.0, 0.01, 0.005, 0.0007}) {
        for (const Table table : {Table::kBox, Table::kTiles, Table::kTwoShapes}) {
          OffTheTable scene;
          scene.integrator = integrator;
          scene.speed = speed;
          scene.step = step;
          scene.table = table;
          EXPECT_NEAR(scene.landing(), scene.expected(), 1e-12)
              << static_cast<int>(integrator) << ' ' << speed << ' ' << step << ' ' << static_cast<int>(table);
        }
      }
    }
  }
}

TEST(FaceEnds, MirroredTurnedShiftedRollingAndInOtherSizes) {
  for (const bool mirrored : {false, true}) {
    for (const double angle : {0.0, 0.3, -2.0}) {
      for (const double start : {-0.503, -0.9, -0.2001}) {
        for (const double friction : {0.0, 0.5}) {
          for (const double scale : {1e-2, 1.0, 1e3}) {
            OffTheTable scene;
            scene.mirrored = mirrored;
            scene.angle = angle;
            scene.start = start;
            scene.friction = friction;
            scene.scale = scale;
            EXPECT_NEAR(scene.landing(), scene.expected(), 1e-11)
                << mirrored << ' ' << angle << ' ' << start << ' ' << friction << ' ' << scale;
          }
        }
      }
    }
  }
}

// Just fast enough to leave at once, at every share of a step that may be left.
TEST(FaceEnds, ABallLeavesAtEveryMomentOfAStep) {
  for (const double step : {1.0 / 60.0, 0.01, 0.005}) {
    for (const double faster : {1.05, 1.2, 1.5}) {
      for (const double part : {0.0, 1e-12, 1e-6, 1e-3, 0.03, 0.2, 0.5, 0.8, 0.99, 1.0 - 1e-9}) {
        OffTheTable scene;
        scene.step = step;
        scene.speed = faster * std::sqrt(9.81 * scene.radius);
        scene.start = -(10.0 + part) * scene.speed * step;
        EXPECT_NEAR(scene.landing(), scene.expected(), 1e-11) << step << ' ' << faster << ' ' << part;
      }
    }
  }
}

// A smooth box slides over the edge at 1 m/s, tips about it once its middle is there, and slides off. Its
// motion until its rear corner is at the edge follows from Lagrange's equations for the edge's place s along
// the box, from its middle, and the angle: s'' + b θ'' = s θ'² + g sin θ, (s² + k²) θ'' = g s cos θ - b s θ'² -
// 2 s s' θ', with half the height b and the radius of gyration k; solved in steps of 0.1 ms with 25 digits, to
// 1e-13.
TEST(FaceEnds, ABoxTipsOffTheEdge) {
  constexpr double kAfter = 0.4;  // s, after it begins to tip
  const Eigen::Vector3d place(0.412129677925236644, -0.366838030520615826, -1.0319488060053586);
  const Eigen::Vector3d speed(1.04523299406648236, -2.9785349739282558, -3.42210072337597525);
  for (const auto& [h, within] :
       {std::pair(1.0 / 60.0, 3e-6), std::pair(0.01, 4e-7), std::pair(0.005, 3e-8), std::pair(0.002, 8e-10)}) {
    for (int k = 0; k < 12; ++k) {
      const double start = -0.5 + k * h / 12.0;
      RunSetup s = test::setup_with(
          {test::wall("table", {-1.0, -0.25}, 2.0, 0.5), test::box("box", {start, 0.1}, {1.0, 0.0}, 0.4, 0.2)},
          0.0);
      s.scene.forces.gravity = {0.0, -9.81};
      s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, h};
      Simulation run(s);
      run.advance_to(kAfter - start, [] {});
      EXPECT_LT((run.state().q.col(1) - place).lpNorm<Eigen::Infinity>(), within) << h << " " << k;
      EXPECT_LT((run.state().v.col(1) - speed).lpNorm<Eigen::Infinity>(), within) << h << " " << k;
    }
  }
}

// Slower than √(g r) it goes round the corner before it leaves: the way round is of order 2.
TEST(FaceEnds, ASlowBallGoesRoundTheEdge) {
  OffTheTable scene;
  scene.speed = 0.3;
  scene.radius = 0.05;
  scene.start = -0.1;
  // On the corner v² = v0² + 2 g r (1 - cos θ) until cos θ = v²/(g r); from there it falls.
  const double gr = 9.81 * scene.radius;
  const double cosine = (scene.speed * scene.speed + 2.0 * gr) / (3.0 * gr);
  const double sine = std::sqrt(1.0 - cosine * cosine);
  const double v = std::sqrt(gr * cosine);
  const Vec2 from = scene.radius * Vec2(sine, cosine);
  const double drop = OffTheTable::kHeight + from.y() - scene.radius;
  const double down = v * sine;
  const double time = (-down + std::sqrt(down * down + 2.0 * 9.81 * drop)) / 9.81;
  const double wanted = from.x() + v * cosine * time;
  // Where in a step it leaves changes the error from one step to another: the worst of some counts.
  double before = 0.0;
  for (const double step : {0.008, 0.004, 0.002, 0.001}) {
    double worst = 0.0;
    for (int k = 0; k < 12; ++k) {
      scene.step = step * (1.0 - 0.02 * k);
      worst = std::max(worst, std::abs(scene.landing() - wanted));
    }
    if (before > 0.0) {
      EXPECT_LT(worst, before / 3.3) << step;
    }
    before = worst;
  }
  EXPECT_LT(before, 6e-6);
}

// Over a gap it turns about one edge and lands on the other, so that it has v cos 2θ then, with sin θ = gap/2r.
// The edge ahead is near before it is touched, and must not slow the ball down.
TEST(FaceEnds, ASlowBallPassesANarrowGap) {
  constexpr double kSpeed = 0.6;  // m/s
  for (const double radius : {0.1, 0.05}) {
    for (const double gap : {0.0002, 0.001, 0.002}) {
      for (const double step : {1.0 / 60.0, 0.01, 0.005, 0.001}) {
        for (const double start : {-0.3, -0.2991, -0.2982, -0.2973, -0.2964}) {
          const Body left = test::wall("left", {-1.0 - 0.5 * gap, -0.1}, 2.0, 0.2);
          const Body right = test::wall("right", {1.0 + 0.5 * gap, -0.1}, 2.0, 0.2);
          RunSetup s = test::setup_with(
              {left, right, test::disc("ball", {start, radius}, {kSpeed, 0.0}, radius)}, 0.0, 0.0);
          s.scene.forces.gravity = {0.0, -9.81};
          s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
          Simulation run(s);
          while (run.time() < 1.0) run.step();
          const double limit = 1e-4 + 6.0 * gap * gap / (radius * radius);
          EXPECT_NEAR(run.state().velocity(2).x() / kSpeed, std::cos(2.0 * std::asin(0.5 * gap / radius)),
                      limit)
              << radius << " " << gap << " " << step << " " << start;
        }
      }
    }
  }
}

enum class Ridge { kPolygon, kTwoBoxes, kTwoShapes };

// From a level floor onto a slope, slow enough to stay in touch: it goes round the edge between them.
struct OverARidge {
  Ridge ridge = Ridge::kPolygon;
  double slope = 0.3;  // rad
  double friction = 0.0;
  double step = 0.005;  // s
  double angle = 0.0;   // rad: of all
  bool mirrored = false;
  IntegratorId integrator = IntegratorId::kRk4;

  static constexpr double kSpeed = 0.4;   // m/s
  static constexpr double kRadius = 0.1;  // m
  static constexpr double kStart = 0.21;  // m, before the edge
  static constexpr double kEnd = 1.2;     // s

  [[nodiscard]] Vec2 placed(const Vec2& at) const {
    return turned_by(angle, Vec2(mirrored ? -at.x() : at.x(), at.y()));
  }
  [[nodiscard]] RunSetup setup() const {
    RunSetup s = test::setup_with({}, 0.5, friction);
    const double side = mirrored ? -1.0 : 1.0;
    const Box slab{2.0, 1.0};
    const Vec2 over(1.0, -0.5);  // m: from its upper left corner to its centre
    const Body level = test::fixed("level", slab, placed({-1.0, -0.5}));
    const Body down = test::fixed("slope", slab, placed(turned_by(-slope, over)));
    const auto put = [&](Body body, double turn) {
      body.angle = angle + side * turn;
      s.scene.bodies.push_back(std::move(body));
    };
    if (ridge == Ridge::kTwoBoxes) {
      put(level, 0.0);
      put(down, -slope);
    } else if (ridge == Ridge::kTwoShapes) {
      // About their common centre of mass, which is in the middle of both.
      const Vec2 middle = 0.5 * (level.position + down.position);
      const Compound both{{{slab, level.position - middle, angle, ""},
                           {slab, down.position - middle, angle - side * slope, ""}}};
      s.scene.bodies.push_back(test::fixed("both", both, middle));
    } else {
      const Vec2 end = 2.0 * Vec2(std::cos(slope), -std::sin(slope));
      std::vector<Vec2> corners = {{-2.0, 0.0}, {-2.0, -3.0}, {end.x(), -3.0}, end, {0.0, 0.0}};
      for (Vec2& corner : corners) corner = placed(corner);
      if (mirrored) std::reverse(corners.begin(), corners.end());
      const Vec2 centre = moments_of(corners, 0.0).centroid;
      for (Vec2& corner : corners) corner -= centre;
      s.scene.bodies.push_back(test::fixed("hill", Polygon{corners}, centre));
    }
    Body ball = test::disc("ball", placed({-kStart, kRadius}), placed({kSpeed, 0.0}), kRadius);
    if (friction > 0.0) ball.spin = -side * kSpeed / kRadius;
    s.scene.bodies.push_back(ball);
    s.scene.forces.gravity = turned_by(angle, Vec2(0.0, -9.81));
    s.method = {integrator, ImpactsId::kLocated, ContactsId::kLasting};
    s.method.step = step;
    return s;
  }
  // m: how far down the slope it is at the end. It rolls, or slides without turning: with the same share of its
  // energy in its path.
  [[nodiscard]] double expected() const {
    const double g = 9.81 / (friction > 0.0 ? 1.5 : 1.0);
    const auto speed = [&](double theta) {
      return std::sqrt(kSpeed * kSpeed + 2.0 * g * kRadius * (1.0 - std::cos(theta)));
    };
    constexpr int kParts = 2000;  // Simpson's rule for the time round the edge
    double time = 0.0;
    for (int k = 0; k <= kParts; ++k) {
      const double weight = k == 0 || k == kParts ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
      time += weight * slope / (3.0 * kParts) * kRadius / speed(slope * k / kParts);
    }
    const double left = kEnd - kStart / kSpeed - time;
    return speed(slope) * left + 0.5 * g * std::sin(slope) * left * left;
  }
  // m: how far from there it is, and from the surface.
  [[nodiscard]] double error() const {
    Simulation run(setup());
    run.advance_to(kEnd, [&] { EXPECT_TRUE(run.last_impacts().empty()) << run.time(); });
    const Vec2 wanted = turned_by(-slope, Vec2(expected(), kRadius));
    return (Vec2(run.state().position(run.state().size() - 1)) - placed(wanted)).norm();
  }
};

TEST(FaceEnds, ABallRollsRoundTheEdgeToAnotherFace) {
  OverARidge scene;
  for (const Ridge ridge : {Ridge::kPolygon, Ridge::kTwoBoxes, Ridge::kTwoShapes}) {
    for (const double slope : {0.06, 0.15, 0.3, 0.45}) {
      for (const double friction : {0.0, 1.0}) {
        for (const double step : {1.0 / 60.0, 0.01, 0.005, 0.002}) {
          scene.ridge = ridge;
          scene.slope = slope;
          scene.friction = friction;
          scene.step = step;
          EXPECT_LT(scene.error(), std::max(1e-9, 0.5 * std::pow(step, 4)))
              << static_cast<int>(ridge) << " " << slope << " " << friction << " " << step;
        }
      }
    }
  }
}

TEST(FaceEnds, TheEdgeBetweenTwoFacesTurnedAndMirroredUnderEachMethod) {
  for (const IntegratorId integrator :
       {IntegratorId::kVelocityVerlet, IntegratorId::kRk4, IntegratorId::kDormandPrince,
        IntegratorId::kAdaptiveDormandPrince, IntegratorId::kExactFlight}) {
    for (const Ridge ridge : {Ridge::kPolygon, Ridge::kTwoBoxes, Ridge::kTwoShapes}) {
      OverARidge scene;
      scene.ridge = ridge;
      scene.friction = 1.0;
      scene.integrator = integrator;
      for (const double angle : {0.0, 0.7, 2.5}) {
        for (const bool mirrored : {false, true}) {
          scene.angle = angle;
          scene.mirrored = mirrored;
          EXPECT_LT(scene.error(), 1e-9)
              << static_cast<int>(integrator) << " " << static_cast<int>(ridge) << " " << angle << mirrored;
        }
      }
    }
  }
}

}  // namespace
}  // namespace carom
