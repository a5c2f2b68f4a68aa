#include "physics/check/part_costs.h"

#include <algorithm>
#include <ctime>

#include "physics/run/simulation.h"

namespace carom {
namespace {

constexpr int kPieces = 7;
constexpr double kPieceSeconds = 0.02;  // of CPU time
constexpr int kFewSteps = 3;            // of a piece, at least
constexpr double kLongEnough = 0.5;     // s of CPU time for one part: then no more pieces

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// s of CPU time a step, the mean over a piece of runs from the start to `until`.
double seconds_a_step(const RunSetup& setup, const Needs& needs, double until) {
  double spent = 0.0;
  int steps = 0;
  while (spent < kPieceSeconds || steps < kFewSteps) {
    Simulation run(setup, needs);
    const double began = cpu_seconds();
    double now = began;
    while (run.time() < until && !run.lost() && (now - began + spent < kPieceSeconds || steps < kFewSteps)) {
      run.step();
      ++steps;
      now = cpu_seconds();
    }
    spent += now - began;
    if (run.steps() == 0 || run.lost()) break;
  }
  return spent / std::max(steps, 1);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Variant {
  RunSetup setup;
  Needs needs;
};

}  // namespace

std::vector<PartCost> part_costs(const RunSetup& setup, double until) {
  const Needs needs = needs_of(setup.scene);
  std::vector<PartCost> costs;
  for (const PartEntry& entry : part_entries()) {
    PartCost cost{&entry, needs.has(entry.part), 0.0, std::nullopt};
    const Variant as_it_is{setup, needs};
    std::optional<Variant> other;
    if (!cost.needed) {
      other = as_it_is;
      other->needs.set(entry.part);
      if (entry.part == Part::kRestingContacts) other->setup.method.contacts = ContactsId::kLasting;
    } else if (entry.part == Part::kRestingContacts) {
      other = as_it_is;
      other->setup.method.contacts = ContactsId::kImpulse;
    } else if (entry.remove != nullptr) {
      other = as_it_is;
      other->setup.saved.reset();  // of another scene
      entry.remove(other->setup.scene);
      other->needs = needs_of(other->setup.scene);
    }
    // Pieces alternate, so that a change of the machine's speed affects both alike.
    std::vector<double> own, others;
    const double began = cpu_seconds();
    for (int piece = 0; piece < kPieces && (piece == 0 || cpu_seconds() - began < kLongEnough); ++piece) {
      own.push_back(seconds_a_step(as_it_is.setup, as_it_is.needs, until));
      if (other) others.push_back(seconds_a_step(other->setup, other->needs, until));
    }
    cost.with = median(own);
    if (other) cost.without = median(others);
    if (!cost.needed) std::swap(cost.with, *cost.without);
    costs.push_back(cost);
  }
  return costs;
}

}  // namespace carom
