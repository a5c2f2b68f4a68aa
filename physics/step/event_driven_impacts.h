#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "physics/collision/cell_grid.h"
#include "physics/step/contact_search.h"
#include "physics/step/event_queue.h"
#include "physics/step/impact_cluster.h"
#include "physics/step/pair_list.h"
#include "physics/step/penetrations.h"
#include "physics/step/resting_contacts.h"
#include "physics/step/schedule_state.h"
#include "physics/step/world.h"

namespace carom {

// Impacts at their own time. Each body, or each group of bodies that forces couple, has its own time, that of
// its last impact, and a trajectory from there on (physics/dynamics/trajectories.h). The first contact of two
// trajectories is found on the integrator's own map (contact_search.h), and the earliest contact of all is
// resolved. Only the bodies of an impact change, and only their neighbours are searched again. The state at
// an impact is a true step of the method, so the integrator keeps its order through impacts. Impacts of one
// body with several others at the same time are resolved at once, and with them all that touch if the scene
// says so (impacts_of_a_moment.cpp). The search is in impact_schedule.cpp.
//
// Fixed-step integrators rebuild every trajectory after each step. The adaptive integrator and exact flight
// need no common step: their trajectories continue across it, and the step is only the interval between two
// looks at the state.
class EventDrivenImpacts {
 public:
  // A step of h s. `resting` is null without resting contacts; with them every trajectory is rebuilt in each
  // step, which is divided where a body comes to rest on a support.
  void step(World& world, RestingContacts* resting, double h);
  // For a change of bodies, islands or method: the next step starts from the state alone.
  void reset(int bodies);
  // Pending events, if trajectories continue across steps.
  [[nodiscard]] std::optional<ScheduleState> ahead(const World& world) const;
  // Impacts before the last one at the same time.
  [[nodiscard]] int at_once() const { return at_once_; }
  // Pairs that overlap, or that forces press together, and are resolved at the next step's end.
  [[nodiscard]] const std::vector<WaitingPair>& waiting() const { return end_of_step_.all(); }
  void restore(int bodies, int at_once, std::span<const WaitingPair> waiting,
               const std::optional<ScheduleState>& ahead);

 private:
  // The step under way, or the part of it that starts with a support.
  struct Step {
    World& world;
    RestingContacts* resting;
    double h;                    // s
    double horizon;              // s after the epoch: where trajectories end, infinite if they continue
    std::int64_t impacts_begin;  // counted before the whole step
    bool may_divide = false;
    bool lands_first = false;  // while impacts are searched at the start of a part that a landing ends
  };

  [[nodiscard]] static bool trajectories_run_on(const World& world, const RestingContacts* resting);
  double process_with_supports(Step& step);
  void begin_part(const Step& step, bool may_divide, bool hit);
  // Whether a part of the step ends at this time (s after the epoch) if supports change then.
  [[nodiscard]] static bool may_end_at(const Step& step, double time);
  // Resolves events up to `target` (s after the epoch), except the landings awaited there. Returns the time
  // of a support that divides the step; everything before it is done.
  std::optional<double> process_until(const Step& step, double target, bool awaits_landing = false);
  // Takes the next event off the queue, and with an impact all others of its moment, as far as it can be told:
  // what they set off comes after them all. Fills moment_, the first at the back.
  void find_moment(const Step& step);
  // Resolves the impact of a scheduled pair. True if it starts a support that divides the step.
  bool resolve(const Step& step, BodyIndex a, BodyIndex b, double time, bool guarded);
  [[nodiscard]] bool may_be_several(const World& world, BodyIndex a, BodyIndex b) const;
  // As resolve(), at one contact, where both bodies are there and nothing else closes with it.
  bool resolve_alone(const Step& step, BodyIndex a, BodyIndex b, const Contact& contact, double time,
                     bool guarded);
  // As resolve(), with all that closes at this time too, or with all that touches if the scene says so. Nothing
  // if that is the pair alone, or if there is no solution.
  std::optional<bool> resolve_at_once(const Step& step, BodyIndex a, BodyIndex b, double time);
  // Fills cluster_ with the touches of the pairs of this moment that share bodies.
  void find_closing(const Step& step, BodyIndex a, BodyIndex b, double time);
  // Adds to moment_ what closes at the end of all trajectories, behind which nothing is scheduled, if contacts
  // connect it with this impact.
  void add_unscheduled(const Step& step, const Event& first);
  bool find_of_clay(const Step& step, BodyIndex a, BodyIndex b, double time);
  void find_due(const Step& step, BodyIndex a, BodyIndex b, double time);
  [[nodiscard]] static double end_of_moment(const Step& step, const Event& impact, double time);
  // s after the epoch: until when impacts are at the moment that has disturbed supports; infinite without one.
  [[nodiscard]] double end_of_disturbed(const Step& step) const;
  // Fills cluster_ with the touches of all bodies in contact with a or b, directly or through others.
  void find_touching(const Step& step, BodyIndex a, BodyIndex b, double time);
  bool find_touches(const Step& step, BodyIndex a, BodyIndex b, double time);
  // After an impact with e < 1: decides whether the pair rests from now on or has collapsed; `rests`: all of
  // its bounces were lost at once. Returns the same as resolve().
  bool classify_rebound(const Step& step, BodyIndex a, BodyIndex b, const Contact& contact, bool rests,
                        double time, bool guarded);
  [[nodiscard]] bool comes_to_rest(const Step& step, BodyIndex a, BodyIndex b, const Contact& contact) const;
  void note_disturbed(const Step& step, BodyIndex a, BodyIndex b, double time);
  void count_at_once(World& world, BodyIndex a, BodyIndex b, double time);
  void resolve_end_of_step(const Step& step, double target);

