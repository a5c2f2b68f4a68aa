#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "physics/run/checkpoint.h"
#include "physics/run/scene_now.h"
#include "physics/run/simulation.h"
#include "physics/run/simulation_parts.h"
#include "physics/scene/drive.h"
#include "physics/scene/edit_rules.h"

// A run takes an edit as if it had been saved as it stands, its scene edited, and it went on: a new simulation
// of the edited scene, with what a checkpoint keeps carried over.
namespace carom {
namespace {

// Parts of a run without an id, welds that the run made, get one from here on meanwhile.
constexpr std::uint32_t kFirstOwn = 0x8000'0000;

template <class Part>
void number(std::vector<Part>& list) {
  std::uint32_t next = kFirstOwn;
  for (Part& part : list) {
    if (part.id.number == 0) part.id.number = next++;
  }
}

template <class Part>
void forget_numbers(std::vector<Part>& list) {
  for (Part& part : list) {
    if (part.id.number >= kFirstOwn) part.id.number = 0;
  }
}

// Of each part its place in the list before, or -1: a part that was added, or was replaced and so starts anew.
template <class Part>
std::vector<int> places_before(const std::vector<Part>& before, const std::vector<Part>& after,
                               const std::unordered_set<std::uint32_t>& anew = {}) {
  std::unordered_map<std::uint32_t, int> known;
  for (std::size_t i = 0; i < before.size(); ++i) known.emplace(before[i].id.number, static_cast<int>(i));
  std::vector<int> places;
  for (const Part& part : after) {
    const auto found = known.find(part.id.number);
    places.push_back(found == known.end() || anew.contains(part.id.number) ? -1 : found->second);
  }
  return places;
}

// The numbers of the replaced parts of a kind.
template <class Part>
std::unordered_set<std::uint32_t> replaced(const SceneEdits& edits) {
  std::unordered_set<std::uint32_t> numbers;
  for (const SceneEdit& edit : edits) {
    if (const auto* replace = std::get_if<Replace<Part>>(&edit)) numbers.insert(replace->part.id.number);
  }
  return numbers;
}

// Gives the new version of a body the place and motion that the old one has at this time.
void keep_motion(const Body& was, double time, Body& now) {
  const Body moved = moved_by_drive(was, time);
  now.angle = moved.angle;
  now.velocity = has_infinite_mass(now) ? Vec2(Vec2::Zero()) : moved.velocity;
  now.spin = has_infinite_mass(now) ? 0.0 : moved.spin;
  now.position = moved.position;
  if (now.drive) now.position -= drive_position(*now.drive, Vec2::Zero(), time);
  if (now.drive && was.drive && *now.drive == *was.drive) now.position = was.position;
}

// What a joint leaves open it takes from its old version.
void keep_lengths(const Joint& was, Joint& now) {
  if (now.kind != was.kind) return;
  if (!now.length) now.length = was.length;
  if (!now.angle) now.angle = was.angle;
}

// Makes an edit in a running scene: bodies keep their motion, and the welds that the run made follow their
// bodies. The bodies of generators have been made: an edit of a generator is for the next start.
void apply_in_run(Scene& scene, double time, SceneEdit edit) {
  const bool of_a_generator = std::visit(
      []<class E>(const E&) {
        return std::is_same_v<E, Add<GridGenerator>> || std::is_same_v<E, Replace<GridGenerator>> ||
               std::is_same_v<E, Remove<GridGenerator>>;
      },
      edit);
  if (of_a_generator) return;
  std::string old_name;
  std::string new_name;  // empty: gone
  if (auto* body = std::get_if<Replace<Body>>(&edit)) {
    if (const Body* was = part_of(scene.bodies, body->part.id)) {
      keep_motion(*was, time, body->part);
      old_name = was->name;
      new_name = body->part.name;
    }
  } else if (const auto* gone = std::get_if<Remove<Body>>(&edit)) {
    if (const Body* was = part_of(scene.bodies, gone->id)) old_name = was->name;
  } else if (auto* joint = std::get_if<Replace<Joint>>(&edit)) {
    if (const Joint* was = part_of(scene.joints, joint->part.id)) keep_lengths(*was, joint->part);
  }
  apply_edit(scene, edit);
  if (old_name == new_name) return;
  std::erase_if(scene.joints, [&](Joint& weld) {
    if (weld.id.number < kFirstOwn) return false;
    for (std::string* end : {&weld.body, &weld.to}) {
      if (*end != old_name) continue;
      if (new_name.empty()) return true;
      *end = new_name;
    }
    return false;
  });
}

template <class T>
void carry(const std::vector<int>& places, const std::vector<T>& before, std::vector<T>& now) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i] >= 0) now[i] = before[static_cast<std::size_t>(places[i])];
  }
}

