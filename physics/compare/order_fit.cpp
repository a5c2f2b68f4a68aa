#include "physics/compare/order_fit.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "physics/math/least_squares.h"

namespace carom {
namespace {

constexpr std::size_t kLeastPoints = 3;
constexpr double kStraight = 0.05;  // of ln(error): largest distance from a line that counts as straight
constexpr double kLeastShare = 0.5;

}  // namespace

OrderFit fit_order(std::span<const ErrorAtStep> errors, double floor, double largest) {
  OrderFit fit;
  std::vector<Vec2> points;  // of ln(step) and ln(error)
  bool any = false;
  bool exact = true;
  for (const ErrorAtStep& e : errors) {
    if (std::isnan(e.error)) continue;
    any = true;
    exact = exact && e.error <= kExactBelowFloor * floor;
    if (e.error > kFittedAboveFloor * floor && e.error < largest) {
      points.emplace_back(std::log(e.step), std::log(e.error));
    }
  }
  if (any && exact) {
    fit.kind = OrderFit::Kind::kExact;
    return fit;
  }
  std::sort(points.begin(), points.end(), [](const Vec2& p, const Vec2& q) { return p.x() < q.x(); });
  const auto same_step = std::adjacent_find(points.begin(), points.end(),
                                            [](const Vec2& p, const Vec2& q) { return p.x() == q.x(); });
  if (points.size() < kLeastPoints || same_step != points.end()) return fit;

  // The finest steps always count: only from the coarse end is something left out.
  std::span<const Vec2> best = points;
  const auto needed = std::max(
      kLeastPoints, static_cast<std::size_t>(std::ceil(kLeastShare * static_cast<double>(points.size()))));
  for (std::size_t count = points.size(); count >= needed; --count) {
    const auto finest = std::span<const Vec2>(points).first(count);
    if (fit_line(finest).farthest > kStraight) continue;
    best = finest;
    break;
  }
  const Line line = fit_line(best);
  fit.kind = OrderFit::Kind::kOrder;
  fit.order = std::abs(line.slope) < 5e-3 ? 0.0 : line.slope;  // not "-0.00" where nothing changes
  fit.uncertainty = line.uncertainty;
  fit.from = std::exp(best.front().x());
  fit.to = std::exp(best.back().x());
  fit.points = static_cast<int>(best.size());
  return fit;
}

std::string text_of(const OrderFit& fit) {
  switch (fit.kind) {
    case OrderFit::Kind::kExact:
      return "exact here";
    case OrderFit::Kind::kNone:
      return "no order";
    case OrderFit::Kind::kOrder:
      break;
  }
  return fmt::format("{:.2f} ± {:.2f}", fit.order, fit.uncertainty);
}

}  // namespace carom
