#include <algorithm>
#include <set>
#include <utility>

#include "widgets/edit/driven.h"
#include "widgets/edit/inspected.h"

namespace carom {
namespace {

enum Kind { kMoves, kFixed, kDriven };

int kind_of(const Body& body) { return body.drive ? kDriven : body.fixed ? kFixed : kMoves; }

// A drive goes on as fast as the body moved, and a body as fast as its drive was.
Body of_kind(Body body, int kind) {
  const Vec2 velocity = body.drive ? body.drive->velocity : body.velocity;
  if (kind_of(body) == kind) return body;
  if (kind == kDriven) return driven(body, Drive{.velocity = velocity});
  body.fixed = kind == kFixed;
  body.drive.reset();
  body.velocity = kind == kMoves ? velocity : Vec2(Vec2::Zero());
  if (kind != kMoves) body.spin = 0.0;
  return body;
}

}  // namespace

InspectedRow inspected_kind(const std::vector<Body>& bodies) {
  std::set<int> kinds;
  for (const Body& body : bodies) kinds.insert(kind_of(body));
  InspectedChoice choice;
  choice.name = "Kind";
  choice.meaning = "Whether forces and impacts move it";
  choice.words = QStringList{"moves", "fixed", "driven"};
  choice.meanings = QStringList{"forces and impacts move it", "it never moves",
                                "it moves as its drive says, whatever it meets"};
  choice.chosen = kinds.size() == 1 ? *kinds.begin() : -1;
  choice.side_by_side = true;
  if (std::any_of(bodies.begin(), bodies.end(), [](const Body& body) { return is_half_plane(body.shape); }))
    choice.refusal = "A half-plane can only stand still.";
  choice.edits = [bodies](int kind) {
    const QString verb = kind == kMoves ? "Let %1 move" : kind == kFixed ? "Fix %1" : "Drive %1";
    return NamedEdits{edits_of(bodies, [kind](Body& body) { body = of_kind(std::move(body), kind); }),
                      verb.arg(subject_of(bodies))};
  };
  return {.choice = std::move(choice)};
}

}  // namespace carom
