#include "physics/observe/expression.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <thread>
#include <vector>

#include "physics/scene/validate.h"

namespace carom {
namespace {

double value(const std::string& text, double t = 0.0, double x = 0.0) { return Expression(text, true)(t, x); }

std::string refusal(const std::string& text, bool with_x = false) {
  try {
    (void)Expression(text, with_x);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Expression, IsReadAsPeopleWriteIt) {
  EXPECT_DOUBLE_EQ(value("2*exp(-t/3)", 3.0), 2.0 * std::exp(-1.0));
  EXPECT_DOUBLE_EQ(value("-t^2", 3.0), -9.0);
  EXPECT_DOUBLE_EQ(value("1.5e-3*t", 2.0), 3e-3);
  EXPECT_DOUBLE_EQ(value("t < 1 ? 3*t : 3", 0.5), 1.5);
  EXPECT_DOUBLE_EQ(value("t < 1 ? 3*t : 3", 1.0), 3.0);
  EXPECT_DOUBLE_EQ(value("t >= 1 && x == 2 ? 1 : 0", 1.0, 2.0), 1.0);
  EXPECT_DOUBLE_EQ(value("sin(pi/2) + ln(exp(2)) + log10(100)"), 5.0);
  EXPECT_DOUBLE_EQ(value("mod(t, 0.5) + floor(t) + ceil(t)", -1.2), 0.3 - 2.0 - 1.0);
  EXPECT_DOUBLE_EQ(value("mod(t, -0.5)", 1.2), std::fmod(1.2, 0.5));
  EXPECT_TRUE(std::isinf(value("1/t")));
  EXPECT_TRUE(std::isnan(value("sqrt(-1)")));
  EXPECT_TRUE(std::isnan(Expression()(1.0)));
}

TEST(Expression, KnowsWhetherItDependsOnTime) {
  EXPECT_TRUE(Expression("2*t + x", true).uses_t());
  EXPECT_FALSE(Expression("2*x", true).uses_t());
}

TEST(Expression, IsComparedByItsText) {
  EXPECT_EQ(Expression("2*t", false), Expression("2*t", false));
  EXPECT_NE(Expression("2*t", false), Expression("t*2", false));
  EXPECT_LT(Expression(), Expression("t", false));
}

TEST(Expression, SaysWhereItIsWrongAndWhichNamesThereAre) {
  EXPECT_EQ(
      refusal("2*exq(t)"),
      "\"2*exq(t)\" at character 3: \"exq\" is not known; allowed: an expression of t, pi, abs, acos, acosh, "
      "asin, asinh, atan, atan2, atanh, avg, ceil, cos, cosh, exp, floor, ln, log, log10, log2, max, min, mod, "
      "rint, sign, sin, sinh, sqrt, sum, tan, tanh");
  EXPECT_NE(refusal("x + 1").find("character 1: \"x\" is not known"), std::string::npos);
  EXPECT_NE(refusal("y + 1", true).find("an expression of t, x, pi, abs"), std::string::npos);
  for (const char* text : {"", " ", "3+", "(1+2", "2 t", "1,2", "t=3", "3=t", "t<1?2", "\"abc\"", "min()",
                           "sin(1,2)", "t $ 2", "1e400", "sin", "t t", ")", "= ", "t\n+\n"}) {
    const std::string said = refusal(text);
    EXPECT_NE(said.find("; allowed: an expression of t, pi, abs"), std::string::npos) << text << ": " << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << text;
  }
  EXPECT_NE(refusal(std::string(3000, '(')).find("longer than 2000"), std::string::npos);
}

// Two threads that share one expression don't disturb each other.
TEST(Expression, CanBeAskedFromSeveralThreads) {
  const Expression shared("t + 0*sin(t)", false);
  std::vector<int> wrong(4, 0);
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < 4; ++k) {
      threads.emplace_back([&, k] {
        for (int i = 0; i < 20'000; ++i) wrong[k] += shared(k * 1000.0 + i) != k * 1000.0 + i;
      });
    }
  }
  EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

}  // namespace
}  // namespace carom
