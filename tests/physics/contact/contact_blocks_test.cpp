#include <gtest/gtest.h>
#include <map>
#include <set>
#include <tuple>

#include "physics/contact/contact_solver.h"
#include "tests/support/contact_scenes.h"

// Large islands solved in blocks of SIMD lanes, against one contact after another.
namespace carom {
namespace {

constexpr ContactSolverOptions kInBlocks{.most_exact = 0, .large_sweeps = 4000, .large_tolerance = 1e-11};

// Random contacts between any bodies, many on the same few, with initial impulses. Some bodies are static,
// kinematic or only turn; `law` chooses the resistance.
test::ContactScene network(std::uint64_t seed, BlockLaw law) {
  test::Uniform draw(seed);
  test::ContactScene s;
  const int bodies = 3 + static_cast<int>(draw(0.0, 60.0));
  for (int i = 0; i < bodies; ++i) {
    const Eigen::Vector3d v(draw(-1.0, 1.0), draw(-1.0, 1.0), draw(-1.0, 1.0));
    const double kind = draw(0.0, 1.0);
    const double m = std::exp(draw(-2.0, 2.0));
    s.body({draw(-3.0, 3.0), draw(-3.0, 3.0)}, kind < 0.2 ? 0.0 : m, kind < 0.15 ? 0.0 : m * draw(0.02, 0.2),
           v);
  }
  const int contacts = 1 + static_cast<int>(draw(0.0, 250.0));
  for (int k = 0; k < contacts; ++k) {
    const int a = static_cast<int>(draw(0.0, 0.999) * draw(0.0, 1.0) * bodies);
    const int b = static_cast<int>(draw(0.0, 0.999) * bodies);
    if (a == b) continue;
    const double angle = draw(0.0, 7.0);
    const int c =
        s.contact(std::min(a, b), std::max(a, b), {draw(-3.0, 3.0), draw(-3.0, 3.0)},
                  {std::cos(angle), std::sin(angle)}, law == BlockLaw::kNormal ? 0.0 : draw(0.0, 1.0));
    Contacts& all = s.contacts;
    all.sticks[c] = draw(0.0, 1.0) < 0.5 ? 1 : 0;
    all.kinetic_friction[c] *= 0.5;
    all.rolling[c] = law == BlockLaw::kRolling ? std::max(0.0, draw(-0.1, 0.1)) : 0.0;
    all.target[c] = std::min(0.0, draw(-0.5, 0.5));
    all.gap[c] = draw(-0.1, 0.1);
    all.normal_impulse[c] = std::max(0.0, draw(-1.0, 1.0));
    all.tangential_impulse[c] = draw(-1.0, 1.0);
    all.rolling_impulse[c] = draw(-0.1, 0.1);
  }
  return s;
}

// Block and SIMD lane of each contact, in the order of the islands.
std::vector<std::pair<std::size_t, std::size_t>> lanes_of(const ContactWorkspace& w) {
  std::map<int, std::pair<std::size_t, std::size_t>> lane_of;
  for (std::size_t k = 0; k < w.large_islands.blocks.size(); ++k) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) lane_of[w.large_islands.contacts[k][lane]] = {k, lane};
  }
  std::vector<std::pair<std::size_t, std::size_t>> lanes;
  for (const int c : w.islands.contacts) lanes.push_back(lane_of.at(c));
  return lanes;
}

TEST(ContactBlocks, HoldEachContactOnceAndAMovableBodyOnceABlock) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const test::ContactScene s = network(seed, BlockLaw::kRolling);
    ContactWorkspace w;
    prepare_contacts(s.mass, s.contacts, {.most = 0}, w);
    std::multiset<int> held;
    ASSERT_EQ(w.large_islands.blocks.size(), w.large_islands.contacts.size());
    for (const Lanes<int>& lanes : w.large_islands.contacts) {
      std::set<int> bodies;
      for (const int c : lanes) {
        if (c < 0) continue;
        held.insert(c);
        for (const int i : {s.contacts.a[c], s.contacts.b[c]}) {
          const bool movable = s.mass.inverse_mass[i] > 0.0 || s.mass.inverse_inertia[i] > 0.0;
          EXPECT_TRUE(!movable || bodies.insert(i).second) << "seed " << seed << " contact " << c;
        }
      }
    }
    EXPECT_EQ(held, std::multiset<int>(w.islands.contacts.begin(), w.islands.contacts.end()))
        << "seed " << seed;
  }
}

