#include "tests/peers/measure.h"

#include <utility>

namespace carom::peers {

double speed(const Motion& m) { return std::hypot(m.vx, m.vy); }

double kinetic_energy(const Scene& scene, const std::vector<Motion>& motions) {
  double energy = 0.0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Motion& m = motions[i];
    energy += 0.5 * mass(scene.bodies[i]) * (m.vx * m.vx + m.vy * m.vy);
    energy += 0.5 * inertia(scene.bodies[i]) * m.spin * m.spin;
  }
  return energy;
}

double rms_speed(const Scene& scene, const std::vector<Motion>& motions) {
  double square = 0.0;
  int moving = 0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (scene.bodies[i].density == 0.0) continue;
    square += motions[i].vx * motions[i].vx + motions[i].vy * motions[i].vy;
    ++moving;
  }
  return std::sqrt(square / moving);
}

Penetrations disc_penetrations(const Scene& scene, const std::vector<Motion>& motions, double radius,
                               const Container& container) {
  const double r = radius;
  std::vector<std::pair<double, double>> centres;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (scene.bodies[i].density > 0.0) centres.emplace_back(motions[i].x, motions[i].y);
  }
  std::sort(centres.begin(), centres.end());
  double largest = 0.0;
  double sum = 0.0;
  long pairs = 0;
  const auto add = [&](double overlap) {
    if (overlap < 0.0) return;
    largest = std::max(largest, overlap);
    sum += overlap;
    ++pairs;
  };
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const auto [x, y] = centres[i];
    add(container.left + r - x);
    add(x + r - container.right);
    add(container.floor + r - y);
    for (std::size_t j = i + 1; j < centres.size() && centres[j].first - x < 2.0 * r; ++j)
      add(2.0 * r - std::hypot(centres[j].first - x, centres[j].second - y));
  }
  return {largest, pairs > 0 ? sum / static_cast<double>(pairs) : 0.0};
}

}  // namespace carom::peers
