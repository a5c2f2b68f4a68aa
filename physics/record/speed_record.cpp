#include "physics/record/speed_record.h"

namespace carom {

std::int64_t moment_stride(std::int64_t steps) {
  std::int64_t stride = 1;
  while (steps / stride >= kMostMoments) stride *= 2;
  return stride;
}

void SpeedRecord::clear() {
  now_.clear();
  masses_.clear();
  moments_.clear();
  ++version_;
}

void SpeedRecord::add(const SpeedMoment& moment) {
  if (!moments_.empty() && moment.step <= moments_.back().step) return;
  ++version_;
  moments_.push_back(moment);
  const std::int64_t stride = moment_stride(moment.step);
  std::erase_if(moments_, [stride](const SpeedMoment& m) { return m.step % stride != 0; });
}

void SpeedRecord::set_now(const State& state, const std::vector<Body>& bodies) {
  now_.clear();
  masses_.clear();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (has_infinite_mass(bodies[i]) || static_cast<int>(i) >= state.size()) continue;
    now_.push_back(state.velocity(static_cast<int>(i)).norm());
    masses_.push_back(mass_of(bodies[i]));
  }
}

std::vector<double> SpeedRecord::between(double from, double to) const {
  std::vector<double> all;
  for (const SpeedMoment& m : moments_) {
    if (m.time >= from && m.time <= to) all.insert(all.end(), m.speeds.begin(), m.speeds.end());
  }
  return all;
}

}  // namespace carom