TEST(ContactBlocks, AreFilledWellInALattice) {
  constexpr int kSide = 40;
  test::ContactScene s;
  for (int i = 0; i < kSide * kSide; ++i) s.disc(Vec2(i % kSide, i / kSide), 0.5, 1.0);
  for (int i = 0; i < kSide * kSide; ++i) {
    if (i % kSide + 1 < kSide) s.contact(i, i + 1, s.position[i] + Vec2(0.5, 0.0), {1.0, 0.0}, 0.5);
    if (i + kSide < kSide * kSide) s.contact(i, i + kSide, s.position[i] + Vec2(0.0, 0.5), {0.0, 1.0}, 0.5);
  }
  ContactWorkspace w;
  prepare_contacts(s.mass, s.contacts, {.most = 0}, w);
  EXPECT_LE(kLanes * w.large_islands.blocks.size(), 2U * static_cast<std::size_t>(s.contacts.size()));
}

// Each instruction set against rows solved one after another.
TEST(ContactBlocks, GiveTheBytesOfOneContactAfterAnother) {
  int sets = 0;
  for (const BlockKernels& kernels : all_block_kernels()) {
    if (!kernels.runs_here()) continue;
    ++sets;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      const auto law = static_cast<BlockLaw>(seed % 3);
      const test::ContactScene s = network(seed, law);
      ContactWorkspace w;
      test::ContactScene prepared = s;
      // Without a sweep the blocks are loaded, with the free velocities and the effect of the first impulses.
      solve_contacts(prepared.mass, prepared.contacts, prepared.v, {.most_exact = 0, .large_sweeps = 0}, w);
      for (std::size_t i = 0; i < w.large_islands.velocity.size() - 1; ++i) {
        const auto v = s.v.col(static_cast<Eigen::Index>(i));
        w.large_islands.velocity[i] = {v[0], v[1], v[2]};
      }
      const auto lanes = lanes_of(w);
      std::vector<ContactRow> rows;
      for (const auto& [k, lane] : lanes) rows.push_back(row_of(w.large_islands.blocks[k], lane));
      std::vector<SolverBody> bodies;
      for (Eigen::Index i = 0; i < s.v.cols(); ++i) {
        const Eigen::Vector3d v = s.v.col(i);
        bodies.push_back(
            {v[0], v[1], v[2], s.mass.inverse_mass[i], s.mass.inverse_inertia[i], v[0], v[1], v[2]});
      }

      apply_all(rows, bodies);
      kernels.apply(w.large_islands.blocks, &w.large_islands.velocity.data()->x);
      EXPECT_EQ(residual(rows, bodies),
                kernels.residual(w.large_islands.blocks, &w.large_islands.velocity.data()->x));
      for (const bool backwards : {false, true, false, true, true}) {
        sweep(rows, bodies, backwards);
        kernels.sweep(w.large_islands.blocks, &w.large_islands.velocity.data()->x, law, backwards);
      }
      EXPECT_EQ(residual(rows, bodies),
                kernels.residual(w.large_islands.blocks, &w.large_islands.velocity.data()->x));
      const std::string where = std::string(kernels.name) + ", seed " + std::to_string(seed);
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        const BodyVelocity& v = w.large_islands.velocity[i];
        ASSERT_EQ(Eigen::Vector3d(bodies[i].vx, bodies[i].vy, bodies[i].spin),
                  Eigen::Vector3d(v.x, v.y, v.spin))
            << where << " body " << i;
      }
      for (std::size_t r = 0; r < rows.size(); ++r) {
        const ContactBlock& block = w.large_islands.blocks[lanes[r].first];
        const std::size_t lane = lanes[r].second;
        ASSERT_EQ(rows[r].normal, block.normal[lane]) << where;
        ASSERT_EQ(rows[r].tangential, block.tangential[lane]) << where;
        ASSERT_EQ(rows[r].moment, block.moment[lane]) << where;
      }
    }
  }
  EXPECT_GE(sets, 1);
}

