#include <atomic>
#include <cstddef>
#include <gtest/gtest.h>

#include "physics/contact/pivoted_contacts.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/impact/simultaneous_impact.h"
#include "physics/run/run_setup.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/scenes.h"

// Every allocation of this program is counted: operator new and Eigen both end in malloc. The sanitizers have
// their own malloc; the test is skipped there.
#if defined(__GLIBC__) && !defined(CAROM_SANITIZED)
#define CAROM_COUNTS_ALLOCATIONS
#endif

namespace {
std::atomic<long> allocations{0};
}  // namespace

#ifdef CAROM_COUNTS_ALLOCATIONS
extern "C" {
void* __libc_malloc(std::size_t size);
void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
}
#endif

namespace carom {
namespace {

TEST(Allocation, NoneInAWarmStep) {
#ifndef CAROM_COUNTS_ALLOCATIONS
  GTEST_SKIP() << "needs glibc's malloc, without sanitizers";
#endif
  const long at_first = allocations;
  { const Eigen::VectorXd one = Eigen::VectorXd::Zero(100); }
  ASSERT_GT(allocations, at_first);
  for (const IntegratorChoice& integrator : kIntegrators) {
    for (const auto& impacts : kImpacts) {
      std::vector<Body> bodies = test::room(1.0, 0.5);
      for (int i = 0; i < 16; ++i) {
        std::string name(1, static_cast<char>('a' + i));
        bodies.push_back(test::disc(name, {-0.75 + 0.5 * (i % 4), -0.75 + 0.5 * (i / 4)},
                                    {1.0 - 0.1 * i, 0.1 * i * i - 8.0}));
      }
      RunSetup s = test::setup_with(std::move(bodies), 1.0, 0.1);
      if (integrator.order > 0) {
        s.scene.forces.quadratic_drag = 1e-6;
        Joint joint;
        joint.kind = JointKind::kString;
        joint.body = "a";
        joint.to = "b";
        joint.length = 0.8;
        s.scene.joints.push_back(joint);
        joint = {};
        joint.body = "c";
        joint.to = "d";
        s.scene.joints.push_back(joint);
        s.scene.bodies[6].velocity = s.scene.bodies[7].velocity;
      }
      s.method = {integrator.id, impacts.id, ContactsId::kImpulse, 0.01};
      Simulation run(s);
      for (int i = 0; i < 6000; ++i) run.step();  // until buffers have met their most crowded step
      const long before = allocations;
      const std::int64_t impacts_before = run.impact_count();
      for (int i = 0; i < 1000; ++i) run.step();
      EXPECT_EQ(allocations - before, 0) << integrator.name << ", " << impacts.name;
      EXPECT_GT(run.impact_count() - impacts_before, 20);
    }
  }
}

// Ten boxes in a row, each touching the next at two corners, with friction.
TEST(Allocation, NoneInAWarmSimultaneousImpact) {
#ifndef CAROM_COUNTS_ALLOCATIONS
  GTEST_SKIP() << "needs glibc's malloc, without sanitizers";
#endif
  Eigen::Matrix3Xd velocities = Eigen::Matrix3Xd::Zero(3, 10);
  const Eigen::VectorXd inverse_mass = Eigen::VectorXd::Constant(10, 1.0);
  const Eigen::VectorXd inverse_inertia = Eigen::VectorXd::Constant(10, 6.0);
  std::vector<ClusterContact> contacts;
  for (int i = 0; i + 1 < 10; ++i) {
    for (const double y : {-0.5, 0.5})
      contacts.push_back({i, i + 1, {1.0, 0.0}, {0.5, y}, {-0.5, y}, 0.5, 0.3});
  }
  std::vector<Impact> impacts(contacts.size());
  Eigen::Matrix3Xd answers;
  free_answers(inverse_mass, inverse_inertia, contacts, answers);
  ClusterScratch scratch;
  long before = 0;
  for (int call = 0; call < 3; ++call) {
    velocities.setZero();
    velocities.col(0) = Eigen::Vector3d(2.0, 0.3, 0.1 * call);
    const ClusterOutcome outcome =
        resolve_simultaneous(velocities, answers, contacts, ClusterRestitution::kOwn, impacts, scratch);
    EXPECT_TRUE(outcome.solved);
    if (call == 0) before = allocations;
  }
  EXPECT_EQ(allocations - before, 0);
}

// As many contacts as before, and fewer.
TEST(Allocation, NoneInAWarmPivot) {
#ifndef CAROM_COUNTS_ALLOCATIONS
  GTEST_SKIP() << "needs glibc's malloc, without sanitizers";
#endif
  std::vector<SolverBody> bodies(2);
  bodies[1].inverse_mass = bodies[1].inverse_inertia = 1.0;
  bodies[1].free_vy = -1.0;
  std::vector<ContactRow> rows(4);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ContactRow& row = rows[i];
    row.a = BodyIndex{0};
    row.b = BodyIndex{1};
    row.ny = 1.0;
    row.arm_nb = static_cast<double>(i) - 1.5;
    row.arm_tb = -0.5;
    row.mass_n = 1.0 / (1.0 + row.arm_nb * row.arm_nb);
    row.mass_t = 0.8;
    row.friction = 0.5;
  }
  PivotedContacts contacts;
  ASSERT_TRUE(contacts.solve(rows, bodies, 1e-6));
  const long before = allocations;
  EXPECT_TRUE(contacts.solve(rows, bodies, 1e-6));
  EXPECT_TRUE(contacts.solve(std::span(rows).first(2), bodies, 1e-6));
  EXPECT_EQ(allocations, before);
}

TEST(Allocation, NoneInAWarmContactSolve) {
#ifndef CAROM_COUNTS_ALLOCATIONS
  GTEST_SKIP() << "needs glibc's malloc, without sanitizers";
#endif
  const test::ContactScene start = test::pyramid(8, 0.6);
  test::ContactScene s = start;
  ContactWorkspace workspace;
  Eigen::Matrix3Xd dq;
  long before = 0;
  for (int turn = 0; turn < 2; ++turn) {
    before = allocations;
    s.contacts = start.contacts;
    s.v = start.v;
    s.accelerate({0.0, -9.81}, 0.01);
    const ContactSolverReport report = solve_contacts(s.mass, s.contacts, s.v, {.tolerance = 1e-13}, workspace);
    EXPECT_GT(report.newton_iterations, 0);
    project_penetrations(s.mass, s.contacts, 0.5, dq, {}, workspace);
    if (turn == 0) {
      EXPECT_GT(allocations, before);
    }
  }
  EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace carom
