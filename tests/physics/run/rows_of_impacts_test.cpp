#include <cstddef>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "physics/math/vectors.h"
#include "physics/run/run_setup.h"
#include "tests/support/scenes.h"

// Rows of bodies that touch: each impact sets off the next, and rounding does not decide which comes first.
namespace carom {
namespace {

using test::disc;

// Velocities of a row of equal bodies that touch where they don't close, by rounds: the pairs that close have
// their impacts, and then those that these set off. No two of a round share a body.
std::vector<double> after_rounds(std::vector<double> v, double restitution) {
  std::vector<std::size_t> close;
  do {
    close.clear();
    for (std::size_t i = 0; i + 1 < v.size(); ++i) {
      if (v[i] - v[i + 1] > 1e-14) close.push_back(i);
    }
    for (const std::size_t i : close) {
      const double mean = 0.5 * (v[i] + v[i + 1]);
      const double half = 0.5 * restitution * (v[i] - v[i + 1]);
      v[i] = mean - half;
      v[i + 1] = mean + half;
    }
  } while (!close.empty());
  return v;
}

// The gaps of the balls are rounding, which grows with their distance from the origin: it does not decide which
// impact comes first, not even where the moment is the end of a step, and the trajectories end with it.
TEST(RowsOfImpacts, ARowGoesOnInRoundsAtEveryPlaceAndTime) {
  for (const ContactsId contacts : {ContactsId::kImpulse, ContactsId::kLasting}) {
    for (const double gap : {0.3, 0.3137}) {
      for (const Vec2& shift : {Vec2{0.0, 0.0}, Vec2{100.0, 0.0}, Vec2{33.3, -7.1}, Vec2{1e4, 0.0}}) {
        if (gap == 0.3 && contacts == ContactsId::kLasting && !shift.isZero()) continue;
        for (const double angle : {0.0, 0.3, 1.1}) {
          for (const double restitution : {0.5, 0.9}) {
            for (const int balls : {3, 4, 5, 6}) {
              RunSetup s = test::setup_with({}, restitution);
              for (int i = 0; i < balls; ++i) {
                const Vec2 place = {i == 0 ? -gap - 0.2 : 0.2 * (i - 1), 0.0};
                const Vec2 velocity = {i == 0 ? 1.0 : 0.0, 0.0};
                s.scene.bodies.push_back(disc(fmt::format("{}", i), Vec2(shift + turned_by(angle, place)),
                                              turned_by(angle, velocity)));
              }
              s.method.contacts = contacts;
              s.method.step = 0.01;
              Simulation run(s);
              run.advance_to(1.0);
              std::vector<double> v(static_cast<std::size_t>(balls), 0.0);
              v.front() = 1.0;
              v = after_rounds(v, restitution);
              for (int i = 0; i < balls; ++i) {
                EXPECT_NEAR(turned_by(-angle, run.state().velocity(i)).x(), v[static_cast<std::size_t>(i)],
                            1e-12)
                    << "ball " << i << " of " << balls << ", e = " << restitution << ", " << shift.x() << " m, "
                    << angle << " rad, " << gap << " m, contacts " << static_cast<int>(contacts);
              }
            }
          }
        }
      }
    }
  }
}

// Boxes that touch slide over tiles into others that touch. At each seam the floor's forces go over from tile
// to tile; neither this nor the rounding of many steps turns or parts the boxes.
TEST(RowsOfImpacts, BoxesOnTilesGoOnInRounds) {
  constexpr double kSize = 0.2;  // m
  constexpr double kGap = 0.2;   // m
  for (const double tile : {0.11, 0.3, 0.37}) {
    for (const double angle : {0.0, -0.7}) {
      for (const double step : {1.0 / 60.0, 0.01, 0.005}) {
        for (const auto& [sliding, at_rest] : {std::pair(1, 2), std::pair(2, 3), std::pair(3, 3)}) {
          for (const double restitution : {0.5, 0.9}) {
            RunSetup s = test::setup_with({}, restitution);
            std::vector<Body>& bodies = s.scene.bodies;
            std::vector<double> v;
            for (int i = 0; i < sliding + at_rest; ++i) {
              v.push_back(i < sliding ? 1.0 : 0.0);
              const double place = kSize * (i - sliding) - (i < sliding ? kGap : 0.0) - 0.3;
              bodies.push_back(
                  test::box(fmt::format("{}", i), {place, 0.5 * kSize}, {v.back(), 0.0}, kSize, kSize));
            }
            const std::size_t boxes = bodies.size();
            for (double place = -2.0; place < 1.2; place += tile)
              bodies.push_back(test::wall(fmt::format("{}", place), {place, -0.05}, tile, 0.1));
            for (Body& body : bodies) {
              body.position = turned_by(angle, body.position);
              body.velocity = turned_by(angle, body.velocity);
              body.angle = angle;
            }
            s.scene.forces.gravity = turned_by(angle, {0.0, -9.81});
            s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
            Simulation run(s);
            run.advance_to(kGap + 0.02);
            v = after_rounds(v, restitution);
            for (std::size_t i = 0; i < boxes; ++i) {
              const int body = static_cast<int>(i);
              EXPECT_NEAR((turned_by(-angle, run.state().velocity(body)) - Vec2(v[i], 0.0)).norm(), 0.0, 1e-9)
                  << "box " << i << ", " << sliding << " on " << at_rest << ", e = " << restitution
                  << ", tiles of " << tile << " m, " << angle << " rad, h = " << step;
              EXPECT_NEAR(run.state().v(2, body), 0.0, 1e-9);
            }
            EXPECT_EQ(run.status(), "ok");
          }
        }
      }
    }
  }
}

// Balls of clay in a row: all go on together after one impact at each contact, though pair by pair there is no
// last one.
TEST(RowsOfImpacts, ARowOfClayStopsWithOneImpactAtEachContact) {
  for (const ContactsId contacts : {ContactsId::kImpulse, ContactsId::kLasting}) {
    for (const int balls : {3, 4, 7}) {
      RunSetup s = test::setup_with({}, 0.0);
      double mass = 0.0;
      for (int i = 0; i < balls; ++i) {
        s.scene.bodies.push_back(disc(fmt::format("{}", i), {i == 0 ? -0.5 : 0.2 * (i - 1), 0.0},
                                      {i == 0 ? 1.0 : 0.0, 0.0}, 0.1, 1.0 + i));
        mass += 1.0 + i;
      }
      s.method.contacts = contacts;
      Simulation run(s);
      run.advance_to(1.0);
      for (int i = 0; i < balls; ++i) EXPECT_NEAR(run.state().v(0, i), 1.0 / mass, 1e-14) << balls;
      EXPECT_EQ(run.impact_count(), balls - 1);
      EXPECT_EQ(run.status(), "ok");
      EXPECT_NEAR(run.ledger().lost_to_restitution, 0.5 - 0.5 / mass, 1e-14);
    }
  }
}

}  // namespace
}  // namespace carom
