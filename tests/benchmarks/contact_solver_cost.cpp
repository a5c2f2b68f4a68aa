// Cost of the contact solver: ns for a contact and sweep; sweeps, linear systems and time to a residual on a
// pile of discs, a pyramid, a stack and a mass ratio of 10⁶. Prints figures, tests nothing.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <fmt/format.h>
#include <map>
#include <numbers>
#include <string>

#include "tests/support/contact_scenes.h"

namespace carom {
namespace {

using test::ContactScene;

constexpr double kG = 9.81;
constexpr double kStep = 1.0 / 60.0;

// CPU time: the machine may be shared.
double now_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Discs of r = 0.25 m, density 1, μ = 0.5 in an open container as wide as their grid. They fall on each other
// in sub-steps of 1/240 s by the solver itself, with speculative contacts. One more step of gravity is left
// to solve, from the last impulses if `warm`, else from zero.
ContactScene pile(int n, double seconds, bool warm) {
  constexpr double kRadius = 0.25;
  constexpr double kMargin = 0.05;
  constexpr double kSub = kStep / 4.0;
  const int columns = static_cast<int>(std::lround(std::sqrt(n)));
  const double width = 0.55 * columns;
  test::Uniform draw(1);
  ContactScene s;
  s.fixed();
  for (int i = 0; i < n; ++i) {
    const Vec2 at(0.55 * (i % columns + 0.5) + draw(-0.02, 0.02),
                  0.3 + 0.75 * (i / columns) + draw(-0.02, 0.02));
    s.disc(at, kRadius, std::numbers::pi * kRadius * kRadius);
  }
  ContactWorkspace workspace;
  std::map<std::pair<int, int>, Eigen::Vector2d> last;
  const auto find_contacts = [&] {
    s.contacts.resize(0);
    const auto add = [&](int a, int b, const Vec2& point, const Vec2& normal, double gap, int feature) {
      const int c = s.contact(a, b, point, normal, 0.5);
      s.contacts.gap[c] = gap;
      s.contacts.target[c] = -std::max(gap, 0.0) / kSub;
      const auto before = last.find({a == 0 ? -feature : a, b});
      if (before == last.end()) return;
      s.contacts.normal_impulse[c] = before->second.x();
      s.contacts.tangential_impulse[c] = before->second.y();
    };
    std::map<std::pair<int, int>, std::vector<int>> cells;
    const auto cell = [&](int i) {
      return std::pair(static_cast<int>(std::floor(s.position[i].x() / 0.56)),
                       static_cast<int>(std::floor(s.position[i].y() / 0.56)));
    };
    for (int i = 1; i <= n; ++i) cells[cell(i)].push_back(i);
    for (int i = 1; i <= n; ++i) {
      const Vec2 p = s.position[i];
      const double floor_gap = p.y() - kRadius;
      if (floor_gap < kMargin) add(0, i, {p.x(), 0.0}, {0.0, 1.0}, floor_gap, 1);
      if (p.x() - kRadius < kMargin) add(0, i, {0.0, p.y()}, {1.0, 0.0}, p.x() - kRadius, 2);
      if (width - p.x() - kRadius < kMargin) add(0, i, {width, p.y()}, {-1.0, 0.0}, width - p.x() - kRadius, 3);
      const auto [cx, cy] = cell(i);
      for (int dx = -1; dx <= 1; ++dx) {
        for (int dy = -1; dy <= 1; ++dy) {
          const auto found = cells.find({cx + dx, cy + dy});
          if (found == cells.end()) continue;
          for (const int j : found->second) {
            const Vec2 line = s.position[j] - p;
            const double gap = line.norm() - 2.0 * kRadius;
            if (j > i && gap < kMargin) add(i, j, p + 0.5 * line, line.normalized(), gap, 0);
          }
        }
      }
    }
  };
  for (int step = 0; step < static_cast<int>(seconds / kSub); ++step) {
    find_contacts();
    s.accelerate({0.0, -kG}, kSub);
    solve_contacts(s.mass, s.contacts, s.v, {.tolerance = 1e-4, .max_sweeps = 30, .max_newton = 0}, workspace);
    last.clear();
    for (int c = 0; c < s.contacts.size(); ++c) {
      const int a = s.contacts.a[c];
      const int feature = s.contacts.normal[c].x() == 0.0 ? 1 : s.contacts.normal[c].x() > 0.0 ? 2 : 3;
      last[{a == 0 ? -feature : a, s.contacts.b[c]}] = {s.contacts.normal_impulse[c],
                                                        s.contacts.tangential_impulse[c]};
    }
    for (std::size_t i = 0; i < s.position.size(); ++i) s.position[i] += kSub * s.v.col(i).head<2>();
  }
  if (!warm) last.clear();
  find_contacts();
  s.accelerate({0.0, -kG}, kSub);
  return s;
}

void sweep_cost(const ContactScene& scene, bool in_blocks) {
  ContactWorkspace w;
  double best = 1e300;
  for (int round = 0; round < 5; ++round) {
    // The sweeps alone: a solve with many less one with few. Islands of open contacts are done at once in
    // both.
    const auto solve = [&](int sweeps) {
      ContactScene s = scene;
      const double start = now_ms();
      const ContactSolverReport report = solve_contacts(s.mass, s.contacts, s.v,
                                                        {.tolerance = 0.0,
                                                         .max_sweeps = sweeps,
                                                         .max_newton = 0,
                                                         .most_exact = in_blocks ? 0 : 1 << 30,
                                                         .large_sweeps = sweeps,
                                                         .large_tolerance = 0.0},
                                                        w);
      return std::pair(now_ms() - start, report.contact_sweeps);
    };
    const auto [long_time, many] = solve(232);
    const auto [short_time, few] = solve(32);
    best = std::min(best, 1e6 * (long_time - short_time) / static_cast<double>(many - few));
  }
  fmt::print("{} contacts{}: {:.1f} ns a contact and sweep, measuring the residual every 8 included\n",
             scene.contacts.size(), in_blocks ? " in blocks" : "", best);
}

void to_residuals(const std::string& name, const ContactScene& scene) {
  for (const bool finish : {false, true}) {
    for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
      ContactWorkspace w;
      ContactSolverReport report;
      double best = 1e300;
      for (int round = 0; round < 3; ++round) {
        ContactScene s = scene;
        const double start = now_ms();
        report = solve_contacts(
            s.mass, s.contacts, s.v,
            {.tolerance = tolerance, .max_sweeps = finish ? 64 : 20000, .max_newton = finish ? 100 : 0}, w);
        best = std::min(best, now_ms() - start);
        if (best > 300.0) break;
      }
      fmt::print("{:22} {:5} contacts {:9} {:.0e}: {:5} sweeps {:3} systems {:9.3f} ms residual {:.1e}{}\n",
                 name, scene.contacts.size(), finish ? "finish" : "sweeps", tolerance, report.sweeps,
                 report.newton_iterations, best, report.residual, report.missed_islands > 0 ? " MISSED" : "");
    }
  }
}

ContactScene falling(ContactScene s) {
  s.accelerate({0.0, -kG}, kStep);
  return s;
}

}  // namespace
}  // namespace carom

int main() {
  using namespace carom;
  for (const bool in_blocks : {false, true}) {
    sweep_cost(pile(1400, 2.0, false), in_blocks);
    sweep_cost(pile(14000, 2.5, false), in_blocks);
  }
  to_residuals("pile 1000, cold", pile(1000, 8.0, false));
  to_residuals("pile 1000, warm", pile(1000, 8.0, true));
  to_residuals("pyramid 20", falling(test::pyramid(20, 0.6)));
  to_residuals("stack 20", falling(test::stack_of(std::vector<double>(20, 1.0), 0.6)));
  to_residuals("10^6 on 1", falling(test::stack_of({1.0, 1e6}, 0.6)));
  std::vector<double> alternating;
  for (int i = 0; i < 20; ++i) alternating.push_back(i % 2 == 0 ? 1.0 : 1e6);
  to_residuals("alternating 1, 10^6", falling(test::stack_of(alternating, 0.6)));
}