// Momentum in each SIMD lane, each instruction set against scalar code.
TEST(ContactBlocks, CarryOnAsNumbersDo) {
  for (const BlockKernels& kernels : all_block_kernels()) {
    if (!kernels.runs_here()) continue;
    test::Uniform draw(7);
    constexpr std::size_t kBlocks = 30;
    std::vector<ContactBlock> blocks(kBlocks);
    std::vector<BlockMomentum> momenta(kBlocks);
    using Row = std::tuple<Lanes<double>*, Lanes<double>*, Lanes<double>*, Lanes<double>*>;
    std::vector<Row> rows;  // impulse, last, step, weight
    for (std::size_t i = 0; i < kBlocks; ++i) {
      ContactBlock& k = blocks[i];
      BlockMomentum& m = momenta[i];
      rows.emplace_back(&k.normal, &m.last_normal, &m.step_normal, &m.weight_n);
      rows.emplace_back(&k.tangential, &m.last_tangential, &m.step_tangential, &m.weight_t);
      rows.emplace_back(&k.moment, &m.last_moment, &m.step_moment, &m.weight_r);
    }
    for (const auto& [now, last, step, weight] : rows) {
      for (auto* lanes : {now, last, step}) {
        for (double& x : *lanes) x = draw(-1.0, 1.0);
      }
      for (double& x : *weight) x = draw(0.0, 2.0);
    }
    double squared = 0.0;
    double along = 0.0;
    std::vector<Lanes<double>> carried;
    for (const auto& [now, last, step, weight] : rows) {
      carried.push_back(*now);
      for (std::size_t k = 0; k < kLanes; ++k) {
        const double change = (*now)[k] - (*last)[k];
        squared += (*weight)[k] * change * change;
        along += (*weight)[k] * change * (*step)[k];
        carried.back()[k] += 0.7 * (*step)[k];
      }
    }
    const BlockChange change = kernels.change(blocks, momenta);
    EXPECT_NEAR(change.squared, squared, 1e-12 * squared) << kernels.name;
    EXPECT_NEAR(change.along, along, 1e-12 * squared) << kernels.name;
    const BlockChange plain = all_block_kernels().back().change(blocks, momenta);
    EXPECT_EQ(change.squared, plain.squared) << kernels.name;
    EXPECT_EQ(change.along, plain.along) << kernels.name;
    const std::vector<BlockMomentum> before = momenta;
    kernels.carry(blocks, momenta, 0.7);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const auto& [now, last, step, weight] = rows[r];
      const BlockMomentum& old = before[r / 3];
      const Lanes<double>& from = r % 3 == 0   ? old.last_normal
                                  : r % 3 == 1 ? old.last_tangential
                                               : old.last_moment;
      EXPECT_EQ(*now, carried[r]) << kernels.name;
      EXPECT_EQ(*last, carried[r]) << kernels.name;
      for (std::size_t k = 0; k < kLanes; ++k) EXPECT_EQ((*step)[k], carried[r][k] - from[k]) << kernels.name;
    }
  }
}

// A column of discs on a floor, each penetrating the next by 1 mm: each sweep passes the push on by about one
// contact in either direction, and by more with momentum.
TEST(ContactBlocks, MomentumReachesTheBottomOfAHighColumn) {
  constexpr int kHigh = 100;
  constexpr int kSweeps = 400;
  constexpr double kPenetration = 1e-3;
  test::ContactScene s;
  s.fixed();
  for (int i = 0; i < kHigh; ++i) s.disc(Vec2(0.0, 0.5 + i), 0.5, 1.0);
  for (int i = 0; i < kHigh; ++i) {
    const int c = s.contact(i, i + 1, Vec2(0.0, i), {0.0, 1.0}, 0.0);
    s.contacts.gap[c] = -kPenetration;
  }
  Eigen::Matrix3Xd dq;
  ContactWorkspace w;
  const ContactSolverOptions options{.most_exact = 0, .large_sweeps = kSweeps, .large_tolerance = 1e-12};
  project_penetrations(s.mass, s.contacts, 1.0, dq, options, w);
  // By theory the top moves up by the sum of all penetrations.
  EXPECT_NEAR(dq(1, kHigh), kHigh * kPenetration, 0.01 * kHigh * kPenetration);

  std::vector<ContactRow> rows;
  std::vector<SolverBody> bodies;
  for (const auto& [k, lane] : lanes_of(w)) {
    rows.push_back(row_of(w.large_islands.blocks[k], lane));
    rows.back().normal = 0.0;
  }
  for (Eigen::Index i = 0; i < s.v.cols(); ++i) bodies.push_back({0.0, 0.0, 0.0, s.mass.inverse_mass[i]});
  for (int k = 0; k < kSweeps; ++k) sweep(rows, bodies, k % 2 == 1);
  EXPECT_LT(bodies.back().vy, 0.5 * kHigh * kPenetration);
}

