#include <ctime>
#include <fmt/format.h>

#include "physics/collision/pair_contact.h"
#include "physics/collision/turning_pair.h"
#include "physics/model/geometry.h"
#include "tests/support/convex_reference.h"
#include "tests/support/scenes.h"

// CPU time of one query of a pair: gap, contact and manifold by kinds of shape, and one search for the first
// contact. The bodies are near each other, half of them penetrating. Prints figures, tests nothing.
namespace carom {
namespace {

using test::ShapeKind;
using test::uniform;

double now() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e9 + static_cast<double>(t.tv_nsec);
}

// ns a call, the best of some repeats; the result of call(i) is used so that it is not optimised away.
template <class Call>
double cost(int pairs, const Call& call) {
  double best = 1e300;
  volatile double kept = 0.0;
  for (int repeat = 0; repeat < 20; ++repeat) {
    const double from = now();
    double sum = 0.0;
    for (int i = 0; i < pairs; ++i) sum += call(i);
    kept = sum;
    best = std::min(best, (now() - from) / pairs);
  }
  static_cast<void>(kept);
  return best;
}

constexpr int kPairs = 1000;

void queries(ShapeKind a, ShapeKind b) {
  std::mt19937_64 random(1);
  std::vector<ConvexShape> list;
  std::vector<Eigen::Vector3d> q;
  for (int i = 0; i < kPairs; ++i) {
    list.push_back(test::random_shape(random, a));
    list.push_back(test::random_shape(random, b));
    for (int k = 0; k < 2; ++k) {
      q.emplace_back(uniform(random, -0.8, 0.8), uniform(random, -0.8, 0.8), uniform(random, -3.0, 3.0));
    }
  }
  const ConvexShapes s = convex_shapes(list);
  const auto first = [](int i) { return ShapeIndex{2 * i}; };
  const auto second = [](int i) { return ShapeIndex{2 * i + 1}; };
  const auto pose = [&](ShapeIndex i) { return pose_of(s, i, q[static_cast<std::size_t>(i)]); };
  const double gap = cost(
      kPairs, [&](int i) { return gap_between(s, first(i), pose(first(i)), second(i), pose(second(i))).gap; });
  const double contact = cost(kPairs, [&](int i) {
    return contact_between(s, first(i), pose(first(i)), second(i), pose(second(i))).point.x();
  });
  const double points = cost(kPairs, [&](int i) {
    return manifold(s, first(i), pose(first(i)), second(i), pose(second(i)), 0.01).normal.x();
  });
  fmt::print("{:>16} {:<16} {:8.0f} {:8.0f} {:8.0f}\n", test::kShapeNames[static_cast<int>(a)],
             test::kShapeNames[static_cast<int>(b)], gap, contact, points);
}

void discs_and_boxes() {
  std::mt19937_64 random(1);
  for (const bool boxed : {false, true}) {
    std::vector<Body> bodies;
    std::vector<Eigen::Vector3d> q;
    for (int i = 0; i < 2 * kPairs; ++i) {
      bodies.push_back(test::disc("", {0, 0}, {0, 0}, uniform(random, 0.05, 1.0)));
      if (boxed && i % 2 == 0)
        bodies.back().shape = Box{uniform(random, 0.05, 2.0), uniform(random, 0.05, 2.0)};
      q.emplace_back(uniform(random, -0.8, 0.8), uniform(random, -0.8, 0.8), uniform(random, -3.0, 3.0));
    }
    const Geometry g = geometry(bodies);
    fmt::print(
        "{:>16} {:<16} {:>8} {:8.0f}   of physics/model/geometry.h\n", boxed ? "box" : "disc", "disc", "",
        cost(kPairs, [&](int i) {
          return contact_between(g, BodyIndex{2 * i}, q[2 * i], BodyIndex{2 * i + 1}, q[2 * i + 1]).point.x();
        }));
  }
}

struct Path {
  Eigen::Vector3d q;
  Eigen::Vector3d v;
  Eigen::Vector3d operator()(double t) const {
    return {q.x() + t * v.x(), q.y() + t * (v.y() - 0.5 * 9.81 * t), q.z() + t * v.z()};
  }
};

// Over one second, b falling past a static a; half of the pairs touch.
void searches(ShapeKind a, ShapeKind b, double spin) {
  std::mt19937_64 random(1);
  std::vector<ConvexShape> list;
  std::vector<Path> paths;
  for (int i = 0; i < kPairs; ++i) {
    list.push_back(test::random_shape(random, a));
    list.push_back(test::random_shape(random, b));
    const double from = uniform(random, -3.0, 3.0);
    paths.push_back({{from, 3.0, uniform(random, -3.0, 3.0)},
                     {uniform(random, -1.0, 1.0) - from / 0.8, 0.0, uniform(random, -spin, spin)}});
  }
  const ConvexShapes s = convex_shapes(list);
  int samples = 0;
  int found = 0;
  const Pose kept{Vec2::Zero(), std::cos(0.3), std::sin(0.3)};
  const auto still = [&](double) { return kept; };
  const double ns = cost(kPairs, [&](int i) {
    const Path& path = paths[static_cast<std::size_t>(i)];
    const auto counted = [&](double t) { return ++samples, path(t); };
    const TurningPair pair(s, ShapeIndex{2 * i}, still, ShapeIndex{2 * i + 1}, counted, 9.81, 0.0,
                           path.v[2] * path.v[2]);
    const TurningSample first = pair(0.0);
    if (first.gap <= 0.0) return 0.0;
    const auto time =
        first_contact(pair, 0.0, first, 1.0, pair(1.0),
                      9.81 + turning_curvature(s.core_radius[ShapeIndex{2 * i + 1}], path.v[2], 0.0), 1e-14);
    found += time ? 1 : 0;
    return time.value_or(0.0);
  });
  fmt::print("{:>16} {:<16} {:6.0f} rad/s {:8.0f} ns {:6.1f} samples {:6.0f} % meet\n",
             test::kShapeNames[static_cast<int>(a)], test::kShapeNames[static_cast<int>(b)], spin, ns,
             samples / 20.0 / kPairs, 100.0 * found / 20.0 / kPairs);
}

void tell() {
  fmt::print("ns a call, angles' sines and cosines included\n{:>16} {:<16} {:>8} {:>8} {:>8}\n", "", "", "gap",
             "contact", "manifold");
  for (int a = 0; a < test::kShapeKinds; ++a) {
    for (int b = 0; b <= a && b < test::kShapeKinds - 1; ++b) queries(ShapeKind{a}, ShapeKind{b});
  }
  discs_and_boxes();
  fmt::print("first contact within 1 s under gravity\n");
  for (const double spin : {0.0, 3.0, 30.0}) {
    searches(ShapeKind::kDisc, ShapeKind::kDisc, spin);
    searches(ShapeKind::kBox, ShapeKind::kDisc, spin);
    searches(ShapeKind::kBox, ShapeKind::kBox, spin);
    searches(ShapeKind::kPolygon, ShapeKind::kRoundedPolygon, spin);
    searches(ShapeKind::kBox, ShapeKind::kCapsule, spin);
  }
}

}  // namespace
}  // namespace carom

int main() { carom::tell(); }
