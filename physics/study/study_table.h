#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "physics/compare/comparison.h"
#include "physics/scene/method.h"
#include "physics/scene/scene.h"

namespace carom {

// The parameter that the error of a method depends on: the tolerance of the adaptive integrator, none for
// exact flight. With resting contacts it is the step for every method, because contact forces are found for a
// whole step.
enum class ErrorParameter { kStep, kTolerance, kNone };
[[nodiscard]] ErrorParameter error_parameter(const Method& method);

// One run of a study against the reference. Errors are NaN if there is nothing to compare.
struct StudyRow : Comparison {
  int index = 0;  // in the plan, from 0
  Method method;
  std::int64_t steps = 0;  // up to the compared time, as all that follows
  std::int64_t evaluations = 0;
  std::int64_t rejected_steps = 0;
  std::int64_t impacts = 0;
  double wall_time = std::numeric_limits<double>::quiet_NaN();  // s, median of the repeats
  double wall_least = std::numeric_limits<double>::quiet_NaN();
  double wall_most = std::numeric_limits<double>::quiet_NaN();
  std::string status = "ok";

  // s or m, see error_parameter(); nothing if the method has neither.
  [[nodiscard]] std::optional<double> step_or_tolerance() const;
};

// Data common to all rows of a study.
struct StudyFacts {
  std::string preset;  // its name
  std::string title;
  double time = 0.0;                      // s: the compared time
  double duration = 0.0;                  // s: of the intended run
  std::string reference;                  // in words
  double reference_position_error = 0.0;  // m
  double reference_velocity_error = 0.0;  // m/s
  double reference_angle_error = 0.0;     // m: as in Comparison
  double reference_spin_error = 0.0;      // m/s: as in Comparison
  double reference_energy_error = 0.0;    // J
  std::string stated;                     // the file's own figures against the reference, in words
  double length = 0.0;                    // m: as in Chaos
  double arc = 0.0;                       // m: as in Chaos, or the length if that is larger
  double exponent = 0.0;                  // 1/s: as in Chaos
  double growth = 1.0;                    // of a neighbour's distance up to the compared time, dimensionless
  double horizon = std::numeric_limits<double>::infinity();  // s: as in Chaos
  std::string remarks;  // why the compared time is not the end of the run; warnings
  int repeats = 0;      // of the timing

  // m: rounding at the start, grown until the compared time, in positions and in angles.
  [[nodiscard]] double rounding_floor() const;
  [[nodiscard]] double angle_floor() const;
  // m: a larger error, a tenth of the length, only says that the run is wrong.
  [[nodiscard]] double largest_error() const { return 0.1 * length; }
  [[nodiscard]] double largest_angle_error() const { return 0.1 * arc; }
};

struct StudyTable {
  StudyFacts facts;
  std::vector<StudyRow> rows;  // by index
};

// The rows of one method at its steps, coarsest first, and their fitted orders.
struct StudyGroup {
  IntegratorId integrator = IntegratorId::kRk4;
  ImpactsId impacts = ImpactsId::kLocated;
  ContactsId contacts = ContactsId::kImpulse;
  std::vector<StudyRow> rows;
  OrderFit fit;        // in position
  OrderFit angle_fit;  // in angle

  // The verdict on the method: its order in position, or in angle where positions are exact and angles are not.
  [[nodiscard]] bool is_of_angle() const {
    return fit.kind == OrderFit::Kind::kExact && angle_fit.kind != OrderFit::Kind::kExact;
  }
  [[nodiscard]] const OrderFit& verdict() const { return is_of_angle() ? angle_fit : fit; }
};

// In the order of the plan, with their fitted orders; a row with impacts that have no partner in the reference
// does not count there.
[[nodiscard]] std::vector<StudyGroup> groups_of(const StudyTable& table);

// CSV, RFC 4180, line by line: a header with units in brackets, then a line for each row, all digits of every
// number, an empty field for none. The orders are in every row of their method.
[[nodiscard]] std::vector<std::string> study_csv(const StudyTable& table);

// Sentences about a study without a full stop, for the terminal and the picture.

// The compared time and the intended length of the run.
[[nodiscard]] std::string compared_text(const StudyFacts& facts);
// The reference, its own error, and the file's figures.
[[nodiscard]] std::string reference_text(const StudyFacts& facts);
// How fast neighbours separate, and until when a comparison is meaningful.
[[nodiscard]] std::string horizon_text(const StudyFacts& facts);

// The whole study as a table for each method, then the orders.
[[nodiscard]] std::string study_text(const StudyTable& table);

}  // namespace carom