// Friction and rolling resistance shared by many contacts: with momentum the residual is mostly smaller, and
// never much larger.
TEST(ContactBlocks, MomentumLeavesLittleMoreThanSweepsAlone) {
  constexpr int kSweeps = 40;
  int better = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto law = static_cast<BlockLaw>(seed % 3);
    test::ContactScene s = network(seed, law);
    ContactWorkspace w;
    solve_contacts(s.mass, s.contacts, s.v, {.most_exact = 0, .large_sweeps = 0}, w);
    double left_alone = 0.0;
    double left_with = 0.0;
    for (int i = 0; i < w.islands.size(); ++i) {
      const std::span<ContactBlock> blocks(w.large_islands.blocks.data() + w.first_block[i],
                                           w.large_islands.blocks.data() + w.first_block[i + 1]);
      const std::span<const BodyIndex> bodies(w.large_islands.bodies.data() + w.first_body[i],
                                              w.large_islands.bodies.data() + w.first_body[i + 1]);
      const std::vector<ContactBlock> start(blocks.begin(), blocks.end());
      const std::vector<BodyVelocity> velocity = w.large_islands.velocity;
      for (const bool with_momentum : {false, true}) {
        std::copy(start.begin(), start.end(), blocks.begin());
        w.large_islands.velocity = velocity;
        SweepMomentum momentum;
        BlockSweeps sweeps(blocks, bodies, law, w.large_islands.velocity, momentum);
        for (int k = 0; k < kSweeps; ++k) sweeps.sweep(k % 2 == 1, with_momentum && k < kSweeps - 2);
        double& left = with_momentum ? left_with : left_alone;
        left = std::max(left, sweeps.residual());
      }
    }
    EXPECT_LE(left_with, 100.0 * left_alone + 1e-6) << "seed " << seed;
    better += left_with < left_alone ? 1 : 0;
  }
  EXPECT_GT(better, 200);
}

TEST(ContactBlocks, FindWhatTheExactSolverFinds) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const test::RandomIsland kind{.most_contacts = 60, .most_friction = 0.3, .kinematic = seed % 3 == 0};
    test::ContactScene exact = test::random_island(seed, kind);
    test::ContactScene in_blocks = exact;
    const ContactSolverReport one = exact.solve({.tolerance = 1e-13, .max_newton = 200});
    const ContactSolverReport two = in_blocks.solve(kInBlocks);
    if (one.missed_islands > 0 || two.missed_islands > 0) continue;
    ++compared;
    EXPECT_EQ(two.newton_islands, 0);
    for (Eigen::Index i = 0; i < exact.v.size(); ++i)
      EXPECT_NEAR(exact.v.data()[i], in_blocks.v.data()[i], 1e-8) << "seed " << seed;
  }
  EXPECT_GT(compared, 70);
}

// Two columns that stand apart, the second of which moves on: the first is slow, whatever the other one does.
// All of both as exact as they were alone.
TEST(ContactBlocks, AreNotForIslandsThatHardlyMove) {
  constexpr int kHigh = 60;
  constexpr double kFall = 0.1;  // m/s, by the forces of a step
  test::ContactScene s;
  s.fixed();
  for (const double x : {0.0, 10.0}) {
    const int first = static_cast<int>(s.v.cols());
    for (int i = 0; i < kHigh; ++i) s.body(Vec2(x, 0.5 + i), 1.0, 0.1, {0.0, -kFall, 0.0});
    for (int i = 0; i < kHigh; ++i)
      s.contact(i == 0 ? 0 : first + i - 1, first + i, Vec2(x, i), {0.0, 1.0}, 0.5);
  }
  Eigen::Matrix3Xd motion = Eigen::Matrix3Xd::Zero(3, s.v.cols());
  for (int i = kHigh + 1; i <= 2 * kHigh; ++i) motion.col(i) << 0.01 * i, 0.0, 0.0;
  ContactWorkspace w;
  prepare_contacts(s.mass, s.contacts, {40, 100, 1e-3, &motion}, w);
  ASSERT_EQ(w.in_blocks, (std::vector<std::uint8_t>{0, 1}));
  EXPECT_TRUE(w.has_large_island());
  const ContactSolverOptions options{.tolerance = 1e-13, .large_sweeps = 4, .large_tolerance = 1e-9};
  const ContactSolverReport report = solve_prepared(s.mass, s.contacts, s.v, options, w);
  EXPECT_EQ(report.missed_islands, 1);
  for (int i = 1; i <= kHigh; ++i) {
    EXPECT_LT(s.v.col(i).norm(), 1e-12);
    EXPECT_NEAR(s.contacts.normal_impulse[i - 1], (kHigh - i + 1) * kFall, 1e-10);
  }
  EXPECT_GT(s.v.rightCols(kHigh).norm(), 1e-3);
}

