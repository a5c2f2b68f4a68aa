#include "physics/collision/tip_on_face.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <optional>

#include "physics/collision/pair_contact.h"
#include "physics/model/geometry.h"
#include "tests/support/scenes.h"

// The contact of a corner with the line of a face, beside the shapes' own contact.
namespace carom {
namespace {

const BodyIndex kA{0};
const BodyIndex kB{1};

class TipOnFaceTest : public testing::Test {
 protected:
  // Two boxes, the second on the first: 2 m by 0.5 m, and 0.4 m by 0.2 m.
  TipOnFaceTest()
      : geometry_(geometry({test::box("table", {0.0, -0.25}, {0.0, 0.0}, 2.0, 0.5),
                            test::box("box", {0.0, 0.1}, {0.0, 0.0}, 0.4, 0.2)})) {}

  [[nodiscard]] const Geometry& g() const { return geometry_; }
  [[nodiscard]] Manifold touch(const Pose& table, const Pose& box) const {
    const double all = std::numeric_limits<double>::infinity();
    return manifold(g(), kA, g().first_part(kA), table, kB, g().first_part(kB), box, all);
  }

  Geometry geometry_;
};

Pose turned(double x, double y, double angle) { return {{x, y}, std::cos(angle), std::sin(angle)}; }

TEST_F(TipOnFaceTest, IsTheManifoldsPointWhileItIsOnTheFace) {
  for (const double x : {-1.05, -0.3, 0.0, 0.9, 1.1}) {
    for (const double angle : {-0.2, -1e-3, 0.0, 1e-3, 0.2}) {
      const Pose table = turned(0.3, -0.25, 0.1);
      const Pose box = turned(0.3 + x, 0.12 + 0.1 * x, 0.1 + angle);
      const Manifold m = touch(table, box);
      ASSERT_EQ(m.count, 2);
      for (int k = 0; k < m.count; ++k) {
        const Contact point = m.contact(k);
        const std::optional<TipOnFace> corner = tip_on_face(g(), kA, table, kB, box, m.points[k].id);
        ASSERT_TRUE(corner) << x << " " << angle << " " << k;
        const Contact line = contact_on_line(g(), kA, table, kB, box, *corner);
        // Along the normal of the other face the gap of a corner is another one.
        if ((line.normal - point.normal).norm() > 1e-12) continue;
        EXPECT_NEAR(line.gap, point.gap, 1e-15) << x << " " << angle << " " << k;
        EXPECT_LT((line.point - point.point).norm(), 1e-15) << x << " " << angle << " " << k;
      }
    }
  }
}

TEST_F(TipOnFaceTest, StaysOnTheLineBeyondTheEnd) {
  const Pose table = turned(0.0, -0.25, 0.0);
  const Pose box = turned(0.7, 0.1, 0.0);
  const Manifold m = touch(table, box);
  ASSERT_EQ(m.count, 2);
  for (int k = 0; k < m.count; ++k) {
    const std::optional<TipOnFace> corner = tip_on_face(g(), kA, table, kB, box, m.points[k].id);
    ASSERT_TRUE(corner);
    const double x = m.points[k].point.x();
    const Contact past = contact_on_line(g(), kA, table, kB, turned(1.7, 0.1, 0.0), *corner);
    EXPECT_EQ(past.normal, Vec2(0.0, 1.0));
    EXPECT_NEAR(past.gap, 0.0, 1e-16);
    EXPECT_NEAR(past.point.x(), x + 1.0, 1e-15) << "of the box's corner";
  }
}

TEST_F(TipOnFaceTest, IsOfTheFaceThatReachesFurther) {
  const Pose table = turned(0.0, -0.25, 0.0);
  const Pose box = turned(0.95, 0.1, 0.0);  // over the edge
  const Manifold m = touch(table, box);
  ASSERT_EQ(m.count, 2);
  for (int k = 0; k < m.count; ++k) {
    const std::optional<TipOnFace> corner = tip_on_face(g(), kA, table, kB, box, m.points[k].id);
    ASSERT_TRUE(corner);
    EXPECT_EQ(corner->is_of_b, m.points[k].point.x() < 0.9) << m.points[k].point.x();
  }
}

}  // namespace
}  // namespace carom
