#include "physics/ledger/ledger.h"

#include <gtest/gtest.h>

#include "physics/ledger/ledger_entries.h"
#include "physics/ledger/notices.h"

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

// Each notice tells its first time and whom it is about, if people have names for bodies.
TEST(Notices, NameTheBodiesOfTheirFirstTime) {
  const auto name = [](BodyIndex body) { return body == 0 ? std::string("ball") : std::string("floor"); };
  for (const NoticeEntry& entry : notice_entries()) {
    Notices notices;
    EXPECT_EQ(notices.text(name), "ok");
    notices.note(entry.since, 1.5, {BodyIndex{0}, BodyIndex{1}});
    const std::string without = notices.text();
    EXPECT_NE(without, "ok") << entry.key;
    notices.note(entry.since, 2.5, {BodyIndex{1}, BodyIndex{0}});
    EXPECT_EQ(notices.*entry.since, 1.5) << entry.key;
    EXPECT_EQ(notices.text(name), without + " (ball and floor)");
    EXPECT_EQ(notices.brief(name), notices.brief() + " (ball and floor)");
  }
}

}  // namespace
}  // namespace carom