// A slow island whose exact solve fails is solved in blocks, as if it were fast; no other island is.
TEST(ContactBlocks, TakeOverWhereTheExactSolveFails) {
  int taken_over = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const test::ContactScene start = network(seed, static_cast<BlockLaw>(seed % 3));
    const Eigen::Matrix3Xd still = Eigen::Matrix3Xd::Zero(3, start.v.cols());
    const auto solved = [&](const ExactIslands& exact, ContactSolverOptions options, ContactWorkspace& w) {
      test::ContactScene s = start;
      options.large_sweeps = 4000;
      options.large_tolerance = 1e-11;
      prepare_contacts(s.mass, s.contacts, exact, w);
      solve_prepared(s.mass, s.contacts, s.v, options, w);
      return s;
    };
    const ExactIslands slow{0, 1000, 0.0, &still};
    ContactWorkspace of_slow, of_all, of_none;
    const test::ContactScene exactly = solved({.most = 1000}, {.tolerance = 1e-13, .max_newton = 200}, of_all);
    const ContactSolverOptions patient{.tolerance = 1e-13, .max_newton = 200, .slow_sweeps = 1 << 30};
    const test::ContactScene by_newton = solved(slow, patient, of_slow);
    if (!of_slow.has_large_island()) {
      EXPECT_EQ(by_newton.v, exactly.v) << "seed " << seed;
    }

    const test::ContactScene in_blocks = solved({.most = 0}, {}, of_none);
    const test::ContactScene given_up =
        solved(slow, {.tolerance = 1e-13, .max_sweeps = 1, .max_newton = 0}, of_slow);
    const bool all =
        std::all_of(of_slow.in_blocks.begin(), of_slow.in_blocks.end(), [](auto in) { return in == 1; });
    if (!all) continue;
    ++taken_over;
    EXPECT_EQ(given_up.v, in_blocks.v) << "seed " << seed;
    EXPECT_EQ(given_up.contacts.normal_impulse, in_blocks.contacts.normal_impulse) << "seed " << seed;
  }
  EXPECT_GT(taken_over, 30);
}

// One preparation serves several solves, of velocities and of penetrations.
TEST(ContactBlocks, StayPreparedFromSolveToSolve) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    for (const int most_exact : {0, 40, 1000}) {
      test::ContactScene s = network(seed, BlockLaw::kRolling);
      test::ContactScene alone = s;
      const ContactSolverOptions options{.max_newton = 0, .most_exact = most_exact};
      ContactWorkspace w, other;
      Eigen::Matrix3Xd dq, expected;
      prepare_contacts(s.mass, s.contacts, {.most = most_exact}, w);
      project_prepared(s.mass, s.contacts, 0.5, dq, options, w);
      project_penetrations(s.mass, s.contacts, 0.5, expected, options, other);
      EXPECT_EQ(dq, expected) << "seed " << seed;
      for (int round = 0; round < 2; ++round) {
        solve_prepared(s.mass, s.contacts, s.v, options, w);
        ContactWorkspace fresh;
        solve_contacts(alone.mass, alone.contacts, alone.v, options, fresh);
        EXPECT_EQ(s.v, alone.v) << "seed " << seed;
        EXPECT_EQ(s.contacts.normal_impulse, alone.contacts.normal_impulse) << "seed " << seed;
        EXPECT_EQ(s.contacts.sticks, alone.contacts.sticks) << "seed " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace carom
