#pragma once

#include <QString>
#include <string_view>
#include <vector>

#include "physics/scene/method.h"

namespace carom {

// A UTF-8 text of the tables: names, labels, units.
[[nodiscard]] inline QString text_of(std::string_view s) {
  return QString::fromUtf8(s.data(), static_cast<qsizetype>(s.size()));
}

// The shortest distinct name of each of these methods, its integrator and whatever else differs: "RK4", or
// "RK4, step end, 5 ms".
[[nodiscard]] std::vector<QString> names_of(const std::vector<Method>& methods);

// The complete method in one line.
[[nodiscard]] QString description_of(const Method& method);

}  // namespace carom
