#include "physics/math/anderson_mixing.h"

#include <cmath>
#include <gtest/gtest.h>

namespace carom {
namespace {

constexpr Eigen::Index kUnknowns = 6;

// Rounds until the residual f is below 1e-12; -1 if that takes more than `most`.
template <class Residual>
int rounds_to_solve(const Residual& f, bool mixed, int most) {
  AndersonMixing mixing;
  mixing.start(kUnknowns);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(kUnknowns);
  for (int round = 0; round < most; ++round) {
    const Eigen::VectorXd residual = f(x);
    if (residual.norm() < 1e-12) return round;
    x += mixed ? mixing.change(residual) : residual;
  }
  return -1;
}

// A x = b, with plain rounds that shrink the slowest error by 1 - 0.05.
TEST(AndersonMixing, SolvesLinearOnesInAFewRounds) {
  Eigen::MatrixXd a(kUnknowns, kUnknowns);
  Eigen::VectorXd b(kUnknowns);
  for (Eigen::Index i = 0; i < kUnknowns; ++i) {
    b[i] = 1.0 + static_cast<double>(i);
    for (Eigen::Index k = 0; k < kUnknowns; ++k)
      a(i, k) = i == k ? 0.05 + 0.15 * static_cast<double>(i) : 0.01 / (1.0 + static_cast<double>(i + k));
  }
  const auto f = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return b - a * x; };
  EXPECT_GT(rounds_to_solve(f, false, 10'000), 300);
  const int rounds = rounds_to_solve(f, true, AndersonMixing::kMixed);
  EXPECT_GE(rounds, 0);
  EXPECT_LE(rounds, 2 * kUnknowns);
}

// A number between -1 and 1 for each of these three.
double scattered(int seed, Eigen::Index i, Eigen::Index k) {
  const double v = std::sin(12.9898 * static_cast<double>(i + 1) + 78.233 * static_cast<double>(k + 1) +
                            37.719 * static_cast<double>(seed + 1)) *
                   43758.5453;
  return 2.0 * (v - std::floor(v)) - 1.0;
}

// Maps with kinks that shrink all distances. Of such, one in ten leads mixing alone astray for good; but then
// plain rounds follow from the start.
TEST(AndersonMixing, SolvesWhatPlainRoundsDo) {
  for (const double shrink : {0.7, 0.8, 0.9, 0.95}) {
    for (int seed = 0; seed < 300; ++seed) {
      const auto f = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
        Eigen::VectorXd residual(kUnknowns);
        for (Eigen::Index i = 0; i < kUnknowns; ++i) {
          const double bend = std::abs(x[(i + 1) % kUnknowns] - scattered(seed, i, 0));
          residual[i] = scattered(seed, i, 1) - x[i] + std::copysign(shrink, scattered(seed, i, 2)) * bend;
        }
        return residual;
      };
      const int plain = rounds_to_solve(f, false, 3000);
      ASSERT_GE(plain, 0);
      const int mixed = rounds_to_solve(f, true, 3000);
      EXPECT_GE(mixed, 0) << shrink << ", " << seed;
      EXPECT_LE(mixed, AndersonMixing::kMixed + plain) << shrink << ", " << seed;
    }
  }
}

}  // namespace
}  // namespace carom
