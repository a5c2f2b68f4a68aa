#include "physics/ledger/ledger.h"

#include <gtest/gtest.h>

#include "physics/ledger/ledger_entries.h"

namespace carom {
namespace {

// A member that is in no list would be in no sum, table or file.
TEST(Ledger, ListsEachMemberOnce) {
  Ledger ledger;
  for (const EnergyEntry& entry : kEnergyEntries) ledger.*entry.value += 1.0;
  for (const MomentumEntry& entry : kMomentumEntries) {
    ledger.*entry.value += Vec2::Ones();
    ledger.*entry.angular += 1.0;
  }
  // All members by name: a new one does not compile here until it is among them.
  const auto& [e1, e2, e3, e4, e5, e6, e7, e8, e9, e10, e11, m1, m2, m3, m4, m5, a1, a2, a3, a4, a5] = ledger;
  for (const double energy : {e1, e2, e3, e4, e5, e6, e7, e8, e9, e10, e11}) EXPECT_EQ(energy, 1.0);
  for (const Vec2& momentum : {m1, m2, m3, m4, m5}) EXPECT_EQ(momentum, Vec2::Ones());
  for (const double angular : {a1, a2, a3, a4, a5}) EXPECT_EQ(angular, 1.0);
}

}  // namespace
}  // namespace carom
