#include <gtest/gtest.h>
#include <numbers>
#include <string>

#include "physics/math/vectors.h"
#include "physics/run/run_setup.h"
#include "tests/support/scenes.h"

// What has no inside, particles and thin rods, on a thin wall. It moves as over a half-plane, which has one,
// raised by the distance at which the thin ones touch.
namespace carom {
namespace {

constexpr double kHeight = 0.3;  // m, from which they fall

struct Fall {
  Shape shape;
  double tilt = 0.0;  // rad
  double restitution = 0.0;
  double friction = 0.0;
  IntegratorId integrator = IntegratorId::kRk4;
  double step = 1.0 / 60.0;  // s
  double size = 1.0;         // times which all lengths are
  double turn = 0.0;         // rad, of the whole scene
};

// Place and angle of the body at the time in s, in lengths of `size` and the directions of the floor, which
// lies so many of them over the origin.
Eigen::Vector3d place_after(const Fall& fall, const Shape& floor, double height, double time) {
  RunSetup s = test::setup_with({}, fall.restitution, fall.friction);
  const Vec2 along = direction_at(fall.turn);
  const Vec2 up = crossed(along);
  Body ground = test::fixed("floor", floor, fall.size * height * up);
  ground.angle = fall.turn;
  Body body = test::disc("body", fall.size * kHeight * up, 0.3 * fall.size * along, 0.1, 1.0);
  body.shape = fall.shape;
  body.angle = fall.turn + fall.tilt;
  s.scene.bodies = {ground, body};
  s.scene.forces.gravity = -9.81 * fall.size * up;
  s.method = {fall.integrator, ImpactsId::kLocated, ContactsId::kLasting, fall.step};
  Simulation run(s);
  run.advance_to(time);
  EXPECT_EQ(run.status(), "ok");
  const Vec2 at = run.state().position(1) / fall.size;
  return {at.dot(along), at.dot(up), run.state().q(2, 1) - fall.turn};
}

// How far they are from each other over a thin wall, which reaches up by `reach` lengths, and a half-plane.
double difference(const Fall& fall, double reach, double time) {
  return (place_after(fall, Wall{4.0 * fall.size}, 0.0, time) - place_after(fall, Wall{}, reach, time))
      .cwiseAbs()
      .maxCoeff();
}

TEST(ThinWalls, AParticleBouncesOrStaysOnThem) {
  for (const IntegratorId integrator :
       {IntegratorId::kRk4, IntegratorId::kVelocityVerlet, IntegratorId::kDormandPrince}) {
    for (const double restitution : {0.0, 0.5, 1.0}) {
      for (const double friction : {0.0, 0.4}) {
        for (const double size : {1e-3, 1.0, 1e3}) {
          for (const double turn : {0.0, 0.7, 2.5}) {
            Fall fall{Disc{0.0}, 0.0, restitution, friction, integrator};
            fall.size = size;
            fall.turn = turn;
            EXPECT_LT(difference(fall, 2e-9, 1.5), 1e-9)
                << "e = " << restitution << ", mu = " << friction << ", " << size << " m, " << turn << " rad";
          }
        }
      }
    }
  }
}

TEST(ThinWalls, AThinRodFallsOntoThem) {
  for (const double tilt : {0.0, 0.3, 0.5 * std::numbers::pi}) {
    for (const double restitution : {0.0, 0.5}) {
      for (const double friction : {0.0, 0.4}) {
        for (const double step : {1.0 / 60.0, 1.0 / 240.0}) {
          for (const double turn : {0.0, 0.7}) {
            Fall fall{Wall{0.5}, tilt, restitution, friction};
            fall.step = step;
            fall.turn = turn;
            // Friction acts half-way between them.
            EXPECT_LT(difference(fall, 2e-5, 0.8), friction > 0.0 ? 1e-4 : 1e-7)
                << tilt << " rad, e = " << restitution << ", mu = " << friction << ", h = " << step
                << ", turned by " << turn;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace carom
