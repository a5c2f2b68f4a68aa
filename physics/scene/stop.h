#pragma once

#include <array>
#include <string>
#include <string_view>

#include "physics/scene/fields.h"
#include "physics/scene/named.h"

namespace carom {

enum class StopKind { kTime, kImpact, kEveryImpact, kPassing, kRest, kKineticEnergy };
enum class StopQuantity { kX, kY, kAngle, kSpeed };
enum class PassingWay { kEither, kUpwards, kDownwards };

inline constexpr auto kStopNames = std::to_array<Named<StopKind>>({
    {StopKind::kTime, "time"},
    {StopKind::kImpact, "impact"},
    {StopKind::kEveryImpact, "every-impact"},
    {StopKind::kPassing, "passing"},
    {StopKind::kRest, "rest"},
    {StopKind::kKineticEnergy, "kinetic-energy"},
});

inline constexpr auto kStopQuantityNames = std::to_array<Named<StopQuantity>>({
    {StopQuantity::kX, "x"},
    {StopQuantity::kY, "y"},
    {StopQuantity::kAngle, "angle"},
    {StopQuantity::kSpeed, "speed"},
});

inline constexpr auto kPassingWayNames = std::to_array<Named<PassingWay>>({
    {PassingWay::kEither, "either"},
    {PassingWay::kUpwards, "upwards"},
    {PassingWay::kDownwards, "downwards"},
});

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

// Whose impact a run stops at.
template <class V>
void partner_fields(V& v, Is<Stop> auto& stop) {
  v.field({"body", "the name of one of the two bodies; without it any"}, stop.body, kPerhapsNameLength);
  v.field({"with", "the name of the other one; without it any"}, stop.with, kPerhapsNameLength);
  v.field({"with_wall", "the other one is fixed or driven"}, stop.with_wall);
  v.together(
      {KeysTogether::Rule::kNotBoth, "with", "with_wall", "", "a wall beside a name", "either of the two"});
}

template <class V>
void fields(V& v, Is<Stop> auto& stop) {
  v.cases({"type", "what the run stops at"}, words_of(kStopNames), index_of(kStopNames, stop.kind),
          [&](std::size_t i, V& k) {
            const StopKind kind = kStopNames[i].id;
            k.chosen(stop.kind, kind);
            if (kind == StopKind::kTime) k.required({"time", "when"}, stop.time, from_zero("s"));
            if (kind == StopKind::kImpact)
              k.required({"number", "1: the first one of the run"}, stop.number, Whole{1, 1e9});
            if (kind == StopKind::kImpact || kind == StopKind::kEveryImpact) partner_fields(k, stop);
            if (kind == StopKind::kKineticEnergy)
              k.required({"below", "which the kinetic energy falls"}, stop.below, positive("J"));
            if (kind != StopKind::kPassing) return;
            k.required({"body", "the name of the body that passes"}, stop.body, kNameLength);
            k.choice({"quantity", "of the body"}, kStopQuantityNames, stop.quantity);
            k.keep({"quantity"});
            k.required({"value", "in m, rad or m/s"}, stop.value, any_number(""));
            k.choice({"way", "in which the value passes"}, kPassingWayNames, stop.way);
          });
}

}  // namespace carom