  void choose_cells(const World& world, double horizon);
  // Rebuilds all trajectories and empties the schedule; search_all() fills it.
  void rebuild_all(const Step& step);
  void search_all(const Step& step);
  // Rebuilds an island's trajectory and puts the bounds of its path into the grid.
  void rebuild(const Step& step, IslandIndex island);
  // Rebuilds these islands and schedules their next impacts.
  void rebuild_and_search(const Step& step, std::span<const IslandIndex> islands);
  void search_island(const Step& step, IslandIndex island);
  [[nodiscard]] SearchRules search_rules(const Step& step,
                                         double from = -std::numeric_limits<double>::infinity()) const;
  void search(const Step& step, const SearchRules& rules, BodyIndex a, BodyIndex b);
  void schedule(const Step& step, BodyIndex a, BodyIndex b, const NextContact& next);
  std::optional<ShapePair> parts_that_meet(const Step& step, BodyIndex a, BodyIndex b, double time);
  [[nodiscard]] double closing_share() const;
  [[nodiscard]] bool is_stale(const Event& event) const {
    return stamp_[event.a] != event.stamp_a || (event.b >= 0 && stamp_[event.b] != event.stamp_b);
  }

  bool running_ = false;           // trajectories, grid and queue are valid from the last step
  double reach_ = 1.0;             // m: length of a trajectory that no step ends
  double epoch_length_ = 1.0;      // s, a power of two
  double last_impact_ = -1.0;      // s within the epoch
  int at_once_ = 0;                // impacts before it at the same time
  std::int64_t at_once_work_ = 0;  // in this step, see impacts_of_a_moment.cpp
  CellGrid grid_;
  EventQueue queue_;
  std::vector<std::uint32_t> stamp_;  // by body, that of its island; constant for static bodies
  PairList end_of_step_;
  PairList resolving_;
  std::vector<IslandIndex> resolving_islands_;  // of resolving_, if trajectories continue across steps
  ArrayOf<IslandIndex, std::uint8_t> is_resolving_;
  int trajectory_ends_ = 0;  // in this step
  double stretch_ = 1.0;     // of trajectories that no step ends, if too many ended
  ImpactCluster cluster_;
  std::vector<BodyIndex> reached_;  // bodies of a cluster, as they are found
  std::vector<Event> moment_;
  std::vector<Event> later_;         // than a moment, if little
  std::optional<double> disturbed_;  // s after the epoch: when an impact has disturbed supports in this part
  std::vector<BodyPair> due_;
  std::vector<Contact> found_;
  std::vector<BodyIndex> near_;  // bodies near an impact
  PenetrationScratch penetrations_;
};

}  // namespace carom
