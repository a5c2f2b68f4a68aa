#pragma once

#include <optional>
#include <span>

#include "physics/collision/pair_contact.h"
#include "physics/collision/tip_on_face.h"
#include "physics/model/pair_size.h"
#include "physics/step/contact_finder.h"
#include "physics/step/contact_turning.h"
#include "physics/step/world.h"

namespace carom {

// A body in a guessed flight.
struct Flown {
  BodyIndex body;
  Pose end;
  Eigen::Vector3d moved;  // m and rad
  Vec2 mean;              // m: where the arms of all forces on the body start
  bool goes_on;           // see GuessedFlight
};

// A contact at its end.
struct GuessedEnd {
  Vec2 point;  // m
  Vec2 normal;
  double gap = 0.0;  // m
};

// Whether one of these parts is round where they touch, and the other isn't a disc as well: the contact may
// turn far, about a corner.
[[nodiscard]] bool may_turn_far(const Geometry& g, const ShapePair& parts);

// Where the contacts of two bodies, which move against each other, are at the end of a guessed flight.
class ContactsAtEnd {
 public:
  // `others`: bodies near both.
  ContactsAtEnd(const World& world, const FoundContacts& found, const GuessedFlight& flight, const Flown& a,
                const Flown& b, std::span<const BodyIndex> others)
      : world_(world), found_(found), flight_(flight), a_(a), b_(b), others_(others) {}

  // For contact i, one of theirs; the contacts of the same two parts one after the other.
  void look(int i);
  // It in the same features, as a corner on the line of its face, which it has come to the end of or which goes
  // on as another part, as a corner that another edge faces, or as what has rolled on from a face to the round
  // corner beside it. Nothing if it is none of these.
  [[nodiscard]] std::optional<GuessedEnd> same() const;
  // It with the normal of now: its point moves with the disc, with the corner that slides on over a seam, or as
  // the bodies do on average.
  [[nodiscard]] GuessedEnd carried() const;

 private:
  [[nodiscard]] Pose pose(BodyIndex body) const { return flight_.pose[static_cast<std::size_t>(body)]; }
  [[nodiscard]] std::uint32_t id() const { return found_.id[static_cast<std::size_t>(contact_)]; }
  [[nodiscard]] const Vec2& start() const { return found_.point[static_cast<std::size_t>(contact_)]; }
  [[nodiscard]] double size() const { return pair_size(world_.shapes(), a_.body, b_.body); }
  [[nodiscard]] bool slides_on() const;
  [[nodiscard]] std::optional<Contact> on_line() const;
  [[nodiscard]] bool face_goes_on(const TipOnFace& touch, bool at_end) const;
  [[nodiscard]] bool is_same_corner(const ManifoldPoint& end) const;
  [[nodiscard]] bool has_rolled_on() const;
  [[nodiscard]] Vec2 moved_centre(const Flown& flown, ShapeIndex part) const;
  [[nodiscard]] double from_corner(BodyIndex body, ShapeIndex part) const;

  const World& world_;
  const FoundContacts& found_;
  const GuessedFlight& flight_;
  const Flown& a_;
  const Flown& b_;
  std::span<const BodyIndex> others_;
  int contact_ = -1;
  ShapePair parts_;
  // Where its parts touch: all points, and those where nothing continues a surface.
  Manifold all_, bare_;
};

}  // namespace carom