// Where parts that were at a place stand now; -1: gone.
std::vector<int> inverse(const std::vector<int>& places_before, std::size_t count_before) {
  std::vector<int> places(count_before, -1);
  for (std::size_t i = 0; i < places_before.size(); ++i) {
    if (places_before[i] >= 0) places[static_cast<std::size_t>(places_before[i])] = static_cast<int>(i);
  }
  return places;
}

// The pair with the bodies' new places; false if one of them is gone.
template <class Pair>
bool move_pair(const std::vector<int>& places, Pair& pair) {
  pair.a = BodyIndex{places[static_cast<std::size_t>(pair.a)]};
  pair.b = BodyIndex{places[static_cast<std::size_t>(pair.b)]};
  return pair.a >= 0 && pair.b >= 0;
}

template <class Pair>
void move_pairs(const std::vector<int>& places, std::vector<Pair>& pairs) {
  std::erase_if(pairs, [&](Pair& pair) { return !move_pair(places, pair); });
}

// Where the hand of the scene is then, if the edits move it and nothing else.
std::optional<Vec2> moved_hand(const Scene& scene, const SceneEdits& edits) {
  const auto* set = edits.size() == 1 ? std::get_if<SetHand>(edits.data()) : nullptr;
  if (set == nullptr || !set->hand || !scene.forces.hand) return std::nullopt;
  Hand same = *scene.forces.hand;
  same.place = set->hand->place;
  return same == *set->hand ? std::optional(same.place) : std::nullopt;
}

}  // namespace

void Simulation::apply(const SceneEdits& edits) {
  if (lost_ || edits.empty()) return;
  if (const auto place = moved_hand(compiled_->scene, edits)) return move_hand(*place);
  const Checkpoint before = checkpoint();
  const Totals totals_before = totals();
  Scene was = scene_now(*this);
  number(was.bodies);
  number(was.joints);
  number(was.forces.springs);
  Scene scene = was;
  for (const SceneEdit& edit : edits) apply_in_run(scene, time(), edit);

  const std::vector<int> bodies_before = places_before(was.bodies, scene.bodies);
  const std::vector<int> joints_before = places_before(was.joints, scene.joints, replaced<Joint>(edits));
  const std::vector<int> springs_before =
      places_before(was.forces.springs, scene.forces.springs, replaced<Spring>(edits));
  const std::vector<int> bodies_now = inverse(bodies_before, was.bodies.size());
  forget_numbers(scene.bodies);
  forget_numbers(scene.joints);
  forget_numbers(scene.forces.springs);
  const Needs needs = this->needs().untrimmed ? this->needs() : needs_of(scene);
  Simulation next({std::move(scene), method(), SavedRun{.time = time()}}, needs);

  Checkpoint carried = next.checkpoint();
  carried.steps = before.steps;
  carried.sums = before.sums;
  move_pairs(bodies_now, carried.sums.impact_counts.pairs);
  for (NoticeBodies& of : carried.sums.notices.bodies) {
    if (of.a >= 0 && !move_pair(bodies_now, of)) of = {};
    if (of.a > of.b) std::swap(of.a, of.b);
  }
  carried.evaluations = before.evaluations;
  carried.rejected_steps = before.rejected_steps;
  carry(springs_before, before.engaged, carried.engaged);
  carry(joints_before, before.taut, carried.taut);
  carry(joints_before, before.released_at, carried.released_at);
  carry(bodies_before, before.next_step, carried.next_step);
  carried.waiting = before.waiting;
  move_pairs(bodies_now, carried.waiting);
  carried.contacts.clear();
  carried.support.clear();
  for (std::size_t i = 0; i < before.contacts.size(); ++i) {
    ContactForce force = before.contacts[i];
    if (!move_pair(bodies_now, force)) continue;
    carried.contacts.push_back(force);
    carried.support.push_back(before.support[i]);
  }

  const Totals totals_now = next.totals();
  Ledger& ledger = carried.sums.ledger;
  ledger.put_in_by_user += totals_now.energy() - totals_before.energy();
  ledger.momentum_from_user += totals_now.momentum - totals_before.momentum;
  ledger.angular_momentum_from_user += totals_now.angular_momentum - totals_before.angular_momentum;
  next.go_on_from(carried);
  next.parts_->world.clock = parts_->world.clock;
  next.parts_->world.work = parts_->world.work;
  next.parts_->world.log.records_jumps = parts_->world.log.records_jumps;
  next.edits_ = edits_;
  next.edits_applied_ = edits_applied_;
  *this = std::move(next);
}

}  // namespace carom
