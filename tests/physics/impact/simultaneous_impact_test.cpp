#include "physics/impact/simultaneous_impact.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <optional>
#include <random>

namespace carom {
namespace {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  int below(int n) { return static_cast<int>((*this)(0.0, n)); }

 private:
  std::mt19937_64 random_;
};

double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

struct Cluster {
  Eigen::Matrix3Xd v;
  Eigen::VectorXd inverse_mass;
  Eigen::VectorXd inverse_inertia;
  std::vector<ClusterContact> contacts = {};
  std::vector<Impact> impacts = {};
  ClusterRestitution restitution = ClusterRestitution::kSmallest;

  explicit Cluster(int bodies)
      : v(Eigen::Matrix3Xd::Zero(3, bodies)),
        inverse_mass(Eigen::VectorXd::Zero(bodies)),
        inverse_inertia(Eigen::VectorXd::Zero(bodies)) {}

  ClusterOutcome resolve() {
    ClusterScratch scratch;
    impacts.resize(contacts.size());
    Eigen::Matrix3Xd answers;
    free_answers(inverse_mass, inverse_inertia, contacts, answers);
    return resolve_simultaneous(v, answers, contacts, restitution, impacts, scratch);
  }
  [[nodiscard]] RelativeVelocity at(const ClusterContact& c) const {
    const auto point = [&](int body, const Vec2& r) -> Vec2 {
      return v.col(body).head<2>() + v(2, body) * Vec2(-r.y(), r.x());
    };
    const Vec2 u = point(c.b, c.from_b) - point(c.a, c.from_a);
    return {u.dot(c.normal), cross(c.normal, u)};
  }
  [[nodiscard]] double energy() const {
    double sum = 0.0;
    for (int i = 0; i < v.cols(); ++i) {
      if (inverse_mass[i] > 0.0) sum += 0.5 * v.col(i).head<2>().squaredNorm() / inverse_mass[i];
      if (inverse_inertia[i] > 0.0) sum += 0.5 * v(2, i) * v(2, i) / inverse_inertia[i];
    }
    return sum;
  }
  [[nodiscard]] double lost() const {
    double sum = 0.0;
    for (const Impact& j : impacts) sum += j.lost_to_restitution + j.lost_to_friction;
    return sum;
  }
};

// --- the complementarity problem

// Random semidefinite problems of low rank, made solvable: q = w - M z for some complementary w, z.
TEST(Lcp, DegenerateSemidefiniteProblems) {
  Draw draw(21);
  LcpSolver lcp;
  for (int i = 0; i < 3'000; ++i) {
    const int n = 1 + draw.below(12);
    const int rank = 1 + draw.below(n);
    Eigen::MatrixXd root(n, rank);
    for (double& x : root.reshaped()) x = draw.below(2) == 0 ? draw(-1.0, 1.0) : draw.below(3) - 1.0;
    const Eigen::MatrixXd m = root * root.transpose();
    Eigen::VectorXd w = Eigen::VectorXd::Zero(n), z = Eigen::VectorXd::Zero(n);
    for (int k = 0; k < n; ++k) {
      const int kind = draw.below(3);  // the third is degenerate
      if (kind == 0) w[k] = draw(0.0, 1.0);
      if (kind == 1) z[k] = draw(0.0, 1.0);
    }
    const Eigen::VectorXd q = w - m * z;
    ASSERT_TRUE(lcp.solve(m, q)) << "case " << i;
    const Eigen::VectorXd found = lcp.solution();
    const Eigen::VectorXd slack = m * found + q;
    ASSERT_GE(found.minCoeff(), 0.0) << "case " << i;
    ASSERT_GE(slack.minCoeff(), -1e-11) << "case " << i;
    ASSERT_LE(found.cwiseMin(slack).maxCoeff(), 1e-11) << "case " << i;
    // Every solution of a semidefinite problem has the same M z.
    ASSERT_LE((m * (found - z)).cwiseAbs().maxCoeff(), 1e-10) << "case " << i;
  }
}

TEST(Lcp, SaysThatThereIsNoSolution) {
  LcpSolver lcp;
  const Eigen::Matrix2d m{{1.0, -1.0}, {-1.0, 1.0}};
  EXPECT_FALSE(lcp.solve(m, Eigen::Vector2d(-1.0, -1.0)));
  EXPECT_TRUE(lcp.solve(m, Eigen::Vector2d(-1.0, 1.0)));
  EXPECT_TRUE(lcp.solve(m, Eigen::Vector2d(1.0, 2.0)));
  EXPECT_EQ(lcp.solution(), Eigen::Vector2d(0.0, 0.0));
}

// --- known clusters

Cluster cradle(int balls, double restitution) {
  Cluster c(balls);
  c.inverse_mass.setConstant(2.0);
  c.inverse_inertia.setConstant(2.0 / (0.5 * 0.01));
  for (int i = 0; i + 1 < balls; ++i) {
    c.contacts.push_back({i, i + 1, {1.0, 0.0}, {0.1, 0.0}, {-0.1, 0.0}, restitution, 0.0});
  }
  c.v(0, 0) = 1.5;
  return c;
}

TEST(SimultaneousImpact, CradleOfThree) {
  Cluster c = cradle(3, 1.0);
  const ClusterOutcome outcome = c.resolve();
  EXPECT_TRUE(outcome.solved);
  EXPECT_FALSE(outcome.lowered);
  EXPECT_NEAR(c.v(0, 0), -1.5 / 3.0, 1e-15);
  EXPECT_NEAR(c.v(0, 1), 1.0, 1e-15);
  EXPECT_NEAR(c.v(0, 2), 1.0, 1e-15);
  EXPECT_NEAR(c.v.row(0).sum(), 1.5, 1e-15);
  EXPECT_NEAR(c.energy(), cradle(3, 1.0).energy(), 1e-15);
  EXPECT_NEAR(c.lost(), 0.0, 1e-15);
}

TEST(SimultaneousImpact, PlasticCradleMovesAsOne) {
  Cluster c = cradle(20, 0.0);
  EXPECT_TRUE(c.resolve().solved);
  for (int i = 0; i < 20; ++i) EXPECT_NEAR(c.v(0, i), 1.5 / 20.0, 1e-15);
}

TEST(SimultaneousImpact, ElasticCradleOfTwentyKeepsBothSums) {
  Cluster c = cradle(20, 1.0);
  EXPECT_TRUE(c.resolve().solved);
  EXPECT_NEAR(c.v.row(0).sum(), 1.5, 1e-14);
  EXPECT_NEAR(c.energy(), cradle(20, 1.0).energy(), 1e-14);
}

// A box of width w and height h on a floor, on `supports` points of its lower side.
Cluster box_on_floor(double w, double h, int supports, double restitution, double friction) {
  Cluster c(2);  // 0 the floor
  const double mass = 3.0;
  c.inverse_mass[1] = 1.0 / mass;
  c.inverse_inertia[1] = 12.0 / (mass * (w * w + h * h));
  for (int i = 0; i < supports; ++i) {
    const Vec2 r(w * (static_cast<double>(i) / (supports - 1) - 0.5), -0.5 * h);
    c.contacts.push_back({0, 1, {0.0, 1.0}, {r.x(), 0.0}, r, restitution, friction});
  }
  return c;
}

TEST(SimultaneousImpact, BoxLandsFlatOnTwoAndOnSevenPoints) {
  for (const int supports : {2, 7}) {
    for (const double e : {0.0, 0.4, 1.0}) {
      Cluster c = box_on_floor(0.7, 0.4, supports, e, 0.0);
      c.v.col(1) = Eigen::Vector3d(0.3, -2.0, 0.0);
      EXPECT_TRUE(c.resolve().solved);
      EXPECT_NEAR(c.v(0, 1), 0.3, 0.0);
      EXPECT_NEAR(c.v(1, 1), 2.0 * e, 1e-14);
      EXPECT_NEAR(c.v(2, 1), 0.0, 1e-14);
      EXPECT_NEAR(c.lost(), 0.5 * 3.0 * 4.0 * (1.0 - e * e), 1e-14);
    }
  }
}

// Housner's block: it turns about one corner until the other strikes, e = 0, both solved at once:
// ω'/ω = 1 - 1.5 sin²α while μ >= 3 sinα cosα/(4 - 3 sin²α) and sin²α < 2/3, tan α = w/h.
TEST(SimultaneousImpact, RockingBlock) {
  for (const double alpha : {0.1, 0.3, 0.6, 0.9}) {
    const double s = std::sin(alpha), enough = 3.0 * s * std::cos(alpha) / (4.0 - 3.0 * s * s);
    for (const int supports : {2, 3}) {
      const auto rock = [&](double friction) {
        Cluster c = box_on_floor(std::sin(alpha), std::cos(alpha), supports, 0.0, friction);
        const double spin =
            1.3;  // about the left corner, upwards on the right: turned over, the right one strikes
        const Vec2 from_pivot(0.5 * std::sin(alpha), 0.5 * std::cos(alpha));
        c.v.col(1) << -spin * Vec2(-from_pivot.y(), from_pivot.x()), -spin;
        const double energy = c.energy();
        EXPECT_TRUE(c.resolve().solved);
        EXPECT_NEAR(energy - c.energy(), c.lost(), 1e-14 * energy);
        return c;
      };
      Cluster c = rock(1.001 * enough);
      EXPECT_NEAR(c.v(2, 1) / -1.3, 1.0 - 1.5 * s * s, 1e-14) << alpha << ' ' << supports;
      EXPECT_NEAR(c.at(c.contacts.back()).tangential, 0.0, 1e-14);
      Cluster slid = rock(0.99 * enough);
      EXPECT_GT(std::abs(slid.at(slid.contacts.back()).tangential), 1e-5) << alpha << ' ' << supports;
    }
  }
  Cluster flat = box_on_floor(2.0, 0.5, 2, 0.0, 5.0);  // sin²α > 2/3: it stays down
  flat.v.col(1) << 0.25 * 1.3, -1.3, -1.3;
  EXPECT_TRUE(flat.resolve().solved);
  EXPECT_NEAR(flat.v.col(1).norm(), 0.0, 1e-14);
}

// A ball between two driven walls that close on it: nothing can satisfy the law, and nothing changes.
TEST(SimultaneousImpact, CrushedBallIsReported) {
  Cluster c(3);
  c.inverse_mass[1] = c.inverse_inertia[1] = 1.0;
  c.contacts = {{0, 1, {1.0, 0.0}, {0.0, 0.0}, {-0.1, 0.0}, 0.5, 0.0},
                {1, 2, {1.0, 0.0}, {0.1, 0.0}, {0.0, 0.0}, 0.5, 0.0}};
  c.v(0, 0) = 1.0;
  c.v(0, 2) = -1.0;
  const Eigen::Matrix3Xd before = c.v;
  EXPECT_FALSE(c.resolve().solved);
  EXPECT_EQ(c.v, before);
  EXPECT_EQ(c.impacts[0].normal, 0.0);
  c.v(0, 2) = 1.0;  // going the same way they can
  EXPECT_TRUE(c.resolve().solved);
  EXPECT_NEAR(c.v(0, 1), 1.0, 1e-15);
}

// A disc falls into a right-angled groove: both walls at once send it straight back, with friction too.
TEST(SimultaneousImpact, DiscInAGroove) {
  for (const double friction : {0.0, 0.7}) {
    for (const double e : {0.0, 0.5, 1.0}) {
      Cluster c(2);
      c.inverse_mass[1] = 0.5;
      c.inverse_inertia[1] = 1.0 / (0.5 * 2.0 * 0.01);
      const double s = std::sqrt(0.5);
      c.contacts = {{0, 1, {s, s}, Vec2::Zero(), {-0.1 * s, -0.1 * s}, e, friction},
                    {0, 1, {-s, s}, Vec2::Zero(), {0.1 * s, -0.1 * s}, e, friction}};
      c.v(1, 1) = -3.0;
      EXPECT_TRUE(c.resolve().solved);
      EXPECT_NEAR(c.v(0, 1), 0.0, 1e-14);
      EXPECT_NEAR(c.v(2, 1), 0.0, 1e-12);
      if (friction == 0.0) {
        EXPECT_NEAR(c.v(1, 1), 3.0 * e, 1e-14);
      }
      EXPECT_LE(c.energy(), 9.0 * (1.0 + 1e-14));
    }
  }
}

// --- random clusters

// Up to five bodies, the first one immovable. Two convex bodies touch along one line: all contacts of a pair
// share its normal and lie beside each other; some are there twice.
Cluster random_cluster(Draw& draw, int contacts, bool friction) {
  const int bodies = 2 + draw.below(4);
  Cluster c(bodies);
  for (int i = 1; i < bodies; ++i) {
    c.inverse_mass[i] = std::exp(draw(-3.0, 3.0));
    c.inverse_inertia[i] = c.inverse_mass[i] * draw(1.0, 5.0);
    c.v.col(i) = Eigen::Vector3d(draw(-3.0, 3.0), draw(-3.0, 3.0), draw(-3.0, 3.0));
  }
  const double e = draw.below(3) == 0 ? 1.0 : draw(0.0, 1.0);
  for (int i = 0; i < contacts; ++i) {
    const int b = 1 + draw.below(bodies - 1);
    const int a = draw.below(b);
    const auto same_pair = std::find_if(c.contacts.begin(), c.contacts.end(),
                                        [&](const ClusterContact& k) { return k.a == a && k.b == b; });
    ClusterContact k;
    if (same_pair != c.contacts.end()) {
      k = *same_pair;
      const Vec2 beside =
          draw.below(3) == 0 ? 0.0 * k.normal : draw(-1.0, 1.0) * Vec2(-k.normal.y(), k.normal.x());
      k.from_a += beside;
      k.from_b += beside;
    } else {
      const double angle = draw(0.0, 6.283185307179586);
      const Vec2 n(std::cos(angle), std::sin(angle)), t(-n.y(), n.x());
      k = {a, b,  n, draw(0.3, 1.0) * n + draw(-1.0, 1.0) * t, -draw(0.3, 1.0) * n + draw(-1.0, 1.0) * t,
           e, 0.0};
      if (friction) k.kinetic_friction = draw(0.0, 1.5);
    }
    c.contacts.push_back(k);
  }
  return c;
}

struct Tally {
  int lowered = 0, unsolved = 0;
};

// Momentum, energy and no approach left, on clusters of up to 8 contacts, some of them doubled.
Tally check_random(std::uint64_t seed, bool friction, int cases) {
  Draw draw(seed);
  Tally tally;
  for (int i = 0; i < cases; ++i) {
    Cluster c = random_cluster(draw, 1 + draw.below(8), friction);
    const Cluster before = c;
    const ClusterOutcome outcome = c.resolve();
    const std::string where = fmt::format("seed {} case {}", seed, i);
    tally.lowered += outcome.lowered ? 1 : 0;
    if (!outcome.solved) ++tally.unsolved;
    const double energy = before.energy();
    // In a wedge of several bodies the impulses may be far greater than the momenta, and rounding is of them.
    double pushed = 0.0;
    for (const Impact& j : c.impacts) pushed += j.normal;
    const double rounding = 1e-12 * energy + 1e-15 * pushed * pushed * c.inverse_mass.maxCoeff();
    EXPECT_LE(c.energy(), energy + rounding) << where;
    EXPECT_NEAR(energy - c.energy(), c.lost(), rounding) << where;
    Eigen::Matrix3Xd v = before.v;
    for (std::size_t k = 0; k < c.contacts.size(); ++k) {
      const ClusterContact& contact = c.contacts[k];
      const Impact& j = c.impacts[k];
      EXPECT_GE(j.normal, 0.0) << where;
      EXPECT_LE(std::abs(j.tangential), contact.kinetic_friction * j.normal) << where;
      if (outcome.solved && c.inverse_mass[contact.a] + c.inverse_mass[contact.b] > 0.0) {
        EXPECT_GE(c.at(contact).normal, -1e-8) << where;
      }
      const Vec2 impulse =
          j.normal * contact.normal + j.tangential * Vec2(-contact.normal.y(), contact.normal.x());
      for (const auto& [body, sign, r] :
           {std::tuple{contact.a, -1.0, contact.from_a}, std::tuple{contact.b, 1.0, contact.from_b}}) {
        v.col(body).head<2>() += sign * c.inverse_mass[body] * impulse;
        v(2, body) += sign * c.inverse_inertia[body] * cross(r, impulse);
      }
    }
    EXPECT_LE((v - c.v).cwiseAbs().maxCoeff(), 1e-10) << where;
    if (testing::Test::HasFailure()) break;
  }
  return tally;
}

TEST(SimultaneousImpact, RandomClustersKeepTheLaws) {
  const Tally smooth = check_random(22, false, 10'000);
  EXPECT_EQ(smooth.unsolved, 0);
  const Tally rough = check_random(23, true, 4'000);
  EXPECT_EQ(rough.unsolved, 0);
  RecordProperty("smooth_lowered", smooth.lowered);
  RecordProperty("rough_lowered", rough.lowered);
}

// The obvious way: try every set of closed contacts without friction, and take the velocities of one that
// satisfies the law, which all share.
std::optional<Eigen::VectorXd> by_enumeration(const Eigen::MatrixXd& k, const Eigen::VectorXd& u, double e) {
  const int m = static_cast<int>(u.size());
  for (int set = 0; set < 1 << m; ++set) {
    std::vector<int> closed;
    for (int i = 0; i < m; ++i) {
      if ((set >> i & 1) != 0) closed.push_back(i);
    }
    Eigen::VectorXd j = Eigen::VectorXd::Zero(m);
    if (!closed.empty()) {
      const Eigen::MatrixXd part = k(closed, closed);
      const Eigen::FullPivLU<Eigen::MatrixXd> lu(part);
      if (!lu.isInvertible()) continue;  // a smaller set gives the same velocities
      j(closed) = lu.solve(Eigen::VectorXd(-(1.0 + e) * u(closed)));
    }
    if (j.minCoeff() < -1e-10) continue;
    const Eigen::VectorXd after = u + k * j;
    if ((after + e * u).minCoeff() >= -1e-9) return after;
  }
  return std::nullopt;
}

TEST(SimultaneousImpact, WithoutFrictionIsTheEnumeratedSolution) {
  Draw draw(24);
  int compared = 0;
  for (int i = 0; i < 5'000; ++i) {
    Cluster c = random_cluster(draw, 1 + draw.below(5), false);
    const int m = static_cast<int>(c.contacts.size());
    // Only what has not been under way apart: then e is not lowered.
    std::erase_if(c.contacts, [&](const ClusterContact& k) { return c.at(k).normal > 0.0; });
    if (c.contacts.empty()) continue;
    const int n = static_cast<int>(c.contacts.size());
    Eigen::VectorXd u(n);
    Eigen::MatrixXd k(n, n);
    for (int p = 0; p < n; ++p) {
      u[p] = c.at(c.contacts[static_cast<std::size_t>(p)]).normal;
      const ClusterContact& struck = c.contacts[static_cast<std::size_t>(p)];
      Cluster probe = c;
      probe.v.col(struck.a) -= (Eigen::Vector3d() << c.inverse_mass[struck.a] * struck.normal,
                                c.inverse_inertia[struck.a] * cross(struck.from_a, struck.normal))
                                   .finished();
      probe.v.col(struck.b) += (Eigen::Vector3d() << c.inverse_mass[struck.b] * struck.normal,
                                c.inverse_inertia[struck.b] * cross(struck.from_b, struck.normal))
                                   .finished();
      for (int q = 0; q < n; ++q) {
        const ClusterContact& other = c.contacts[static_cast<std::size_t>(q)];
        k(q, p) = probe.at(other).normal - c.at(other).normal;
      }
    }
    const std::optional<Eigen::VectorXd> expected = by_enumeration(k, u, c.contacts.front().restitution);
    ASSERT_TRUE(expected.has_value()) << "case " << i << " of " << m;
    const ClusterOutcome outcome = c.resolve();
    ASSERT_FALSE(outcome.lowered) << "case " << i;
    for (int p = 0; p < n; ++p) {
      ASSERT_NEAR(c.at(c.contacts[static_cast<std::size_t>(p)]).normal, (*expected)[p], 1e-9) << "case " << i;
    }
    ++compared;
  }
  EXPECT_GT(compared, 3'000);
}

// One contact is Newton's law with Coulomb's cone where that gains nothing; where it gains, e is lowered.
TEST(SimultaneousImpact, OneContactIsNewtonsLaw) {
  Draw draw(25);
  int gained = 0;
  for (int i = 0; i < 20'000; ++i) {
    Cluster c = random_cluster(draw, 1, true);
    const ClusterContact& k = c.contacts.front();
    if (c.at(k).normal >= 0.0) continue;
    ImpactSide a{c.v.col(k.a).head<2>(), c.v(2, k.a),
                 c.inverse_mass[k.a],    c.inverse_inertia[k.a],
                 k.from_a.dot(k.normal), cross(k.from_a, k.normal)};
    ImpactSide b{c.v.col(k.b).head<2>(),  c.v(2, k.b),
                 c.inverse_mass[k.b],     c.inverse_inertia[k.b],
                 -k.from_b.dot(k.normal), -cross(k.from_b, k.normal)};
    const Impact j = resolve_impact(
        a, b, k.normal, {k.restitution, 0.0, k.kinetic_friction, k.kinetic_friction}, ImpactLawId::kNewton);
    const ClusterOutcome outcome = c.resolve();
    if (j.energy_gain > 1e-12 * c.energy()) {
      ++gained;
      ASSERT_TRUE(outcome.lowered) << "case " << i;
      ASSERT_LT(outcome.restitution, k.restitution) << "case " << i;
    } else if (!outcome.lowered) {
      const double size = j.normal * (1.0 + k.kinetic_friction);
      ASSERT_NEAR(c.impacts.front().normal, j.normal, 1e-11 * size) << "case " << i;
      ASSERT_NEAR(c.impacts.front().tangential, j.tangential, 1e-11 * size) << "case " << i;
    }
  }
  EXPECT_GT(gained, 20);
}

// With friction: one pass of plastic impacts satisfies Coulomb's law at each contact.
TEST(SimultaneousImpact, FrictionIsCoulombs) {
  Draw draw(26);
  for (int i = 0; i < 10'000; ++i) {
    Cluster c = random_cluster(draw, 1 + draw.below(6), true);
    for (ClusterContact& k : c.contacts) k.restitution = 0.0;
    const double speed = std::sqrt(2.0 * c.energy() * c.inverse_mass.maxCoeff());
    ASSERT_TRUE(c.resolve().solved) << "case " << i;
    for (std::size_t k = 0; k < c.contacts.size(); ++k) {
      const RelativeVelocity u = c.at(c.contacts[k]);
      const Impact& j = c.impacts[k];
      const double most = c.contacts[k].kinetic_friction * j.normal;
      const double work = 1e-10 * speed * (1.0 + j.normal);
      ASSERT_NEAR(u.normal * j.normal, 0.0, work) << "case " << i;
      // Either no slip, or the whole of friction against it.
      ASSERT_NEAR(j.tangential * u.tangential, -most * std::abs(u.tangential), work) << "case " << i;
    }
  }
}

}  // namespace
}  // namespace carom
