#include "physics/ledger/ledger.h"

#include <cmath>

#include "physics/ledger/ledger_entries.h"

namespace carom {

double Ledger::turnover() const {
  double sum = 0.0;
  for (const EnergyEntry& entry : kEnergyEntries) sum += std::abs(this->*entry.value);
  return sum;
}

void Ledger::add(double share, const Ledger& other) {
  for (const EnergyEntry& entry : kEnergyEntries) this->*entry.value += share * other.*entry.value;
  for (const MomentumEntry& entry : kMomentumEntries) {
    this->*entry.value += share * other.*entry.value;
    this->*entry.angular += share * other.*entry.angular;
  }
}

double Ledger::expected() const {
  double sum = 0.0;
  for (const EnergyEntry& entry : kEnergyEntries) sum += entry.sign() * this->*entry.value;
  return sum;
}

Vec2 Ledger::expected_momentum() const {
  Vec2 sum = Vec2::Zero();
  for (const MomentumEntry& entry : kMomentumEntries) sum += entry.sign * this->*entry.value;
  return sum;
}

double Ledger::expected_angular_momentum() const {
  double sum = 0.0;
  for (const MomentumEntry& entry : kMomentumEntries) sum += entry.sign * this->*entry.angular;
  return sum;
}

Ledger ledger_of_quadratures(const State& state) {
  Ledger ledger;
  if (state.size() == 0) return ledger;
  // In the order of the bodies, whatever the number of rows.
  Eigen::Matrix<double, kQuadratures, 1> sums = state.quadratures.col(0);
  for (int i = 1; i < state.size(); ++i) sums += state.quadratures.col(i);
  ledger.lost_to_drag = sums[kDragLoss];
  ledger.lost_to_dampers = sums[kDamperLoss];
  ledger.put_in_by_drives = sums[kWorkIn];
  ledger.put_in_by_user = sums[kHandWork];
  ledger.momentum_from_forces = Vec2(sums[kImpulseX], sums[kImpulseY]);
  ledger.angular_momentum_from_forces = sums[kAngularImpulse];
  ledger.angular_momentum_from_gravity = sums[kGravityAngularImpulse];
  return ledger;
}

}  // namespace carom
