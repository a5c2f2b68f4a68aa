#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "physics/collision/pair_contact.h"
#include "physics/contact/contact_rows.h"
#include "physics/contact/contacts.h"
#include "physics/model/convex.h"
#include "physics/step/contact_pressing.h"
#include "physics/step/near_pairs.h"
#include "physics/step/neighbours.h"
#include "physics/step/world.h"

namespace carom {

// Whether up to so many bodies, or groups of them, move that a step may be divided often.
[[nodiscard]] inline bool moves_few(const World& world) { return world.trajectories.islands().size() <= 16; }

// Sets bodies, normal, arms and gap of contact i; the bodies' positions are those of their centres.
void set_place(Contacts& c, int i, const BodyPair& pair, const Vec2& normal, const ManifoldPoint& at,
               const Vec2& of_a, const Vec2& of_b);

// m/s: the speed by which what lands is told from a contact that closes gently. Where few move it is an impact
// also without rebound; not if nothing rubs there, as then the forces of all contacts stop it at once.
[[nodiscard]] double landing_speed(const World& world, const SurfaceLaw& law, double closing);

// Whether a contact may open and close again within a step. Discs have no other corner that stays, and in a jam
// they would bounce on for ever: they may where few bodies move, unless they were pressed in the last step.
[[nodiscard]] bool may_bounce(const World& world, BodyIndex a, BodyIndex b, bool pressed);

// A contact point that closes too fast to rest, of a pair that is supported at other points. Also used for one
// that leaves and may come back, and for one that is kept.
struct Landing {
  BodyIndex a;
  BodyIndex b;
  std::uint32_t id = 0;  // of the manifold's point

  bool operator==(const Landing&) const = default;
};

// The index of a manifold's point with this feature; -1 if there is none.
[[nodiscard]] inline int point_with(const Manifold& m, std::uint32_t id) {
  for (int k = 0; k < m.count; ++k) {
    if (m.points[k].id == id) return k;
  }
  return -1;
}

// Where it is at the trajectories' start, if the manifold has that point.
[[nodiscard]] std::optional<Contact> contact_at_start(const World& world, const Landing& landing);

// The contacts that may press in a step; the other arrays are parallel to them.
struct FoundContacts {
  Contacts contacts;
  std::vector<std::uint32_t> id;       // of the manifold's point
  std::vector<Vec2> point;             // m
  std::vector<Eigen::Vector3d> guess;  // N, N and N m: at first the last forces
  std::vector<std::uint8_t> old;       // whether the contact had a force in the last step
  std::vector<double> press;           // m/s², see ContactPressing::between
  std::vector<double> rest;            // m/s, see ContactPressing::rest_speed
  // m: how much farther apart than the normal of now says both would be at the end, if they went straight on.
  std::vector<double> turned_away;
  // m/s, in the contacts' targets: what brings bodies back onto the surfaces that the step's method leaves.
  std::vector<double> returns;
  std::vector<Landing> landings;  // that may happen in this step
  // Pairs that close too fast to rest and whose impacts are not located in time; in rising order.
  std::vector<BodyPair> hits;

  void clear();
  // m: how far a contact may close along its normal.
  [[nodiscard]] double room(int i) const {
    return std::max(contacts.gap[i], 0.0) + turned_away[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] bool is_new(int i) const { return old[static_cast<std::size_t>(i)] == 0; }
};

// With impacts at their own time, what happens within a step is followed in scenes of up to so many contacts:
// new contacts begin when they close, and an impact changes the forces on what it hits at once.
inline constexpr int kFewContactsOfScene = 64;
// Of the change of a speed by forces in a step: a contact that slips slower than this sticks.
inline constexpr double kStuck = 1e-6;

// Finds which pairs may touch within a step, and where; what closes faster than it may rest is no contact but
// an impact.
class ContactFinder {
 public:
  // At the trajectories' start, for a part of h s of a step of step_length s. The targets are such that a
  // contact that is open by a gap g may close at g/h.
  void find(World& world, double step_length, double h, const ContactPressing& pressing,
            const ContactMemory& memory, FoundContacts& found);

  // For another part of a step: none of its contacts is kept yet. Impacts of bodies that press on others by
  // these forces are not located in it, unless they are fast: what would meet within the part meets at its
  // start.
  void begin_part(const World& world, std::span<const ContactForce> forces);
  // From now on in this part a contact that may press, though its bodies are leaving each other there.
  void keep(const Landing& contact) { kept_.push_back(contact); }
  [[nodiscard]] bool is_kept(const Landing& contact) const;

