#include "physics/contact/pivoted_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace carom {
namespace {

// A box of 1 kg, 2 m wide and 1 m high, on a floor (body 0): contacts at its lower corners, which ask that it
// does not sink in. It comes down at 1 m/s, and slides at `slip` (m/s).
struct BoxOnFloor {
  std::vector<SolverBody> bodies;
  std::vector<ContactRow> rows;

  BoxOnFloor(double slip, double friction) {
    constexpr double kInertia = 5.0 / 12.0;
    bodies.resize(2);
    bodies[1] = {slip, -1.0, 0.0, 1.0, 1.0 / kInertia, slip, -1.0, 0.0};
    for (const double x : {-1.0, 1.0}) {
      ContactRow row;
      row.a = BodyIndex{0};
      row.b = BodyIndex{1};
      row.ny = 1.0;
      row.arm_nb = x;     // (x, -½) × (0, 1)
      row.arm_tb = -0.5;  // (x, -½)·(0, 1)
      row.mass_n = 1.0 / (1.0 + x * x / kInertia);
      row.mass_t = 1.0 / (1.0 + 0.25 / kInertia);
      row.friction = friction;
      rows.push_back(row);
    }
  }
  bool solve(double compliance) {
    PivotedContacts contacts;
    const bool found = contacts.solve(rows, bodies, compliance);
    apply_all(rows, bodies);
    return found;
  }
};

TEST(PivotedContacts, ABoxThatSlidesIsSlowedByFriction) {
  // t = (-1, 0): the box slides against it, so friction acts along it.
  BoxOnFloor box(0.5, 0.25);
  ASSERT_TRUE(box.solve(0.0));
  EXPECT_NEAR(box.bodies[1].vx, 0.25, 1e-14);  // less μ times the impulse of 1 N s
  EXPECT_NEAR(box.bodies[1].vy, 0.0, 1e-14);
  EXPECT_NEAR(box.bodies[1].spin, 0.0, 1e-14);
  EXPECT_NEAR(box.rows[0].normal + box.rows[1].normal, 1.0, 1e-14);
  // Friction at the lower corners turns it forwards: the leading corner carries more.
  EXPECT_NEAR(box.rows[1].normal - box.rows[0].normal, 0.25 * 0.5, 1e-14);
  for (const ContactRow& row : box.rows) EXPECT_NEAR(row.tangential, 0.25 * row.normal, 1e-15);
  EXPECT_LE(residual(box.rows, box.bodies), 1e-14);
}

TEST(PivotedContacts, ARoughBoxSticksAndTheCornersShare) {
  BoxOnFloor rigid(0.25, 5.0);
  ASSERT_TRUE(rigid.solve(0.0));
  EXPECT_LE(residual(rigid.rows, rigid.bodies), 1e-14);
  BoxOnFloor shared(0.25, 5.0);
  ASSERT_TRUE(shared.solve(1e-6));
  EXPECT_LE(residual(shared.rows, shared.bodies), 1e-5);
  EXPECT_NEAR(shared.rows[0].tangential, 0.125, 1e-5);
  EXPECT_NEAR(shared.rows[1].tangential, 0.125, 1e-5);
}

TEST(PivotedContacts, WhatOpensGetsNoImpulse) {
  BoxOnFloor box(0.0, 1.0);
  box.bodies[1].free_vy = 1.0;
  ASSERT_TRUE(box.solve(0.0));
  for (const ContactRow& row : box.rows) {
    EXPECT_EQ(row.normal, 0.0);
    EXPECT_EQ(row.tangential, 0.0);
  }
}

// A disc of 1 kg and 1 m that spins on the floor: rolling resistance stops what its moment can.
TEST(PivotedContacts, RollingResistanceIsLimitedByTheNormalImpulse) {
  for (const double arm : {0.01, 0.5}) {
    std::vector<SolverBody> bodies(2);
    constexpr double kInertia = 0.5;
    bodies[1] = {0.0, -1.0, 0.2, 1.0, 1.0 / kInertia, 0.0, -1.0, 0.2};
    ContactRow row;
    row.a = BodyIndex{0};
    row.b = BodyIndex{1};
    row.ny = 1.0;
    row.arm_tb = -1.0;
    row.mass_n = 1.0;
    row.mass_t = 1.0 / (1.0 + 1.0 / kInertia);
    row.mass_r = kInertia;
    row.rolling = arm;
    std::vector<ContactRow> rows{row};
    PivotedContacts contacts;
    ASSERT_TRUE(contacts.solve(rows, bodies, 0.0));
    EXPECT_NEAR(rows[0].moment, -std::min(arm, 0.2 * kInertia), 1e-15) << arm;
    EXPECT_EQ(rows[0].tangential, 0.0);
  }
}

// Both faces of a wedge that nothing can open: no impulses let the box out.
TEST(PivotedContacts, WhatHasNoAnswerIsLeftAsItWas) {
  BoxOnFloor box(0.0, 0.0);
  ContactRow above = box.rows[0];
  above.ny = -1.0;
  above.arm_nb = 1.0;
  above.arm_tb = -0.5;
  for (ContactRow* row : {&box.rows[0], &above}) row->target = 1.0;
  box.rows.push_back(above);
  box.rows[0].normal = 0.125;
  EXPECT_FALSE(box.solve(0.0));
  EXPECT_EQ(box.rows[0].normal, 0.125);
}

}  // namespace
}  // namespace carom
