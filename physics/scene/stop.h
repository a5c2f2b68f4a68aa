#pragma once

#include <string>
#include <string_view>

namespace carom {

enum class StopKind { kTime, kImpact, kEveryImpact, kPassing, kRest, kKineticEnergy };
enum class StopQuantity { kX, kY, kAngle, kSpeed };
enum class PassingWay { kEither, kUpwards, kDownwards };

// A moment at which a run is to stop. Members beside the kind hold for the kinds that are named.
struct Stop {
  StopKind kind = StopKind::kTime;
  double time = 0.0;  // s, kTime
  int number = 1;     // kImpact: 1 is the first impact after the beginning of the run
  // kImpact and kEveryImpact: one of the two bodies of the impact, and the other one; empty: any. kPassing: the
  // body that passes.
  std::string body;
  std::string with;
  bool with_wall = false;  // the other one is any body that is fixed or driven
  // kPassing: when the quantity of the body comes to `value`.
  StopQuantity quantity = StopQuantity::kX;
  double value = 0.0;  // m, rad or m/s
  PassingWay way = PassingWay::kEither;
  double below = 0.0;  // J, kKineticEnergy: when the kinetic energy of all bodies falls below it

  bool operator==(const Stop&) const = default;
};

// The sentence that tells it, such as "at the 3rd impact of A with a wall": people write and read it.
[[nodiscard]] std::string sentence_of(const Stop& stop);

// The stop that a sentence tells; sentence_of() it gives the same stop, to the last bit of every number. Throws
// SceneError, one line that begins with `place` and says what is allowed.
[[nodiscard]] Stop stop_of(const std::string& place, std::string_view sentence);

}  // namespace carom