  // Pairs that may touch in this step, and supported pairs; each in rising order.
  [[nodiscard]] const std::vector<BodyPair>& near() const { return near_; }
  [[nodiscard]] const std::vector<BodyPair>& supported() const { return supported_; }
  // Bodies near each other, by body.
  [[nodiscard]] const Neighbours& neighbours() const { return neighbours_; }
  // Whether a contact supports these parts of the pair in this step; a < b.
  [[nodiscard]] bool supports(BodyIndex a, BodyIndex b, const ShapePair& parts) const;
  // Whether the pair is supported at one point and hits at another one, now: too fast to rest there.
  [[nodiscard]] bool is_hit(BodyIndex a, BodyIndex b) const;
  // Whether no impact of the pair in this part is to be searched, at the velocities of now: contacts keep it
  // apart until the part ends, or it is supported and moves so slowly that any touch rests.
  [[nodiscard]] bool needs_no_search(const World& world, BodyIndex a, BodyIndex b) const;

 private:
  struct Step {
    World& world;
    double length;  // s
    double h;       // s
    const ContactPressing& pressing;
    const ContactMemory& memory;
    FoundContacts& found;
  };
  struct PairInStep {
    BodyIndex a, b;
    const SurfaceLaw& material;
    bool located;      // its impacts are
    double rounding;   // m
    std::size_t last;  // its first force of the last step
  };
  struct Touch {
    enum Role { kLeft, kLanding, kContact };  // kLeft: to the event queue
    Role role = kLeft;
    RowVelocity velocity{};             // m/s
    double press = 0.0;                 // m/s², see ContactPressing::between
    double rest = 0.0;                  // m/s, see ContactPressing::rest_speed
    std::optional<std::size_t> before;  // its force in the last step
    bool pressed_before = false;
    bool slow = false;      // it may rest
    bool supports = false;  // though it may be no contact
    bool hits_now = false;
  };
  [[nodiscard]] Touch look_at(const Step& step, const PairInStep& pair, const Manifold& m, int k, int i) const;
  void support(BodyIndex a, BodyIndex b, const ShapePair& parts, double rest);
  void keep_apart(BodyIndex a, BodyIndex b);
  [[nodiscard]] bool is_located(const World& world, BodyIndex a, BodyIndex b, const SurfaceLaw& law) const;
  [[nodiscard]] bool is_supported(const World& world, BodyIndex a, BodyIndex b) const;
  [[nodiscard]] double stays_away(const Step& step, BodyIndex a, BodyIndex b, const Manifold& m, double gap,
                                  double closing, bool hits, double rounding) const;
  [[nodiscard]] double turned_away(const Step& step, BodyIndex a, BodyIndex b, const Manifold& m,
                                   double along_it, double rounding) const;
  [[nodiscard]] Manifold exposed(const Step& step, BodyIndex a, BodyIndex b, const Manifold& m);
  [[nodiscard]] Manifold where_tips_meet(const World& world, BodyIndex a, BodyIndex b, const Manifold& m) const;
  void add(const Step& step, BodyIndex a, BodyIndex b, const Manifold& m, double rounding, std::size_t last);

  void let_fast_bodies_push(World& world);

  NearPairs near_pairs_;
  Neighbours neighbours_;
  std::vector<BodyPair> near_;
  std::vector<std::tuple<BodyIndex, BodyIndex, ShapeIndex, ShapeIndex>> supported_parts_;  // in rising order
  std::vector<BodyPair> supported_;
  std::vector<Landing> kept_;
  std::vector<std::uint8_t> presses_;  // by body; empty: all impacts are located
  double part_ = 0.0;                  // s, of the step
  std::vector<BodyPair> kept_apart_;   // by contacts, until the part ends; in rising order
  std::vector<BodyPair> hit_;          // see is_hit()
  // m/s, parallel to supported_: the least rest speed of the pair's points.
  std::vector<double> supported_rest_;
  std::vector<Pose> poses_;
  std::vector<double> reach_;         // m: how far each body may move within a whole step
  std::vector<double> pushed_reach_;  // scratch
  std::vector<BodyIndex> staying_;    // likewise
};

}  // namespace carom
