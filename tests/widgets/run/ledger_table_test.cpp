#include "widgets/run/ledger_table.h"

#include <gtest/gtest.h>

#include "physics/preset/preset.h"
#include "tests/support/run_fixture.h"

namespace carom {
namespace {

QString cell(const QTableView& table, int row, int column) {
  return table.model()->index(row, column).data().toString();
}
QString tip(const QTableView& table, int row, int column) {
  return table.model()->index(row, column).data(Qt::ToolTipRole).toString();
}

TEST(LedgerTable, ClosesOnTheDrift) {
  Preset preset = head_on_scene();
  Material dull;
  dull.restitution = 0.5;
  preset.scene.materials = {dull};
  LedgerTable table;
  table.update_from(run_to(preset, 0.5));
  ASSERT_EQ(table.model()->rowCount(), 14);
  EXPECT_EQ(cell(table, 0, 1), "4.500");
  EXPECT_EQ(cell(table, 1, 1), "2.250");  // (1 - e²)/2 · 2/3 kg · (3 m/s)²
  EXPECT_EQ(cell(table, 11, 1), "2.250");
  EXPECT_EQ(cell(table, 12, 1), "2.250");
  EXPECT_EQ(cell(table, 13, 0), "numerical drift");
}

// Every entry is in the row of its name.
TEST(LedgerTable, HasEveryEntryOfTheLedger) {
  Frame frame = run_to(head_on_scene(), 0.1);
  frame.ledger.initial = 100.0;
  frame.ledger.lost_to_restitution = 1.0;
  frame.ledger.lost_to_friction = 2.0;
  frame.ledger.lost_to_rolling = 2.5;
  frame.ledger.lost_to_drag = 3.0;
  frame.ledger.lost_to_dampers = 4.0;
  frame.ledger.lost_to_sticking = 4.25;
  frame.ledger.lost_to_joints = 4.5;
  frame.ledger.penetration_correction = 5.0;
  frame.ledger.put_in_by_drives = 6.0;
  frame.ledger.put_in_by_user = 7.0;
  frame.ledger.initial_momentum = Vec2(10.0, 20.0);
  frame.ledger.momentum_from_gravity = Vec2(0.0, -1.0);
  frame.ledger.momentum_from_forces = Vec2(2.0, 0.0);
  frame.ledger.momentum_from_user = Vec2(3.0, 0.0);
  frame.ledger.momentum_to_walls = Vec2(4.0, 5.0);
  frame.ledger.initial_angular_momentum = 30.0;
  frame.ledger.angular_momentum_from_gravity = -1.5;
  frame.ledger.angular_momentum_from_forces = 8.0;
  frame.ledger.angular_momentum_from_user = 9.0;
  frame.ledger.angular_momentum_to_walls = 5.5;
  frame.totals = {};
  frame.totals.potential = 110.0;
  frame.totals.momentum = Vec2(12.0, 14.0);
  frame.totals.angular_momentum = 42.0;
  LedgerTable table;
  table.update_from(frame);
  const QStringList rows[] = {
      {"initial", "100.0", "", "initial", "10.00", "20.00", "30.00"},
      {"lost to restitution", "1.000", "", "from gravity", "0", "−1.000", "−1.500"},
      {"lost to friction", "2.000", "", "from forces", "2.000", "0", "8.000"},
      {"lost to rolling", "2.500", "", "from the user", "3.000", "0", "9.000"},
      {"lost to sticking", "4.250", "", "to walls", "4.000", "5.000", "5.500"},
      {"lost to drag", "3.000", "", "", "", "", ""},
      {"lost to dampers", "4.000", "", "", "", "", ""},
      {"lost to links", "4.500", "", "", "", "", ""},
      {"overlap correction", "5.000", "", "", "", "", ""},
      {"put in by drives", "6.000", "", "", "", "", ""},
      {"put in by hand", "7.000", "", "", "", "", ""},
      {"expected energy", "96.75", "", "expected momentum", "11.00", "14.00", "40.00"},
      {"energy now", "110.0", "", "momentum now", "12.00", "14.00", "42.00"},
      {"numerical drift", "13.25", "", "numerical drift", "1.000", "0", "2.000"},
  };
  for (int row = 0; row < 14; ++row) {
    for (int column = 0; column < 7; ++column) {
      EXPECT_EQ(cell(table, row, column), rows[row][column]) << row << ", " << column;
    }
  }
}

TEST(LedgerTable, IdleEntriesArePaleAndSaySoButAreThere) {
  Preset preset = head_on_scene();
  LedgerTable table;
  const Frame frame = run_to(preset, 0.1);
  table.update_from(frame);
  table.set_scene(preset);
  const auto idle = [&](int row, int column) {
    return static_cast<const FigureModel*>(table.model())->is_idle(row, column);
  };
  EXPECT_FALSE(idle(1, 0)) << "restitution";
  for (const int row : {2, 3, 4, 5, 6, 7, 9}) {
    EXPECT_TRUE(idle(row, 0)) << row;
    EXPECT_TRUE(tip(table, row, 1).endsWith("Nothing in this scene can change it.")) << row;
    EXPECT_EQ(cell(table, row, 1), "0");
  }
  EXPECT_TRUE(idle(1, 4)) << "gravity";
  EXPECT_TRUE(idle(4, 4)) << "walls";

  preset.scene.forces.quadratic_drag = 0.1;
  preset.scene.forces.gravity = Vec2(0.0, -9.81);
  Spring spring;
  spring.body = "A";
  spring.to = "B";
  spring.damping = 1.0;
  preset.scene.forces.springs = {spring};
  Joint string;
  string.kind = JointKind::kString;
  string.body = "A";
  string.to = "B";
  preset.scene.joints = {string};
  preset.scene.materials = {{"default", 1.0, 0.0, 0.5, 0.5}};
  Material pair = preset.scene.materials[0];
  pair.rolling_resistance = 0.01;
  pair.sticks = true;
  preset.scene.pairs = {{"default", "default", pair}};
  preset.scene.bodies[1].drive = Drive{.velocity = Vec2(1.0, 0.0)};
  table.set_scene(preset);
  EXPECT_TRUE(idle(3, 0)) << "impulses alone don't resist rolling";
  preset.method.contacts = ContactsId::kLasting;
  table.set_scene(preset);
  for (int row = 0; row < 14; ++row) EXPECT_FALSE(idle(row, 0) || idle(row, 3)) << row;

  // What was lost before the drag was taken away stays plain.
  Frame dragged = frame;
  dragged.ledger.lost_to_drag = 0.5;
  table.update_from(dragged);
  table.set_scene(head_on_scene());
  EXPECT_FALSE(idle(5, 0));
}

TEST(LedgerTable, TooltipsExplainAndHaveAllDigits) {
  LedgerTable table;
  table.update_from(run_to(head_on_scene(), 0.1));
  EXPECT_TRUE(tip(table, 13, 0).contains("what the method itself gained or lost"));
  EXPECT_TRUE(tip(table, 0, 1).startsWith("4.5\n"));
  for (int row = 0; row < 14; ++row) EXPECT_GT(tip(table, row, 0).size(), cell(table, row, 0).size());
}

}  // namespace
}  // namespace carom
