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

// With kinks it may go astray, but then plain rounds follow from the start.
TEST(AndersonMixing, SolvesWhatPlainRoundsDo) {
  for (const double slope : {0.05, 0.3, 0.9}) {
    const auto f = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
      Eigen::VectorXd residual(kUnknowns);
      for (Eigen::Index i = 0; i < kUnknowns; ++i) {
        const double next = x[(i + 1) % kUnknowns];
        residual[i] = 1.0 - x[i] + (1.0 - slope) * std::abs(std::sin(3.0 * static_cast<double>(i)) - next);
      }
      return residual;
    };
    const int plain = rounds_to_solve(f, false, 2000);
    ASSERT_GE(plain, 0) << slope;
    const int mixed = rounds_to_solve(f, true, 2000);
    EXPECT_GE(mixed, 0) << slope;
    EXPECT_LE(mixed, AndersonMixing::kMixed + plain) << slope;
  }
}

}  // namespace
}  // namespace carom
