#include "widgets/run/law_text.h"

#include <QCoreApplication>

namespace carom {
namespace {

QString translated(const char* text) { return QCoreApplication::translate("BeforeAfterTable", text); }

}  // namespace

QString text_of(NoTheory why) {
  switch (why) {
    case NoTheory::kNone:
      return {};
    case NoTheory::kJoints:
      return translated("A joint passes the impulse on to other bodies: no closed law for two bodies");
    case NoTheory::kMaterials:
      return translated("A body has several materials: which of them touched is not recorded");
    case NoTheory::kSlipStops:
      return translated("Friction stops the slip of this off-centre impact on the way: no closed law");
    case NoTheory::kFrictionAtOnce:
      return translated("Several contacts at once with friction: no closed law");
    case NoTheory::kRestitution:
      return translated("Contacts at once with different or lowered restitution: no closed law");
  }
  return {};
}

QString text_of(NoIntervalLaw why) {
  switch (why) {
    case NoIntervalLaw::kNone:
      return {};
    case NoIntervalLaw::kEdits:
      return translated("The scene was changed between A and B: no closed law");
    case NoIntervalLaw::kTouches:
      return translated("It touched another body between A and B: a closed law holds for the sums at most");
    case NoIntervalLaw::kJoints:
      return translated("A joint acts between A and B: no closed law");
    case NoIntervalLaw::kForces:
      return translated("Drag, springs, attraction or applied forces act between A and B: no closed law");
    case NoIntervalLaw::kWalls:
      return translated("A fixed or driven body was touched between A and B: it takes and gives");
    case NoIntervalLaw::kLosses:
      return translated("Impacts with e below 1, friction or sticking take kinetic energy between A and B");
  }
  return {};
}

}  // namespace carom
