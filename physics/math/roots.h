#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

// A root of f between a and b, where f(a) > 0 >= f(b), to the last bit of the argument. The result lies on
// the side of a, where f is positive or exactly zero, so bodies are never left penetrating. T. R.
// Chandrupatla, Advances in Engineering Software 28 (1997) 145: inverse quadratic interpolation where it is
// safe, bisection elsewhere.
template <class Function>
[[nodiscard]] double bracketed_root(const Function& f, double a, double fa, double b, double fb) {
  if (fb == 0.0) return b;
  double low = a;  // largest argument known with f > 0
  double x1 = b, f1 = fb, x2 = a, f2 = fa, x3 = b, f3 = fb;
  double t = 0.5;
  if (std::abs(fa - fb) > 0.0) t = fb / (fb - fa);
  for (int i = 0; i < 200; ++i) {
    double x = x1 + t * (x2 - x1);
    // If the guess rounds to an end, take the neighbouring number.
    if (x == x1) x = std::nextafter(x1, x2);
    if (x == x2) x = std::nextafter(x2, x1);
    if (x == x1) break;
    const double fx = f(x);
    if (fx >= 0.0) low = x;
    if (fx == 0.0) break;
    if ((fx > 0.0) == (f1 > 0.0)) {
      x3 = x1, f3 = f1;
    } else {
      x3 = x2, f3 = f2;
      x2 = x1, f2 = f1;
    }
    x1 = x, f1 = fx;
    // x1 is the newest point, x1 and x2 bracket the root, x3 is the point before.
    const double xi = (x1 - x2) / (x3 - x2);
    const double phi = (f1 - f2) / (f3 - f2);
    if (phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi) {
      t = f1 / (f2 - f1) * f3 / (f2 - f3) + (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2);
    } else {
      t = 0.5;
    }
    const double width = std::abs(x2 - x1);
    const double least = 0.5 * std::numeric_limits<double>::epsilon() * std::max(std::abs(x1), std::abs(x2));
    if (width <= 2.0 * least) break;
    t = std::min(1.0 - least / width, std::max(least / width, t));
  }
  return low;
}

}  // namespace carom
