#include "physics/measure/recorder.h"

#include <algorithm>
#include <cmath>

#include "physics/world/thinning.h"

namespace carom {

void Recorder::clear() {
  samples_.clear();
  impacts_.clear();
  scales_ = {};
  complete_ = true;
}

void Recorder::add(const Frame& frame) {
  if (frame.run != run_) {
    clear();
    run_ = frame.run;
  }
  if (frame.bodies != nullptr && frame.bodies != bodies_) {
    bodies_ = frame.bodies;
    mass_ = 0.0;
    for (const Body& body : *bodies_) {
      if (!is_immovable(body)) mass_ += mass_of(body);
    }
  }
  for (const Sample& sample : frame.samples) {
    const double kinetic = sample.totals.kinetic();
    scales_.energy = std::max(scales_.energy, kinetic + std::abs(sample.totals.potential));
    scales_.momentum = std::max(scales_.momentum, std::sqrt(2.0 * mass_ * kinetic));
  }
  for (const ImpactRecord& impact : frame.impacts) {
    scales_.impulse = std::max(scales_.impulse, impact.normal_impulse);
  }
  samples_.insert(samples_.end(), frame.samples.begin(), frame.samples.end());
  impacts_.insert(impacts_.end(), frame.impacts.begin(), frame.impacts.end());
  const bool whole = thin(samples_) && frame.complete;
  complete_ = thin(impacts_) && whole && complete_;
}

}  // namespace carom
