#pragma once

#include <QString>

#include "physics/observe/observables.h"

namespace carom {

// The unit in which a plot and its tables show values; curves, notes, marks and the data of runs keep SI.
struct ShownUnit {
  QString name{};   // empty: dimensionless
  double si = 1.0;  // SI units in one

  [[nodiscard]] double of(double value) const { return value / si; }  // of one in SI
  // Behind the text of a value: "2.5 m", "45°".
  [[nodiscard]] QString after(const QString& text) const;
  // Behind a name: "speed / m/s".
  [[nodiscard]] QString behind(const QString& label) const;
};

// The unit as plots write it, N·s for N s; the same in which fields show the quantity: degrees for an angle.
[[nodiscard]] ShownUnit shown_unit(const Observable& observable);
// SI.
[[nodiscard]] ShownUnit si_unit(const Observable& observable);

}  // namespace carom
